// SPDX-License-Identifier: MIT
// pabd validate: its table, JSON and figures, and what it refuses.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/program.h"
#include "tests/support/files.h"

namespace pabd::test_cli_validate {

using namespace test;
using nlohmann::json;

TEST_CASE("validate --list names the cases and runs none") {
  const Outcome list = run_pabd({"validate", "--list"});
  REQUIRE(list.exit_code == 0);
  for (const char* word : {"andrews", "arch", "stick-slip"}) CHECK(list.out.find(word) != std::string::npos);
  CHECK(list.out.find("passes") == std::string::npos);
}

TEST_CASE("validate writes its rows as a table, as Markdown and as JSON") {
  const Outcome table = run_pabd({"validate", "--only", "gap-3", "--quiet"});
  REQUIRE(table.exit_code == 0);
  CHECK(table.out.find("2 of 2 rows pass") != std::string::npos);
  const Outcome markdown = run_pabd({"validate", "--only", "gap-3", "--quiet", "--markdown"});
  CHECK(markdown.out.starts_with("| what | published |"));
  const Outcome text = run_pabd({"validate", "--only", "gap-3", "--quiet", "--json", "-"});
  REQUIRE(text.exit_code == 0);
  const json rows = json::parse(text.out);
  REQUIRE(rows.size() == 2);
  CHECK(rows[0]["key"] == "gap-3");
  CHECK(rows[0]["passes"] == true);
  CHECK(rows[0]["value"].get<double>() == Approx(rows[0]["published"].get<double>()).margin(0.001));
}

TEST_CASE("validate writes a figure a case, and replaces none unasked") {
  const CommandFolder folder;
  const std::vector<std::string> command = {"validate", "--only",    "bead-on-rod",
                                            "--quiet",  "--figures", folder / "figures"};
  REQUIRE(run_pabd(command).exit_code == 0);
  const std::string picture = read_text(folder / "figures/bead-on-rod.svg");
  CHECK(picture.find("<svg") != std::string::npos);
  CHECK(picture.find("published") != std::string::npos);
  const Outcome again = run_pabd(command);
  CHECK(again.exit_code == 2);
  CHECK(is_error_line(again.err, {"bead-on-rod.svg", "--force"}));
}

TEST_CASE("validate refuses a word that no key has") {
  const Outcome wrong = run_pabd({"validate", "--only", "perpetuum"});
  CHECK(wrong.exit_code == 2);
  CHECK(is_error_line(wrong.err, {"perpetuum", "--list"}));
}

}  // namespace pabd::test_cli_validate
