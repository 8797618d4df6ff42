// SPDX-License-Identifier: MIT
// What a command tells of a run that went on all the same, and that what it advises helps.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/program.h"

namespace pabd::test_cli_notes {

using namespace test;

namespace {

// The lines "pabd: note: …", without that.
std::vector<std::string> notes_of(const std::string& err) {
  const std::string begin = "pabd: note: ";
  std::vector<std::string> out;
  for (const std::string& line : lines_of(err))
    if (line.starts_with(begin)) out.push_back(line.substr(begin.size()));
  return out;
}

// A bar of 2 m on the hinge of a crank half a metre above the ground, which turns it once around.
const std::string kCrank = R"({ "format": "pabd-scene", "version": 1, "bodies": [
  { "name": "ground", "shape": { "type": "plane", "normal": [0, 1, 0], "offset": 0 }, "fixed": true },
  { "name": "arm", "shape": { "type": "box", "size": [2, 0.2, 0.2] }, "position": [1, 0.5, 0] } ],
  "joints": [ { "type": "hinge", "bodies": [null, "arm"], "anchor": [0, 0.5, 0], "axis": [0, 0, 1],
                "drive": { "keys": [[0, 0], [1, -360]] } } ] })";

std::int64_t unsolved(const std::vector<std::string>& settings, const std::string& scene = "pyramid") {
  std::vector<std::string> command = {"run", scene, "--steps", "150", "--quiet", "--json"};
  for (const std::string& set : settings) command.insert(command.end(), {"--set", set});
  const auto summary = nlohmann::json::parse(run_pabd(command).out);
  return summary["outcomes"].value("iteration_limit", std::int64_t{0});
}

}  // namespace

TEST_CASE("a drive that pushes a body through the ground is told of, whatever is made of the run") {
  const CommandFolder folder;
  const std::string scene = folder / "crank.json";
  write_text(scene, kCrank);
  const std::vector<std::vector<std::string>> commands = {
      {"run", scene, "--time", "1"},
      {"export", scene, "--time", "1", "-o", folder / "a.glb"},
      {"render", scene, "--time", "1", "--size", "64x36", "-o", folder / "a.png"}};
  for (std::vector<std::string> command : commands) {
    CAPTURE(command);
    const Outcome told = run_pabd(command);
    CHECK(told.exit_code == 0);
    const std::vector<std::string> notes = notes_of(told.err);
    REQUIRE(notes.size() == 1);
    // Pointing down its end is 2 m below the hinge.
    CHECK_THAT(notes[0],
               Catch::Matches("bodies overlap by 1\\.5[0-9]* m, more than 0\\.1 of the smallest one's radius "
                              "\\(0\\.1 m\\); a drive goes on against what is in its way"));
    command.insert(command.end(), {"--quiet", "--force"});
    CHECK(run_pabd(command).err.empty());
  }
  const Outcome json = run_pabd({"run", scene, "--time", "1", "--json"});
  CHECK(nlohmann::json::parse(json.out)["notes"].get<std::vector<std::string>>() == notes_of(json.err));
}

TEST_CASE("steps that end unsolved are told of, with a setting that leaves fewer of them") {
  CHECK(unsolved({}) <= 3);
  for (const std::string set : {"solver.iterations=1", "solver.method=sissm", "solver.halvings=0"}) {
    CAPTURE(set);
    const Outcome told = run_pabd({"run", "pyramid", "--steps", "150", "--set", set});
    const std::vector<std::string> notes = notes_of(told.err);
    REQUIRE_FALSE(notes.empty());
    const std::string note = notes.back();  // with one iteration bodies overlap, too
    CAPTURE(note);
    const std::int64_t many = unsolved({set});
    CHECK(note.starts_with(std::to_string(many) +
                           " of 150 steps ended unsolved: a body still moved by up to "));
    const std::string before = "; try --set ";
    const auto at = note.find(before);
    REQUIRE(at != std::string::npos);
    CHECK(4 * unsolved({set, note.substr(at + before.size())}) < many);
  }
  // Tolerance 0 asks for all iterations.
  CHECK(notes_of(run_pabd({"run", "pyramid", "--steps", "30", "--set", "solver.tolerance=0"}).err).empty());
}

TEST_CASE(
    "a pile that the default solver leaves partly unsolved: half the step ends it, more iterations do not") {
  const CommandFolder folder;
  const std::string scene = folder / "pile.json";
  write_text(scene,
             R"({ "format": "pabd-scene", "version": 1, "contact": { "N": 5, "d_hat": 0.01, "friction": 0.3 },
    "bodies": [ { "name": "ground", "shape": { "type": "plane" }, "fixed": true } ],
    "generate": [ { "type": "pile", "count": 200, "shape": "mixed", "size": [0.6, 0.5, 0.5], "vary": 0.15,
                    "columns": 6, "seed": 7 } ] })");
  const std::int64_t more = unsolved({"solver.iterations=80"}, scene);
  const std::vector<std::string> notes =
      notes_of(run_pabd({"run", scene, "--steps", "150", "--set", "solver.iterations=80"}).err);
  REQUIRE(notes.size() == 1);
  CHECK_THAT(notes[0], Catch::EndsWith("; try --set time_step=0.00833333"));
  const std::int64_t half = unsolved({"time_step=0.00833333"}, scene);
  CHECK(half < unsolved({}, scene));
  CHECK(half < more);
}

TEST_CASE("contacts that are too soft are told of, and a good run tells nothing") {
  const Outcome soft = run_pabd({"run", "pyramid", "--steps", "60", "--set", "contact.kappa=1e-9"});
  const std::vector<std::string> notes = notes_of(soft.err);
  REQUIRE(notes.size() == 1);
  CHECK_THAT(notes[0],
             Catch::StartsWith("bodies overlap by ") && Catch::EndsWith("; try --set contact.kappa=auto"));
  const Outcome good = run_pabd({"run", "pyramid", "--steps", "60", "--json"});
  CHECK(notes_of(good.err).empty());
  CHECK(nlohmann::json::parse(good.out)["notes"].empty());
}

TEST_CASE("of two runs in one picture each is told of") {
  const CommandFolder folder;
  write_text(folder / "soft.json", R"({ "contact": { "kappa": 1e-9 } })");
  const Outcome told = run_pabd({"render", "pyramid", "--time", "1", "--size", "64x36", "-o",
                                 folder / "a.png", "--ab", folder / "soft.json"});
  const std::vector<std::string> notes = notes_of(told.err);
  REQUIRE(notes.size() == 1);
  CHECK(notes[0].starts_with(folder / "soft.json: bodies overlap by "));
}

TEST_CASE("a sweep ends with how many of its tasks are not acceptable") {
  const CommandFolder folder;
  write_text(
      folder / "plan.json",
      R"({ "format": "pabd-sweep", "version": 1, "scene": "two_boxes", "stop": { "steps": 60 }, "picture": false,
                 "parameters": [ { "key": "contact.kappa", "values": [1, 2, 10000] } ] })");
  const Outcome told = run_pabd({"sweep", folder / "plan.json", "-o", folder / "out"});
  const std::vector<std::string> notes = notes_of(told.err);
  REQUIRE(notes.size() == 1);
  CHECK_THAT(notes[0], Catch::StartsWith("2 of 3 tasks are not acceptable: in task 0 bodies overlap by ") &&
                           Catch::EndsWith("; 'pabd sweep collect' tells all"));
  CHECK(
      run_pabd({"sweep", "collect", folder / "out"}).out.starts_with("3 tasks: 3 done (2 not acceptable)\n"));
}

}  // namespace pabd::test_cli_notes
