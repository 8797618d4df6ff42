// SPDX-License-Identifier: MIT
// What the README and the reference of the commands tell a newcomer to type is typed here, line by line, in an empty folder.
#include <catch2/catch.hpp>
#include <filesystem>
#include <regex>
#include <set>

#include "tests/cli/program.h"
#include "tests/support/places.h"

namespace pabd::test_cli_readme {

using namespace test;
namespace fs = std::filesystem;

namespace {

const fs::path kSource = fs::path(places::scenes()).parent_path().parent_path();
constexpr const char* kExport = R"(export PATH="$PWD/build/release/app/cli:$PATH")";

// The lines that are set apart by four blanks, outside of fences.
std::vector<std::string> set_apart(const std::string& text) {
  std::vector<std::string> out;
  bool fenced = false;
  for (const std::string& line : lines_of(text)) {
    if (line.starts_with("```")) fenced = !fenced;
    if (!fenced && line.starts_with("    ")) out.push_back(line.substr(4));
  }
  return out;
}

std::string replaced(const std::string& text, const char* pattern, const char* by) {
  return std::regex_replace(text, std::regex(pattern), by);
}

// The same command with less work: fewer and smaller frames, fewer steps and iterations, no window.
std::string shortened(std::string line) {
  line = replaced(line, "640x360", "64x36");
  if (line.find("pabd render") != line.npos) {
    line = replaced(line, " --(time|frames) [0-9.]+", "");
    const bool sized = line.find("--size") != line.npos;
    return replaced(line, "pabd render",
                    sized ? "pabd render --frames 2" : "pabd render --frames 2 --size 64x36");
  }
  if (line.starts_with("pabd export")) return replaced(line, " --time [0-9.]+", "") + " --frames 2";
  if (line.starts_with("pabd run")) return replaced(line, " --(time|steps) [0-9.]+", "") + " --steps 2";
  if (line.starts_with("pabd plot convergence"))
    return replaced(line, " --at-step [0-9]+", " --at-step 2") + " --iterations 5";
  if (line.starts_with("pabd plot")) return replaced(line, " --time [0-9.]+", " --time 0.05");
  if (line.starts_with("pabd serve")) return line + " --help";  // it waits for visitors
  // Without a display a script does what a hand would: here nothing.
  if (line.starts_with("pabd view") && line.find("--script") == line.npos)
    return line + " --headless --script nothing.json";
  return line;
}

}  // namespace

TEST_CASE("every line of the reference runs as it stands, one after the other, in an empty folder") {
  const CommandFolder folder;
  write_text(folder / "nothing.json", R"([{"do": "pause"}])");
  Setting setting;
  setting.folder = folder.path();
  bool found = false;
  int ran = 0;
  const std::string all = read_text(kSource / "README.md") + read_text(kSource / "app/cli/README.md");
  for (const std::string& line : set_apart(all)) {
    CAPTURE(line);
    const std::string word = line.substr(0, line.find(' '));
    if (line.find("→") != line.npos || line.find(" = ") != line.npos) continue;  // a drawing, an equation
    if (word.starts_with("scripts/")) {                                          // builds, and runs this test
      const auto mode = fs::status(kSource / word).permissions();
      CHECK((mode & fs::perms::owner_exec) != fs::perms::none);
      continue;
    }
    if (word == "export") {
      // The program lies in this build's folder as it does in that of the preset "release".
      CHECK(line == kExport);
      const fs::path program = places::program();
      CHECK(program.parent_path().parent_path().filename() == "app");
      setting.environment["PATH"] = program.parent_path().string() + ":" + std::getenv("PATH");
      found = true;
      continue;
    }
    REQUIRE(found);
    const std::string command = shortened(line);
    CAPTURE(command);
    const Outcome outcome = run_shell(command, setting);
    CAPTURE(outcome.err);
    CHECK(outcome.exit_code == 0);
    const std::regex output(R"( (-o|--out|--trace|--state|--iterations|--diff|--json) '?([^ ']+))");
    for (std::sregex_iterator at(line.begin(), line.end(), output), end; at != end; ++at) {
      const std::string name = replaced((*at)[2], R"(\{frame:04\}|%04d)", "0001");
      CAPTURE(name);
      CHECK((name == "-" || fs::exists(folder / name)));
    }
    ++ran;
  }
  CHECK(ran > 25);
}

TEST_CASE("the reference shows every command that the help lists, and only such") {
  const std::string reference = read_text(kSource / "app/cli/README.md");
  std::set<std::string> shown, listed;
  const std::regex line("\n    pabd (\\w+)");
  for (std::sregex_iterator at(reference.begin(), reference.end(), line), end; at != end; ++at)
    shown.insert((*at)[1]);
  const std::string help = run_pabd({"--help"}).out;
  const std::string list =
      help.substr(help.find("\nCommands:"), help.find("\nGeneral:") - help.find("\nCommands:"));
  const std::regex entry("\n  (\\w+) ");
  for (std::sregex_iterator at(list.begin(), list.end(), entry), end; at != end; ++at)
    listed.insert((*at)[1]);
  CHECK(listed.size() > 8);
  CHECK(shown == listed);
}

TEST_CASE("the READMEs know every shipped scene, and how many there are") {
  const std::string readme = read_text(kSource / "README.md");
  for (const auto& entry : fs::directory_iterator(places::scenes()))
    CHECK(read_text(kSource / "assets/README.md").find("`" + entry.path().stem().string() + "`") !=
          std::string::npos);
  const auto scenes = std::distance(fs::directory_iterator(places::scenes()), fs::directory_iterator());
  CHECK(readme.find("each of the " + std::to_string(scenes) + " shipped scenes") != std::string::npos);
}

}  // namespace pabd::test_cli_readme
