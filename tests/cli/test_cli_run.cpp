// SPDX-License-Identifier: MIT
// pabd run: what it writes, and that a run can be repeated, split and tuned.
#include <catch2/catch.hpp>
#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/cli/program.h"
#include "tests/support/places.h"

namespace pabd::test_cli_run {

using namespace test;

namespace {

// The state hash that a run of `steps` steps ends with.
std::string end_hash(const std::vector<std::string>& more) {
  const CommandFolder folder;
  std::vector<std::string> command = {"run", "stack", "--quiet", "--state", folder / "end.json"};
  command.insert(command.end(), more.begin(), more.end());
  const Outcome outcome = run_pabd(command);
  CAPTURE(command, outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return nlohmann::json::parse(read_text(folder / "end.json"))["hash"];
}

}  // namespace

TEST_CASE("the CSV files have the documented columns, a row a step and a row an iteration") {
  const CommandFolder folder;
  const Outcome outcome = run_pabd(
      {"run", "two_boxes", "--steps", "7", "--trace", folder / "t.csv", "--iterations", folder / "i.csv"});
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.out.empty());
  const auto steps = lines_of(read_text(folder / "t.csv"));
  REQUIRE(steps.size() == 8);
  CHECK(steps[0] ==
        "step,time,method,status,iterations,kinetic,potential,elastic,contacts,max_penetration,min_gap,max_"
        "normal_force,max_joint_error,"
        "residual,drive_work,capped_bonds,held_bodies,halved_bodies,halvings,friction_excess,kappa,left_"
        "pairs,too_"
        "dense,step_ms");
  CHECK(steps[1].starts_with("1,"));
  CHECK(steps[7].starts_with("7,"));
  const auto iterations = lines_of(read_text(folder / "i.csv"));
  CHECK(iterations.at(0) ==
        "step,iteration,energy,residual,max_penetration_before,max_penetration_after,max_joint_error,"
        "projection_change");
  CHECK(iterations.at(1).starts_with("1,1,"));
  CHECK(iterations.size() > 8);
}

TEST_CASE("the summary goes to standard error and tells steps, gap, energy and hash") {
  const Outcome outcome = run_pabd({"run", "stack", "--steps", "3"});
  CHECK(outcome.exit_code == 0);
  for (const char* word : {"3 steps", "ms a step", "smallest gap", "kinetic energy", "state "}) {
    CHECK(outcome.err.find(word) != std::string::npos);
  }
  const Outcome quiet = run_pabd({"run", "stack", "--steps", "3", "--quiet"});
  CHECK(quiet.out.empty());
  CHECK(quiet.err.empty());
}

TEST_CASE("--json prints the summary as one document, with what the other outputs say") {
  const CommandFolder folder;
  const Outcome outcome = run_pabd({"run", "slider_crank", "--steps", "20", "--quiet", "--json", "--trace",
                                    folder / "t.csv", "--state", folder / "s.json", "--threads", "2"});
  CAPTURE(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  const auto json = nlohmann::json::parse(outcome.out);
  CHECK(json["format"] == "pabd-run-summary");
  CHECK(json["status"] == "done");
  CHECK(json["steps"] == 20);
  CHECK(json["threads"] == 2);
  CHECK(json["joints"] == 4);
  const auto state = nlohmann::json::parse(read_text(folder / "s.json"));
  CHECK(json["state"] == state["hash"]);
  CHECK(json["time"] == state["time"]);
  CHECK(json["bodies"] == state["bodies"].size());
  double largest = 0, kinetic = 0, iterations = 0;
  const std::string trace = read_text(folder / "t.csv");
  for (const double error : column_of(trace, "max_joint_error")) largest = std::max(largest, error);
  for (const double count : column_of(trace, "iterations")) iterations += count;
  kinetic = column_of(trace, "kinetic").back();
  CHECK(largest > 0);
  CHECK(json["max_joint_error"].get<double>() == Approx(largest).epsilon(1e-5));
  CHECK(json["kinetic"].get<double>() == Approx(kinetic).epsilon(1e-5));
  CHECK(json["iterations_a_step"].get<double>() == Approx(iterations / 20));
  CHECK(json["ms_a_step"].get<double>() == Approx(1e3 * json["wall_time"].get<double>() / 20));
  long steps = 0;
  for (const auto& [name, count] : json["outcomes"].items()) steps += count.get<long>();
  CHECK(steps == 20);
  // Every field is explained, and no other.
  const std::string reference = read_text(places::project() + "/app/cli/README.md");
  const auto from = reference.find("### The summary of a run"), to = reference.find("\n#", from + 4);
  REQUIRE(from != std::string::npos);
  const std::string section = reference.substr(from, to - from);
  for (const auto& [name, value] : json.items()) {
    CAPTURE(name);
    CHECK(section.find("`" + name + "`") != std::string::npos);
  }
}

TEST_CASE("--json says what there was none of, and how a run ended") {
  const auto falling =
      nlohmann::json::parse(run_pabd({"run", "spin", "--steps", "2", "--json", "--quiet"}).out);
  CHECK(falling["max_joint_error"].is_null());
  CHECK(falling["min_gap"].is_null());
  const Outcome diverged =
      run_pabd({"run", "two_boxes", "--set", "contact.barrier=log", "--steps", "3", "--json", "--quiet"});
  CHECK(diverged.exit_code == 5);
  CHECK(nlohmann::json::parse(diverged.out)["status"] == "diverged");
  const Outcome both = run_pabd({"run", "stack", "--steps", "1", "--json", "--trace", "-"});
  CHECK(both.exit_code == 2);
  CHECK(is_error_line(both.err, {"--json", "standard output"}));
}

TEST_CASE("a run is as long as its scene says, unless it is told") {
  const auto steps = [](const std::vector<std::string>& more) {
    std::vector<std::string> command = {"run", "two_boxes", "--set", "duration=0.1"};
    command.insert(command.end(), more.begin(), more.end());
    const Outcome outcome = run_pabd(command);
    CHECK(outcome.exit_code == 0);
    return outcome.err.substr(outcome.err.rfind('\n', outcome.err.size() - 2) + 1);
  };
  CHECK(steps({}).starts_with("6 steps to t = 0.1 s"));
  CHECK(steps({"--time", "0.05"}).starts_with("3 steps to t = 0.05 s"));
  CHECK(steps({"--steps", "4"}).starts_with("4 steps to "));
}

TEST_CASE("the summary counts the steps that ended at the iteration limit") {
  const Outcome hurried = run_pabd(
      {"run", "stack", "--steps", "4", "--set", "solver.iterations=1", "--set", "solver.tolerance=0"});
  CHECK(hurried.err.find("4 steps to t = 0.0666667 s, 4 at the iteration limit,") != std::string::npos);
  CHECK(run_pabd({"run", "spin", "--steps", "4"}).err.find("limit") == std::string::npos);  // no bonds
}

TEST_CASE("with joints the summary names their largest error of the run, which is that of the CSV") {
  CHECK(run_pabd({"run", "stack", "--steps", "3"}).err.find("joint") == std::string::npos);
  const Outcome outcome = run_pabd({"run", "slider_crank", "--steps", "20", "--trace", "-"});
  REQUIRE(outcome.exit_code == 0);
  double largest = 0;
  for (const double error : column_of(outcome.out, "max_joint_error")) largest = std::max(largest, error);
  CHECK(largest > 0);
  const std::string words = "largest joint error ";
  const auto at = outcome.err.find(words);
  REQUIRE(at != std::string::npos);
  CHECK(std::stod(outcome.err.substr(at + words.size())) == Approx(largest).epsilon(0.05));  // two digits
}

TEST_CASE("the summary tells of friction above its bound as the CSV does, and only then") {
  const std::vector<std::string> hurried = {
      "run", "incline", "--set", "solver.iterations=1", "--set", "solver.method=descent", "--trace", "-"};
  for (const char* steps : {"1", "60"}) {
    std::vector<std::string> command = hurried;
    command.insert(command.end(), {"--steps", steps});
    const Outcome outcome = run_pabd(command);
    CAPTURE(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    double largest = 0;
    int above = 0;
    std::ptrdiff_t column = 0;
    for (const std::string& row : lines_of(outcome.out)) {
      if (const auto name = row.find("friction_excess"); name != std::string::npos) {
        column = std::count(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(name), ',');
        continue;
      }
      std::istringstream cells(row);
      std::string cell;
      for (std::ptrdiff_t k = 0; k <= column; ++k) std::getline(cells, cell, ',');
      const double excess = std::stod(cell);
      largest = std::max(largest, excess);
      if (excess > 0.01) ++above;
    }
    REQUIRE(above > 0);
    const std::string words = " · friction up to ";
    const auto at = outcome.err.find(words);
    REQUIRE(at != std::string::npos);
    CHECK(std::stod(outcome.err.substr(at + words.size())) ==
          Approx(100 * largest).epsilon(0.05));  // two digits
    CHECK(outcome.err.find(" % above μ f_n in " + std::to_string(above) +
                           (above == 1 ? " step ·" : " steps ·")) != std::string::npos);
  }
  const Outcome clean = run_pabd({"run", "incline", "--steps", "60"});
  CHECK(clean.exit_code == 0);
  CHECK(clean.err.find("kinetic energy") != std::string::npos);
  CHECK(clean.err.find("friction") == std::string::npos);
}

TEST_CASE("- is standard output, for one of the files") {
  const Outcome trace = run_pabd({"run", "two_boxes", "--steps", "2", "--quiet", "--trace", "-"});
  CHECK(trace.exit_code == 0);
  CHECK(line_count(trace.out) == 3);
  const Outcome state = run_pabd({"run", "two_boxes", "--steps", "2", "--quiet", "--state", "-"});
  CHECK(nlohmann::json::parse(state.out)["bodies"].size() == 3);
  CHECK(run_pabd({"run", "two_boxes", "--steps", "2", "--trace", "-", "--state", "-"}).exit_code == 2);
  CHECK(run_pabd({"run", "two_boxes", "--steps", "2", "--trace", "same", "--state", "same"}).exit_code == 2);
}

TEST_CASE("time and steps count the same") {
  CHECK(end_hash({"--time", "0.1"}) == end_hash({"--steps", "6"}));
  CHECK(end_hash({"--steps", "0"}) != end_hash({"--steps", "1"}));
}

TEST_CASE("a run that is stopped and continued ends as one in a piece") {
  const CommandFolder folder;
  const std::string half = folder / "half.json";
  REQUIRE(run_pabd({"run", "stack", "--steps", "11", "--quiet", "--state", half}).exit_code == 0);
  CHECK(end_hash({"--steps", "9", "--from", half}) == end_hash({"--steps", "20"}));
}

TEST_CASE("what joints and contacts remember goes on through a state file") {
  // Joints alone, joints and contacts, contacts that newton hands over.
  for (const std::string scene : {"chain_heavy_end", "ragdoll", "chairs"}) {
    CAPTURE(scene);
    const CommandFolder folder;
    const auto run = [&](std::vector<std::string> more, const std::string& end) {
      std::vector<std::string> command = {"run", scene, "--quiet", "--state", folder / end, "--steps"};
      command.insert(command.end(), more.begin(), more.end());
      REQUIRE(run_pabd(command).exit_code == 0);
      return read_text(folder / end);
    };
    const std::string whole = run({"50"}, "whole.json");
    run({"37"}, "half.json");
    CHECK(run({"13", "--from", folder / "half.json"}, "end.json") == whole);
  }
}

TEST_CASE("a state of another scene is refused") {
  const CommandFolder folder;
  REQUIRE(run_pabd({"run", "stack", "--steps", "1", "--quiet", "--state", folder / "s.json"}).exit_code == 0);
  const Outcome other = run_pabd({"run", "two_boxes", "--steps", "1", "--from", folder / "s.json"});
  CHECK(other.exit_code == 2);
  CHECK(is_error_line(other.err, {"s.json"}));
  write_text(folder / "s.json", "{ \"bodies\": 3 }");
  CHECK(run_pabd({"run", "stack", "--steps", "1", "--from", folder / "s.json"}).exit_code == 2);
}

TEST_CASE("every run and every number of threads gives the same bits") {
  const std::string one = end_hash({"--steps", "30", "--threads", "1"});
  CHECK(end_hash({"--steps", "30", "--threads", "1"}) == one);
  CHECK(end_hash({"--steps", "30", "--threads", "2"}) == one);
  CHECK(end_hash({"--steps", "30", "--threads", "8"}) == one);
}

TEST_CASE("--set changes the scene, --set to what it is does not") {
  const std::string plain = end_hash({"--steps", "5"});
  CHECK(end_hash({"--steps", "5", "--set", "contact.N=8"}) != plain);
  CHECK(end_hash({"--steps", "5", "--set", "gravity=[0,-1.62,0]", "--set", "solver.iterations=3"}) != plain);
  CHECK(end_hash({"--steps", "5", "--set", "version=1"}) == plain);
}

TEST_CASE("an interrupted run publishes the rows it has") {
  for (const auto& [signal, code] : {std::pair{SIGINT, 130}, {SIGTERM, 143}, {SIGHUP, 129}}) {
    const CommandFolder folder;
    const auto has_rows = [&](const std::string&) {
      for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
        if (entry.file_size() > 0) return true;
      }
      return false;
    };
    const Outcome outcome = run_pabd_interrupted({"run", "two_boxes", "--steps", "1000000000", "--quiet",
                                                  "--trace", folder / "t.csv", "--state", folder / "s.json"},
                                                 signal, has_rows);
    CHECK(outcome.exit_code == code);
    CHECK(folder.names() == std::vector<std::string>{"s.json", "t.csv"});
    const std::string trace = read_text(folder / "t.csv");
    CHECK(trace.back() == '\n');
    CHECK(line_count(trace) > 10);
    const auto last = lines_of(trace).back();
    const auto header = lines_of(trace).front();
    CHECK(std::count(last.begin(), last.end(), ',') == std::count(header.begin(), header.end(), ','));
    CHECK(nlohmann::json::parse(read_text(folder / "s.json"))["step"] == std::stoll(last));
  }
}

TEST_CASE(
    "a d̂ that follows from small bodies, or is too large for one, is told in one line by whoever opens the "
    "scene") {
  const CommandFolder folder;
  write_text(folder / "die.json", R"({ "format": "pabd-scene", "version": 1, "bodies": [
    { "name": "ground", "shape": { "type": "plane" } },
    { "name": "die", "shape": { "type": "box", "size": [0.001, 0.001, 0.001] }, "position": [0, 0.001, 0] } ] })");
  const std::string scene = folder / "die.json";
  const auto told = [](const Outcome& outcome) {
    std::vector<std::string> out;
    for (const std::string& line : lines_of(outcome.err))
      if (line.find("contact.d_hat") != line.npos) out.push_back(line);
    return out;
  };
  const Outcome run = run_pabd({"run", scene, "--time", "1", "--state", folder / "end.json"});
  REQUIRE(run.exit_code == 0);
  CHECK(told(run) ==
        std::vector<std::string>{"pabd: note: contact.d_hat is 0.0001 m, a tenth of the thickness of "
                                 "\"die\" (0.001 m): the scene states none"});
  const auto end = nlohmann::json::parse(read_text(folder / "end.json"));
  const double height = end["bodies"][1]["position"][1];
  CHECK(height < 0.0005 + 0.0001);  // and not 0.01 m over the ground
  CHECK(height > 0.0005);
  const std::vector<std::string> large = {"--set", "contact.d_hat=0.01"};
  for (std::vector<std::string> command :
       {std::vector<std::string>{"run", scene, "--steps", "1"},
        {"render", scene, "--frames", "1", "--size", "64x48", "-o", folder / "die.png"},
        {"export", scene, "--time", "0.02", "-o", folder / "die.glb"}}) {
    command.insert(command.end(), large.begin(), large.end());
    const Outcome warned = run_pabd(command);
    CAPTURE(command, warned.err);
    REQUIRE(warned.exit_code == 0);
    CHECK(told(warned) ==
          std::vector<std::string>{
              "pabd: note: contact.d_hat, 0.01 m, is more than half of the thickness of \"die\" "
              "(0.001 m), and bodies rest that far apart; try contact.d_hat=0.0001"});
  }
  CHECK(told(run_pabd({"run", scene, "--steps", "1", "--quiet"})).empty());
  CHECK(told(run_pabd({"run", "stack", "--steps", "1"})).empty());
}

}  // namespace pabd::test_cli_run
