// SPDX-License-Identifier: MIT
// How help reads: wrapped at the width of the terminal, in groups, without the words of a parser.
#include <catch2/catch.hpp>

#include "app/cli/help_text.h"
#include "sim/base/counted.h"
#include "tests/cli/program.h"

namespace pabd::test_cli_help {

using namespace test;
using cli::wrap;
using pabd::counted;

namespace {

const std::vector<std::vector<std::string>> kCommands = {{},
                                                         {"run"},
                                                         {"render"},
                                                         {"export"},
                                                         {"plot"},
                                                         {"plot", "barrier"},
                                                         {"plot", "convergence"},
                                                         {"plot", "reactions"},
                                                         {"plot", "series"},
                                                         {"figure"},
                                                         {"compare"},
                                                         {"sweep"},
                                                         {"sweep", "collect"},
                                                         {"import"},
                                                         {"scenes"},
                                                         {"doctor"},
                                                         {"view"},
                                                         {"serve"},
                                                         {"bench"}};

std::string help_of(std::vector<std::string> command, int columns) {
  command.push_back("--help");
  Setting setting;
  setting.environment = {{"COLUMNS", std::to_string(columns)}};
  const Outcome help = run_pabd(command, setting);
  REQUIRE(help.exit_code == 0);
  return help.out;
}

// Characters; what stands over another has no column of its own.
int width_of(const std::string& line) {
  int n = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const auto c = static_cast<unsigned char>(line[i]);
    if ((c & 0xC0) != 0x80 && c != 0xCC) ++n;
  }
  return n;
}

}  // namespace

TEST_CASE("'pabd help COMMAND' is 'pabd COMMAND --help'") {
  CHECK(run_pabd({"help"}).out == run_pabd({"--help"}).out);
  CHECK(run_pabd({"help", "render"}).out == run_pabd({"render", "--help"}).out);
  CHECK(run_pabd({"help", "plot", "barrier"}).out == run_pabd({"plot", "barrier", "--help"}).out);
  const Outcome wrong = run_pabd({"help", "rendr"});
  CHECK(wrong.exit_code == 2);
  CHECK(wrong.err.find("rendr: no such command; did you mean \"render\"?") != std::string::npos);
}

TEST_CASE("text is wrapped at blanks, and what follows is set in") {
  CHECK(wrap("one two three", 7, 2) == "one two\n  three");
  CHECK(wrap("one two three", 13, 2) == "one two three");
  CHECK(wrap("one two three", 12, 0) == "one two\nthree");
  CHECK(wrap("a word_that_is_wider b", 5, 1) == "a\n word_that_is_wider\n b");
  CHECK(wrap("κ d\u0302 N", 5, 0) == "κ d\u0302 N");  // five columns
  CHECK(wrap("", 10, 3).empty());
}

TEST_CASE("help is as wide as the terminal, and no wider") {
  for (const auto& command : kCommands) {
    CAPTURE(command);
    std::size_t lines_before = 0;
    for (const int columns : {120, 80, 60}) {
      CAPTURE(columns);
      const std::string help = help_of(command, columns);
      int checked = 0;
      for (const std::string& line : lines_of(help)) {
        if (line.starts_with("  pabd ")) continue;  // examples are copied
        CAPTURE(line);
        CHECK(width_of(line) <= columns);
        ++checked;
      }
      CHECK(checked > 3);
      CHECK(line_count(help) >= lines_before);
      lines_before = line_count(help);
    }
  }
  CHECK(line_count(help_of({"render"}, 60)) > line_count(help_of({"render"}, 120)));
  CHECK(help_of({"run"}, 1000) == help_of({"run"}, 120));
  CHECK(help_of({"run"}, 3) == help_of({"run"}, 40));
}

TEST_CASE("help names what options take, and speaks of no types of a parser") {
  for (const auto& command : kCommands) {
    const std::string help = help_of(command, 120);
    CAPTURE(help);
    for (const char* jargon :
         {"INT", "FLOAT", "TEXT", "UINT", "REQUIRED", "Excludes", "Needs:", "Positionals", "{auto,"})
      CHECK(help.find(jargon) == std::string::npos);
  }
  const std::string help = help_of({"render"}, 120);
  CHECK(help.find("not with --time") != std::string::npos);
  CHECK(help.find("only with --ab") != std::string::npos);
  CHECK(help.find("Usage: pabd render [OPTIONS] -o OUT SCENE\n") != std::string::npos);
  CHECK(help_of({"plot"}, 120).find("Usage: pabd plot [OPTIONS] COMMAND\n") != std::string::npos);
  CHECK(help_of({"serve"}, 120).find("--host NAME[:PORT] ") != std::string::npos);
  CHECK(help_of({"sweep"}, 120).find("Usage: pabd sweep [OPTIONS] PLAN\n       pabd sweep COMMAND\n") !=
        std::string::npos);
}

TEST_CASE("options stand in groups, the same ones last everywhere") {
  const std::string help = help_of({"render"}, 100);
  std::size_t before = 0;
  for (const char* title : {"\nArguments:\n", "\nOutput:\n", "\nPicture:\n", "\nVideo:\n", "\nSimulation:\n",
                            "\nGeneral:\n", "\nExamples:\n"}) {
    CAPTURE(title);
    const auto at = help.find(title);
    REQUIRE(at != std::string::npos);
    CHECK(at > before);
    before = at;
  }
  CHECK(help.find("\nOptions:\n") == std::string::npos);
  const auto general = help.find("\nGeneral:\n");
  for (const char* option : {"  -h, --help ", "  --quiet ", "  --version "})
    CHECK(help.find(option) > general);
  const auto video = help.find("\nVideo:\n");
  CHECK(help.find("  --crf N") > video);
  CHECK(help.find("  --crf N") < help.find("\nSimulation:\n"));
}

TEST_CASE("one of something is one") {
  CHECK(counted(1, "frame") == "1 frame");
  CHECK(counted(0, "frame") == "0 frames");
  CHECK(counted(std::size_t{2}, "body", "bodies") == "2 bodies");
  CHECK(counted(1, "body", "bodies") == "1 body");
  const Outcome one = run_pabd({"run", "stack", "--steps", "1"});
  CHECK(one.err.starts_with("1 step to t = "));
  CHECK(run_pabd({"run", "stack", "--steps", "2"}).err.starts_with("2 steps to t = "));
}

}  // namespace pabd::test_cli_help
