// SPDX-License-Identifier: MIT
// pabd run --profile: where the time of the steps went. Times differ from run to run; that they add up does
// not.
#include <catch2/catch.hpp>
#include <map>
#include <sstream>

#include "app/cli/step_statistics.h"
#include "tests/cli/program.h"

namespace pabd::test_cli_profile {

using namespace cli;
using namespace test;

namespace {

const std::vector<std::string> kPhases = {"detect", "set up", "solve", "velocities", "rest"};

// What follows each name, which takes ten characters.
std::map<std::string, std::string> rows_of(const std::string& text) {
  std::map<std::string, std::string> rows;
  for (const std::string& line : lines_of(text)) {
    if (line.size() <= 12) continue;
    const std::string name = line.substr(0, line.find_last_not_of(' ', 10) + 1);
    CHECK(rows.emplace(name, line.substr(12)).second);
  }
  return rows;
}

struct Cost {
  double ms = 0, percent = 0;
};

Cost cost_of(const std::string& cells) {
  Cost cost;
  std::string unit;
  std::istringstream in(cells);
  REQUIRE((in >> cost.ms >> cost.percent >> unit));
  CHECK(unit == "%");
  return cost;
}

}  // namespace

TEST_CASE("a profile: sums become means of a step, and what no phase counts is the rest") {
  StepStatistics statistics;
  StepReport report;
  report.times = {0.25, 0.5, 3, 0.125, 3.875};
  report.iterations = 4;
  report.contacts = 10;
  report.method = SolverMethod::descent;
  report.status = StepStatus::converged;
  statistics.add(report);
  statistics.add(report);
  report.times.solve = 6;
  report.iterations = 9;
  report.method = SolverMethod::newton;
  report.status = StepStatus::iteration_limit;
  statistics.add(report);
  // Of a step that failed the contacts are not known.
  report.times = {};
  report.status = StepStatus::non_finite;
  report.iterations = 1;
  statistics.add(report);
  CHECK(profile_text(statistics, {0.016, 12, 2}) ==
        "phase        ms a step    share\n"
        "detect          0.1875    4.7 %\n"
        "set up          0.3750    9.4 %\n"
        "solve           3.0000   75.0 %\n"
        "velocities      0.0938    2.3 %\n"
        "rest            0.3438    8.6 %\n"
        "total           4.0000  100.0 %\n"
        "\n"
        "steps       4\n"
        "solver      descent 2, newton 2\n"
        "status      converged 2, iteration_limit 1, non_finite 1\n"
        "iterations  4.5 a step\n"
        "contacts    10.0 a step\n"
        "bodies      12\n"
        "threads     2\n");
  CHECK(profile_text({}, {}).find("solver      none\n") != std::string::npos);
}

TEST_CASE("--profile: phases that add up, and as many steps as were made") {
  // Some of its steps take more iterations than that.
  const auto run_with = [](std::vector<std::string> more) {
    std::vector<std::string> words = {"run", "stack", "--steps", "150", "--quiet"};
    for (const char* change : {"solver.method=descent", "solver.iterations=20", "solver.tolerance=1e-9"})
      words.insert(words.end(), {"--set", change});
    words.insert(words.end(), more.begin(), more.end());
    return run_pabd(words);
  };
  const Outcome outcome = run_with({"--threads", "2", "--profile"});
  CAPTURE(outcome.out, outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  auto rows = rows_of(outcome.out);
  double ms = 0, percent = 0;
  for (const std::string& phase : kPhases) {
    CAPTURE(phase);
    REQUIRE(rows.count(phase) == 1);
    const Cost cost = cost_of(rows[phase]);
    CHECK(cost.ms >= 0);
    if (phase != "rest") CHECK(cost.percent > 0);
    ms += cost.ms;
    percent += cost.percent;
  }
  const Cost total = cost_of(rows["total"]);
  CHECK(ms == Approx(total.ms).margin(6 * 0.00005));  // digits
  CHECK(percent == Approx(100).margin(6 * 0.05));
  CHECK(total.percent == 100);
  CHECK(rows["steps"] == "150");
  CHECK(rows["solver"] == "descent 150");
  CHECK(rows["bodies"] == "11");
  CHECK(rows["threads"] == "2");

  // The same numbers as in the trace.
  const Outcome traced = run_with({"--trace", "-"});
  double iterations = 0, contacts = 0;
  std::map<std::string, int> outcomes;
  for (const std::string& line : lines_of(traced.out)) {
    if (line.starts_with("step,")) continue;
    std::vector<std::string> fields;
    std::istringstream in(line);
    for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
    ++outcomes[fields.at(3)];
    iterations += std::stod(fields[4]);
    contacts += std::stod(fields[8]);
  }
  CHECK(std::stod(rows["iterations"]) == Approx(iterations / 150).margin(0.051));
  CHECK(std::stod(rows["contacts"]) == Approx(contacts / 150).margin(0.051));
  CHECK(outcomes.size() == 2);
  for (const auto& [status, count] : outcomes)
    CHECK(rows["status"].find(status + " " + std::to_string(count)) != std::string::npos);
}

TEST_CASE("--profile has standard output for itself, and tells of a run that diverged, too") {
  const Outcome both = run_pabd({"run", "stack", "--steps", "2", "--profile", "--trace", "-"});
  CHECK(both.exit_code == 2);
  CHECK(is_error_line(both.err, {"--profile", "standard output"}));
  const Outcome none = run_pabd({"run", "stack", "--steps", "0", "--quiet", "--profile"});
  CHECK(none.exit_code == 0);
  CHECK(rows_of(none.out)["steps"] == "0");
  // The log barrier has no force for boxes that start inside each other.
  const Outcome failed =
      run_pabd({"run", "two_boxes", "--set", "contact.barrier=log", "--quiet", "--profile"});
  CAPTURE(failed.out, failed.err);
  CHECK(failed.exit_code == 5);
  CHECK(rows_of(failed.out)["status"].find("non_finite 1") != std::string::npos);
}

}  // namespace pabd::test_cli_profile
