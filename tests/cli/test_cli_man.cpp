// SPDX-License-Identifier: MIT
// The manual pages say what --help says, of every command, in troff that groff takes without a warning.
#include <catch2/catch.hpp>
#include <filesystem>
#include <regex>

#include "tests/cli/program.h"

namespace pabd::test_cli_man {

using namespace test;
namespace fs = std::filesystem;

namespace {

// The commands that a help text lists: lines of two blanks between "Commands:" and an empty line.
std::vector<std::string> listed_commands(const std::string& help) {
  std::vector<std::string> out;
  bool in_list = false;
  for (const std::string& line : lines_of(help)) {
    if (line.starts_with("Commands:"))
      in_list = true;
    else if (line.empty())
      in_list = false;
    else if (in_list && line.starts_with("  ") && line[2] != ' ')
      out.push_back(line.substr(2, line.find(' ', 2) - 2));
  }
  return out;
}

// Every command by its words, the program first.
void add_commands(const std::vector<std::string>& words, std::vector<std::vector<std::string>>& out) {
  out.push_back(words);
  std::vector<std::string> line = words;
  line.push_back("--help");
  for (const std::string& name : listed_commands(run_pabd(line).out)) {
    std::vector<std::string> longer = words;
    longer.push_back(name);
    add_commands(longer, out);
  }
}

// Without blanks, which both fill lines with.
std::string dense(const std::string& text) { return std::regex_replace(text, std::regex("\\s+"), ""); }

}  // namespace

TEST_CASE("every command has its page, with what its help says, and groff takes it") {
  const CommandFolder folder;
  REQUIRE(run_pabd({"--manual", folder.path().string()}).exit_code == 0);
  std::vector<std::vector<std::string>> commands;
  add_commands({}, commands);
  REQUIRE(commands.size() > 10);
  std::size_t pages = 0;
  for (const auto& entry : fs::directory_iterator(folder.path())) pages += entry.path().extension() == ".1";
  CHECK(pages == commands.size());

  for (const std::vector<std::string>& words : commands) {
    std::string name = "pabd";
    for (const std::string& word : words) name += "-" + word;
    CAPTURE(name);
    const std::string file = folder / (name + ".1");
    REQUIRE(fs::exists(file));
    std::vector<std::string> line = words;
    line.push_back("--help");
    Setting setting;
    setting.environment = {{"COLUMNS", "78"}};
    const std::string help = run_pabd(line, setting).out;
    // As it is read: no warning, and every word of the help.
    const Outcome read = run_shell("groff -k -man -ww -Tutf8 -P-cbou -rLL=300n '" + file + "'");
    REQUIRE(read.exit_code == 0);
    CHECK(read.err == "");
    CHECK(dense(read.out).find(dense(help)) != std::string::npos);
  }
}

TEST_CASE("what writes the manual is not in the help") {
  CHECK(run_pabd({"--help"}).out.find("manual") == std::string::npos);
}

}  // namespace pabd::test_cli_man
