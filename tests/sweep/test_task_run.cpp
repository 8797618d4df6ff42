// SPDX-License-Identifier: MIT
// A run against the same run made by hand, stopped and taken up anywhere, and what is a result though nothing ran.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/session/session.h"
#include "app/sweep/acceptance.h"
#include "app/sweep/task_run.h"
#include "sim/base/error.h"
#include "sim/body/model.h"
#include "sim/trace/trace.h"
#include "tests/support/files.h"
#include "tests/support/places.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_task_run {

namespace {

const std::filesystem::path kScenes = std::filesystem::path(places::assets()) / "scenes";

SweepPlan plan_of(const std::string& scene, const std::string& members) {
  return parse_plan(R"({"format": "pabd-sweep", "version": 1, "scene": ")" + scene + "\", " + members + "}",
                    "plan.json", "/nowhere",
                    [](const std::string& name) { return kScenes / (name + ".json"); });
}

std::vector<SweepTask> tasks_of(const SweepPlan& plan) { return tasks_of(plan, base_scene(plan)); }

// All that does not differ between runs.
std::string bytes_of(const TaskResult& result) {
  return result.status + result.why + result.faults + result.metrics.dump() + std::to_string(result.step) +
         (result.scene ? state_to_json(result.scene->model, result.end) : "");
}

}  // namespace

TEST_CASE("metrics are those of the steps") {
  const SweepPlan plan = plan_of("drop", R"("stop": {"steps": 80}, "set": {"time_step": 0.01},
    "parameters": [{"key": "contact.N", "values": [2]}],
    "metrics": ["penetration", "energy_error", "iterations", "step_time", "drift",
      {"name": "contacts", "at": "/contacts", "take": "sum"}, {"at": "/kinetic"}, {"name": "gap", "at": "/min_gap", "take": "min"}])");
  const auto result = run_task(plan, tasks_of(plan).at(0), "/nowhere/checkpoint.json", {});
  REQUIRE(result.has_value());

  Session session(load_scene(kScenes / "drop.json", {"time_step=0.01", "contact.N=2"}));
  const double start = session.report().kinetic + session.report().potential + session.report().elastic;
  double penetration = 0, error = 0, iterations = 0, contacts = 0, gap = INFINITY;
  for (int i = 0; i < 80; ++i) {
    const StepReport& r = session.step();
    penetration = std::max(penetration, r.max_penetration);
    error = std::max(error, std::abs(r.kinetic + r.potential + r.elastic - start));
    iterations += r.iterations;
    contacts += r.contacts;
    gap = std::min(gap, r.min_gap);
  }
  REQUIRE(contacts > 0);
  CHECK(result->status == "done");
  CHECK(result->step == 80);
  CHECK(result->metrics["penetration"] == penetration);
  CHECK(result->metrics["energy_error"].get<double>() == Approx(error).epsilon(1e-12));
  CHECK(result->metrics["iterations"] == iterations / 80);
  CHECK(result->metrics["contacts"] == contacts);
  CHECK(result->metrics["kinetic"] == session.report().kinetic);
  CHECK(result->metrics["gap"] == gap);
  CHECK(result->metrics["drift"].is_null());  // no joints
  CHECK_FALSE(result->metrics.contains("step_time"));
  CHECK(result->times["step_time"].get<double>() > 0);
  CHECK(result->times["step_time_noise"].get<double>() > 0);
  CHECK(state_hash(result->end) == state_hash(session.state()));
}

TEST_CASE("stopped anywhere, a run goes on to the same bytes") {
  const std::string members = R"("stop": {"steps": 30}, "parameters": [{"key": "contact.N", "values": [3]}],
    "reference": {"time_step": 0.004}, "metrics": ["penetration", "energy_error", "distance", {"at": "/contacts", "take": "mean"}])";
  for (const std::string scene : {"two_boxes", "four_bar", "incline"}) {
    CAPTURE(scene);
    const SweepPlan plan = plan_of(scene, members);
    const SweepTask task = tasks_of(plan).at(0);
    const auto whole = run_task(plan, task, "/nowhere/checkpoint.json", {});
    REQUIRE(whole.has_value());
    CHECK(whole->metrics["distance"].get<double>() > 0);
    for (const int every : {1, 3, 7}) {
      const TempFolder folder;
      const auto checkpoint = folder.path() / "checkpoint.json";
      std::optional<TaskResult> parted;
      int parts = 0;
      for (; !parted && parts < 2000; ++parts) {
        int asked = 0;
        TaskOptions options;
        options.stop = [&] { return ++asked > 20 * every + parts; };
        parted = run_task(plan, task, checkpoint, options);
      }
      REQUIRE(parted.has_value());
      CAPTURE(every, parts);
      CHECK(parts > 1);
      CHECK(bytes_of(*parted) == bytes_of(*whole));
    }
  }
}

TEST_CASE("a checkpoint that does not fit is left aside") {
  const SweepPlan plan =
      plan_of("two_boxes", R"("stop": {"steps": 5}, "parameters": [{"key": "contact.N", "values": [2, 3]}])");
  const auto all = tasks_of(plan);
  const auto whole = run_task(plan, all[0], "/nowhere/checkpoint.json", {});
  const TempFolder folder;
  const auto checkpoint = folder.path() / "checkpoint.json";
  TaskOptions stopped;
  stopped.stop = [] { return true; };
  REQUIRE_FALSE(run_task(plan, all[1], checkpoint, stopped).has_value());
  for (const std::string& text :
       {read_bytes(checkpoint), std::string("{"), std::string("[]"), std::string("{\"format\": 3}")}) {
    write_bytes(checkpoint, text);
    const auto result = run_task(plan, all[0], checkpoint, {});
    REQUIRE(result.has_value());
    CHECK(bytes_of(*result) == bytes_of(*whole));
  }
}

TEST_CASE("the reference is at its last step that is not after") {
  // A ball in free fall. Steps of implicit Euler of length h end g h t/2 below the parabola, so two runs of h and h/4
  // are 3/8 g h t apart.
  const SweepPlan plan =
      plan_of("drop", R"("stop": {"steps": 8}, "set": {"time_step": 0.01, "solver.integrator": "euler"},
    "parameters": [{"key": "contact.N", "values": [2]}], "reference": {"time_step": 0.0025}, "metrics": ["distance"])");
  const auto result = run_task(plan, tasks_of(plan).at(0), "/nowhere/checkpoint.json", {});
  REQUIRE(result.has_value());
  CHECK(result->metrics["distance"].get<double>() == Approx(0.375 * 9.81 * 0.01 * 0.08).epsilon(1e-6));
}

TEST_CASE("a run ends when its rule has held long enough") {
  const auto steps = [](const std::string& when) {
    const SweepPlan plan = plan_of(
        "drop", R"("stop": {"steps": 50, "when": )" + when +
                    R"(}, "set": {"time_step": 0.01}, "parameters": [{"key": "contact.N", "values": [2]}])");
    return run_task(plan, tasks_of(plan).at(0), "/nowhere/checkpoint.json", {})->step;
  };
  CHECK(steps(R"({"at": "/time", "above": 0.095})") == 10);
  CHECK(steps(R"({"at": "/time", "above": 0.095, "for": 0.1})") == 20);
  CHECK(steps(R"({"at": "/time", "below": -1})") == 50);
}

TEST_CASE("what nobody would take is told") {
  const auto faults = [](const std::string& scene, const std::string& set) {
    const SweepPlan plan = plan_of(scene, R"("stop": {"steps": 120}, "set": {)" + set +
                                              R"(}, "parameters": [{"key": "contact.N", "values": [2]}])");
    return run_task(plan, tasks_of(plan).at(0), "/nowhere/checkpoint.json", {}).value().faults;
  };
  CHECK(faults("pyramid", R"("time_step": 0.0166)").empty());
  CHECK(faults("pendulum", R"("time_step": 0.0166)").empty());
  // A contact that carries nothing, and a solver that may look once at a step and should end at 1e-9.
  CHECK_THAT(faults("pyramid", R"("contact.kappa": 1e-9)"), Catch::StartsWith("bodies overlap by "));
  CHECK_THAT(
      faults("pyramid", R"("solver.iterations": 1, "solver.method": "sissm", "solver.tolerance": 1e-9)"),
      Catch::Contains(" of 120 steps end unsolved"));
}

TEST_CASE("the plan says what is acceptable") {
  const auto faults = [](const std::string& accept) {
    const SweepPlan plan =
        plan_of("two_boxes", R"("stop": {"steps": 120}, "accept": {)" + accept +
                                 R"(}, "parameters": [{"key": "contact.N", "values": [3]}])");
    return run_task(plan, tasks_of(plan).at(0), "/nowhere/checkpoint.json", {}).value().faults;
  };
  // They overlap by 0.0385 m; the inner radius of a box of 1 m is 0.5 m.
  CHECK(faults("").empty());
  CHECK(faults(R"("overlap": 0.08)").empty());
  CHECK(faults(R"("overlap": 0.07)") ==
        "bodies overlap by 0.0385 m, more than 0.07 of the smallest one's radius (0.5 m)");
  Acceptance run{Model{}};
  StepSummary step;
  step.status = StepStatus::converged;
  step.potential = 100;
  run.add(step, 0, true);
  step.kinetic = 10;
  step.status = StepStatus::iteration_limit;
  run.add(step, 3, true);
  CHECK(run.faults({.energy = 0.31, .unsolved = 0.5}).empty());
  CHECK(run.faults({.energy = 0.29, .unsolved = 0.5}) == "3 J of motion come from nowhere, where 10 J moved");
  CHECK(run.faults({.energy = 0.31, .unsolved = 0.49}) == "1 of 2 steps end unsolved");
}

TEST_CASE("energy that is made counts beside what moved, and rounding where nothing moves does not") {
  const auto faults = [](double kinetic, double gained) {
    Acceptance run{Model{}};
    StepSummary step;
    step.status = StepStatus::converged;
    step.potential = 1000;
    step.kinetic = kinetic;
    run.add(step, 0, true);
    step.kinetic += gained;
    run.add(step, gained, true);
    Acceptance again{Model{}};
    nlohmann::json::parse(nlohmann::json(run).dump()).get_to(again);
    CHECK(again.faults() == run.faults());
    return run.faults();
  };
  // Crates that were put too near each other rise by 22 J in a second.
  Acceptance rising{Model{}};
  for (int k = 0; k <= 60; ++k) {
    StepSummary step;
    step.status = StepStatus::converged;
    step.kinetic = 0.03;
    step.potential = 1443 + 22.0 * k / 60;
    rising.add(step, step.potential + step.kinetic - 1443, true);
  }
  CHECK(rising.faults().empty());
  CHECK(faults(1e-20, 1e-10).empty());
  CHECK(faults(100, 4).empty());
  CHECK(faults(100, 6) == "6 J of motion come from nowhere, where 106 J moved");
  CHECK(faults(0, 1) == "1 J of motion come from nowhere, where 1 J moved");
}

TEST_CASE("what the scene refuses is a result, and says why") {
  const SweepPlan plan = plan_of(
      "two_boxes", R"("stop": {"steps": 2}, "parameters": [{"key": "contact.d_hat", "values": [-1]}])");
  const auto result = run_task(plan, tasks_of(plan).at(0), "/nowhere/checkpoint.json", {});
  REQUIRE(result.has_value());
  CHECK(result->status == "refused");
  CHECK(result->why.find("d_hat") != std::string::npos);
  CHECK(result->metrics.empty());
  CHECK(result->scene == nullptr);
}

}  // namespace pabd::test_task_run
