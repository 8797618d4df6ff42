// SPDX-License-Identifier: MIT
// Tab completion, asked of the shells themselves.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <set>

#include "tests/cli/program.h"
#include "tests/support/places.h"

namespace pabd::test_cli_completion {

using namespace test;

namespace {

const std::string kScripts = places::project() + "/app/cli/completion/";

Setting with_program(const CommandFolder& folder) {
  Setting setting;
  setting.folder = folder.path();
  const std::string own = std::filesystem::path(places::program()).parent_path().string();
  setting.environment = {{"PATH", own + ":" + std::getenv("PATH")}, {"HOME", folder.path().string()}};
  return setting;
}

// What bash offers for a line; its last word is being typed.
std::vector<std::string> bash_offers(const CommandFolder& folder, const std::string& words) {
  const std::string script =
      "source '" + kScripts + "pabd'; COMP_WORDS=(" + words +
      "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _pabd; printf '%s\\n' \"${COMPREPLY[@]}\"";
  write_text(folder / "ask.bash", script);
  const Outcome outcome = run_command({"bash", folder / "ask.bash"}, with_program(folder));
  CAPTURE(words, outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  auto lines = lines_of(outcome.out);
  std::erase(lines, "");
  std::sort(lines.begin(), lines.end());
  return lines;
}

std::vector<std::string> fish_offers(const CommandFolder& folder, const std::string& line) {
  write_text(folder / "ask.fish", "source '" + kScripts + "pabd.fish'\ncomplete -C '" + line + "'\n");
  const Outcome outcome = run_command({"fish", "--no-config", folder / "ask.fish"}, with_program(folder));
  CAPTURE(line, outcome.err);
  REQUIRE(outcome.exit_code == 0);
  std::vector<std::string> words;
  for (const std::string& each : lines_of(outcome.out)) words.push_back(each.substr(0, each.find('\t')));
  std::erase(words, "");
  std::sort(words.begin(), words.end());
  return words;
}

// zsh completes for an eye: what it shows after `line` and the tabulator, until `wanted` is there; empty: never.
std::string zsh_shows(const CommandFolder& folder, const std::string& line, const std::string& wanted) {
  write_text(folder / "ask.zsh",
             "zmodload zsh/zpty\nzpty -b z zsh -f -i\n"
             "zpty -w z 'PS1=; LISTMAX=1000; fpath=(" +
                 kScripts +
                 " $fpath)'\n"
                 "zpty -w z 'autoload -Uz compinit && compinit -u -D && print re''ady'\n"
                 "zpty -r z out '*ready*'\n"
                 "zpty -w -n z $'" +
                 line +
                 "\\t'\n"
                 "zpty -r z out $'*" +
                 wanted + "*'\nprint -r -- $out\nzpty -d z\n");
  return run_command({"timeout", "20", "zsh", "-f", folder / "ask.zsh"}, with_program(folder)).out;
}

std::vector<std::string> options_in_help(const std::vector<std::string>& command) {
  std::vector<std::string> line = command;
  line.push_back("--help");
  std::vector<std::string> out;
  for (std::string row : lines_of(run_pabd(line).out)) {
    if (!row.starts_with("  -")) continue;
    std::size_t at = 2;
    while (at < row.size() && row[at] == '-') {
      const std::size_t end = std::min(row.find_first_of(" ,", at), row.size());
      out.push_back(row.substr(at, end - at));
      if (end >= row.size() || row[end] != ',') break;
      at = end + 2;
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

TEST_CASE("bash offers every command, and every option that the help of a command has") {
  const CommandFolder folder;
  const auto commands = bash_offers(folder, "pabd ''");
  for (const char* name :
       {"render", "export", "run", "plot", "figure", "compare", "scenes", "bench", "doctor", "view", "serve"})
    CHECK(std::count(commands.begin(), commands.end(), name) == 1);
  CHECK(std::count(commands.begin(), commands.end(), "man") == 0);
  CHECK(bash_offers(folder, "pabd help re") == bash_offers(folder, "pabd re"));
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"render"},
                                             {"export"},
                                             {"run"},
                                             {"view"},
                                             {"serve"},
                                             {"bench"},
                                             {"compare"},
                                             {"figure"},
                                             {"sweep"},
                                             {"sweep", "collect"},
                                             {"plot", "barrier"},
                                             {"plot", "convergence"},
                                             {"plot", "reactions"},
                                             {"plot", "series"}}) {
    std::string words = "pabd ";
    for (const std::string& word : command) words += word + " ";
    CAPTURE(words);
    const auto expected = options_in_help(command);
    REQUIRE(expected.size() > 4);
    CHECK(bash_offers(folder, words + "-") == expected);
  }
}

TEST_CASE("bash offers words, lists, scenes and parameters where they belong") {
  const CommandFolder folder;
  write_text(folder / "own.json", "{}");
  using Words = std::vector<std::string>;
  CHECK(bash_offers(folder, "pabd render --quality ''") == Words{"best", "draft", "good"});
  CHECK(bash_offers(folder, "pabd export --quality d") == Words{"draft"});
  CHECK(bash_offers(folder, "pabd run --device ''") == Words{"auto", "cpu", "gpu"});
  CHECK(bash_offers(folder, "pabd render --preset very") == Words{"veryfast", "veryslow"});
  CHECK(bash_offers(folder, "pabd render --set contact.kap") == Words{"contact.kappa="});
  CHECK(bash_offers(folder, "pabd render --overlay params,ser") == Words{"params,series"});
  CHECK(bash_offers(folder, "pabd plot b") == Words{"barrier"});
  CHECK(bash_offers(folder, "pabd run two_") == Words{"two_boxes"});
  CHECK(bash_offers(folder, "pabd run ow") == Words{"own.json"});
  CHECK(bash_offers(folder, "pabd run stack --steps ''").empty());
  // A robot is a scene, too.
  write_text(folder / "robot.urdf", "");
  CHECK(bash_offers(folder, "pabd run robo") == Words{"robot.urdf"});
  CHECK(bash_offers(folder, "pabd import robo") == Words{"robot.urdf"});
  // A command with an argument and a command below it.
  CHECK(bash_offers(folder, "pabd sweep c") == Words{"collect"});
  CHECK(bash_offers(folder, "pabd sweep ow") == Words{"own.json"});
  CHECK(bash_offers(folder, "pabd sweep own.json --emit s") == Words{"slurm", "snakemake"});
  const auto scenes = bash_offers(folder, "pabd view ''");
  for (const char* name : {"pyramid", "two_boxes"})
    CHECK(std::count(scenes.begin(), scenes.end(), name) == 1);
}

TEST_CASE("fish offers the same") {
  const CommandFolder folder;
  using Words = std::vector<std::string>;
  const auto commands = fish_offers(folder, "pabd ");
  CHECK(std::count(commands.begin(), commands.end(), "render") == 1);
  CHECK(fish_offers(folder, "pabd render --qu") == Words{"--quality", "--quiet"});
  CHECK(fish_offers(folder, "pabd render --quality ") == Words{"best", "draft", "good"});
  CHECK(fish_offers(folder, "pabd plot con") == Words{"convergence"});
  CHECK(fish_offers(folder, "pabd render --overlay params,ser") == Words{"params,series"});
  CHECK(fish_offers(folder, "pabd run two_b") == Words{"two_boxes"});
  CHECK(fish_offers(folder, "pabd scenes --crf").empty());
  write_text(folder / "own.json", "{}");
  write_text(folder / "robot.urdf", "");
  std::filesystem::create_directory(folder / "out");
  CHECK(fish_offers(folder, "pabd sweep coll") == Words{"collect"});
  CHECK(fish_offers(folder, "pabd sweep ow") == Words{"own.json"});
  CHECK(fish_offers(folder, "pabd sweep own.json --emit s") == Words{"slurm", "snakemake"});
  CHECK(fish_offers(folder, "pabd sweep own.json --out o") == Words{"out/"});
  CHECK(fish_offers(folder, "pabd sweep collect o") == Words{"out/"});
  CHECK(fish_offers(folder, "pabd run robo") == Words{"robot.urdf"});
  CHECK(fish_offers(folder, "pabd import robo") == Words{"robot.urdf"});
  for (const Words& command : std::vector<Words>{{"run"}, {"view"}, {"sweep"}, {"sweep", "collect"}}) {
    Words expected = options_in_help(command);
    std::erase_if(expected, [](const std::string& name) { return !name.starts_with("--"); });
    std::string line = "pabd ";
    for (const std::string& word : command) line += word + " ";
    CAPTURE(line);
    CHECK(fish_offers(folder, line + "--") == expected);
  }
}

TEST_CASE("zsh offers the same") {
  const CommandFolder folder;
  CHECK(zsh_shows(folder, "pabd comp", "compare").find("compare") != std::string::npos);
  CHECK(zsh_shows(folder, "pabd render --quali", "--quality").find("--quality") != std::string::npos);
  CHECK(zsh_shows(folder, "pabd render --quality dr", "draft").find("draft") != std::string::npos);
  CHECK(zsh_shows(folder, "pabd run two_b", "two_boxes").find("two_boxes") != std::string::npos);
  write_text(folder / "own.json", "{}");
  CHECK(zsh_shows(folder, "pabd sweep coll", "collect").find("collect") != std::string::npos);
  CHECK(zsh_shows(folder, "pabd sweep ow", "own.json").find("own.json") != std::string::npos);
  write_text(folder / "robot.urdf", "");
  CHECK(zsh_shows(folder, "pabd run robo", "robot.urdf").find("robot.urdf") != std::string::npos);
  CHECK(zsh_shows(folder, "pabd sweep own.json --emi", "--emit").find("--emit") != std::string::npos);
  CHECK(zsh_shows(folder, "pabd render --set contact.kapp", "contact.kappa=").find("kappa=") !=
        std::string::npos);
}

TEST_CASE("what the scripts ask is not in the help, and answers a line a word") {
  CHECK(run_pabd({"--complete", "plot", "b"}).out.starts_with("barrier\t"));
  CHECK(run_pabd({"--complete", "run", "stack", "--device", "g"}).out == "gpu\n");
  CHECK(run_pabd({"--complete"}).out.empty());
  CHECK(run_pabd({"--help"}).out.find("complete") == std::string::npos);
}

}  // namespace pabd::test_cli_completion
