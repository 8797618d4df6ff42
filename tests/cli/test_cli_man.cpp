// SPDX-License-Identifier: MIT
// The manual pages say what --help says, of every command, in troff that groff takes without a warning.
#include <catch2/catch.hpp>
#include <filesystem>
#include <regex>
#include <set>

#include "app/cli/man_page.h"
#include "tests/cli/program.h"

namespace pabd::test_cli_man {

using namespace test;
using cli::troff;
namespace fs = std::filesystem;

namespace {

// Matches of the first group of `pattern`.
std::set<std::string> found(const std::string& text, const char* pattern) {
  std::set<std::string> out;
  const std::regex regex(pattern);
  for (std::sregex_iterator at(text.begin(), text.end(), regex), end; at != end; ++at) out.insert((*at)[1]);
  return out;
}

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

TEST_CASE("troff reads text as text") {
  CHECK(troff("plain words") == "plain words");
  CHECK(troff(".so") == "\\&.so");
  CHECK(troff("'quoted' a\\b") == "\\&\\(aqquoted\\(aq a\\eb");
  CHECK(troff("--set") == "\\-\\-set");
  CHECK(troff("1 … 7, d\u0302, κ") == "1 \\[u2026] 7, d\\[u0302], \\[u03BA]");
}

TEST_CASE("every command has its page, with what its help says, and groff takes it") {
  const CommandFolder folder;
  REQUIRE(run_pabd({"man", folder.path().string()}).exit_code == 0);
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
    const std::string help = run_pabd(line).out;
    const std::string page = read_text(file);

    // The same options in both.
    CHECK(found(help, "(?:^|\n)  (?:-\\w, )?(--[\\w-]+)") ==
          found(std::regex_replace(page, std::regex("\\\\-"), "-"), "\\\\fB(--[\\w-]+)\\\\fR"));

    // As it is read: no warning, and every line of the help's examples and descriptions in it.
    const Outcome read = run_shell("groff -man -ww -Tutf8 -P-cbou -rLL=300n '" + file + "'");
    REQUIRE(read.exit_code == 0);
    CHECK(read.err == "");
    const std::string text = dense(read.out);
    const std::string description = help.substr(0, help.find("\n\n"));
    CHECK(text.find(dense(description)) != std::string::npos);
    for (const std::string& shown : lines_of(help)) {
      if (shown.starts_with("  pabd ")) {
        CAPTURE(shown);
        CHECK(text.find(dense(shown)) != std::string::npos);
      }
    }
  }
}

TEST_CASE("the command that writes the manual is not in the help") {
  CHECK(run_pabd({"--help"}).out.find("\n  man") == std::string::npos);
  CHECK(run_pabd({"mann"}).err.find("did you mean") == std::string::npos);
}

}  // namespace pabd::test_cli_man
