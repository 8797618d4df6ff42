// SPDX-License-Identifier: MIT
// Published numbers: every row passes, and a row can fail.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "app/validate/crossings.h"
#include "app/validate/validate.h"
#include "tests/support/errors.h"
#include "tests/support/files.h"
#include "tests/support/places.h"

namespace pabd::test_validate {

using namespace validate;

namespace {

std::vector<Row> run(const std::vector<std::string>& words, int threads = 2) {
  return run_cases(chosen_cases(words), threads, {}, {});
}

}  // namespace

TEST_CASE("this program gives every published number to within its tolerance") {
  const std::vector<Row> rows = run({});
  REQUIRE(rows.size() > 80);
  for (const Row& row : rows) {
    CAPTURE(row.of->key, row.h, row.of->published, row.outcome.value, row.failure);
    CHECK(row.passes());
  }
}

TEST_CASE("keys are unique, sources are named, and tolerances never grow as steps shrink") {
  std::set<std::string> keys;
  for (const Case& one : all_cases()) {
    CAPTURE(one.key);
    CHECK(keys.insert(one.key).second);
    CHECK_FALSE(one.source.empty());
    CHECK_FALSE(one.what.empty());
    REQUIRE_FALSE(one.steps.empty());
    for (std::size_t k = 1; k < one.steps.size(); ++k) {
      CHECK(one.steps[k].h < one.steps[k - 1].h);
      CHECK(one.steps[k].margin <= one.steps[k - 1].margin);
    }
  }
}

TEST_CASE("sim/accuracy.md has every case (scripts/accuracy writes it)") {
  const std::string page = read_bytes(places::project() + "/sim/accuracy.md");
  for (const Case& one : all_cases()) {
    CAPTURE(one.key);
    CHECK(page.find("| " + one.what + " (" + one.source + ") |") != std::string::npos);
  }
}

TEST_CASE("rows are the same on any number of threads") {
  const std::vector<Row> one = run({"pendulum", "gap"}, 1), four = run({"pendulum", "gap"}, 4);
  REQUIRE(one.size() == four.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    CHECK(one[k].outcome.value == four[k].outcome.value);
    CHECK(one[k].outcome.ours == four[k].outcome.ours);
  }
}

TEST_CASE("a number that is off, none at all and a run that fails do not pass, and the table says so") {
  Case wrong = *chosen_cases({"gap-3"}).front();
  wrong.published += 1;
  Case none = wrong;
  none.key = "none";
  none.measure = [](Bench&) { return Outcome{std::nan(""), {}, {}, {}}; };
  Case fails = wrong;
  fails.key = "fails";
  fails.measure = [](Bench& bench) {
    bench.run(1);
    return Outcome{double(bench.body("nobody")), {}, {}, {}};
  };
  const std::vector<Row> rows = run_cases({&wrong, &none, &fails}, 1, {}, {});
  REQUIRE(rows.size() == 6);
  for (const Row& row : rows) CHECK_FALSE(row.passes());
  CHECK_FALSE(rows.back().failure.empty());
  CHECK(table_of(rows).find("0 of 6 rows pass") != std::string::npos);
  CHECK(markdown_of(rows).find("**fails**") != std::string::npos);
  CHECK(json_of(rows)[4]["failure"].get<std::string>() == rows[4].failure);
  CHECK(json_of(rows)[0]["passes"] == false);
}

TEST_CASE("a run that is asked to stop gives no rows") {
  CHECK(run_cases(chosen_cases({}), 2, [] { return true; }, {}).empty());
}

TEST_CASE("figures have a curve a step, and the published one") {
  const std::vector<Row> rows = run({"bead"});
  const Figure figure = figure_of(*rows.front().of, rows);
  REQUIRE(figure.plots.size() == 1);
  CHECK(figure.plots[0].series.size() == 4);
  CHECK(figure.plots[0].series.back().name == "published");
  const std::vector<Row> plain = run({"gap-3"});
  CHECK(figure_of(*plain.front().of, plain).plots.empty());
}

TEST_CASE("a word that no key has is refused") {
  const Caught error = caught([] { chosen_cases({"pendulum", "perpetuum"}); });
  CHECK(error.kind == ErrorKind::bad_input);
  CHECK(error.says("perpetuum"));
}

TEST_CASE("crossings are found between steps, where a quantity rises") {
  Crossings crossings;
  for (int k = 0; k <= 40; ++k) crossings.see(0.1 * k, std::sin(2 * kPi * (0.1 * k - 0.25)));
  REQUIRE(crossings.at().size() == 4);
  CHECK(crossings.at().front() == Approx(0.25).margin(0.01));
  CHECK(crossings.period() == Approx(1).margin(1e-9));
}

}  // namespace pabd::test_validate
