// SPDX-License-Identifier: MIT
// Steps that are halved in vain: said when there are many of them, with what is measured to help; hits are no news.
#include "app/session/contact_advice.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>

#include "sim/math/so3.h"
#include "sim/scene/tuning.h"
#include "tests/support/scenario.h"

namespace pabd::test_halving_advice {

namespace {

// Long boxes that lie across each other and fall in a heap.
testing::World planks(int count) {
  testing::World world;
  std::mt19937 rng(7);
  std::uniform_real_distribution<double> one(-1, 1);
  world.add_ground();
  for (int k = 0; k < count; ++k)
    world.add(Box{{0.5, 0.05, 0.05}}, 10, {0.3 * one(rng), 0.2 + 0.15 * k, 0.3 * one(rng)},
              exp_so3({0, 3 * one(rng), 0}));
  return world;
}

std::vector<StepSummary> steps_of(testing::World world, double seconds) {
  std::vector<StepSummary> out;
  testing::run(world, static_cast<int>(seconds / world.params.h), {},
               [&](const StepReport& r) { out.push_back(r.summary()); });
  return out;
}

// In how many of the steps there was the advice, and the last of it.
std::pair<std::size_t, std::optional<Advice>> told(const Params& params,
                                                   const std::vector<StepSummary>& steps) {
  std::pair<std::size_t, std::optional<Advice>> out;
  for (std::size_t n = 1; n <= steps.size(); ++n) {
    auto advice = halving_advice(params, std::span(steps).first(n));
    if (!advice) continue;
    ++out.first;
    out.second = std::move(advice);
  }
  return out;
}

StepSummary halved(StepStatus status, int halvings) {
  StepSummary out;
  out.status = status;
  out.halved_bodies = 3;
  out.halvings = halvings;
  out.residual = 0.01;
  return out;
}

}  // namespace

TEST_CASE("planks that fall in a heap: what is advised, taken again and again, ends it") {
  testing::World world = planks(30);
  world.params.h = 1.0 / 20;
  world.params.solver.iterations = 2;
  world.params.solver.halvings = 2;
  std::size_t before = 0;
  std::vector<std::string> keys;
  for (int clicks = 0;; ++clicks) {
    REQUIRE(clicks < 5);
    const auto [steps, advice] = told(world.params, steps_of(world, 2));
    if (!advice) break;
    INFO(advice->what << "; " << advice->key << "=" << advice->value);
    if (clicks > 0) CHECK(steps < before);
    before = steps;
    keys.push_back(advice->key);
    world.params = tuned(world.params, {advice->key + "=" + advice->value});
  }
  REQUIRE_FALSE(keys.empty());
  CHECK(keys.front() == "solver.iterations");
}

TEST_CASE("the words of the advice have the numbers of the steps") {
  Params params;
  std::vector<StepSummary> steps(50);
  for (int k = 0; k < 14; ++k) steps.push_back(halved(StepStatus::iteration_limit, 3));
  CHECK_FALSE(halving_advice(params, steps));
  steps.push_back(halved(StepStatus::iteration_limit, 4));
  const auto advice = halving_advice(params, steps);
  REQUIRE(advice);
  CHECK(advice->what == "15 of 60 steps ended unsolved, in up to 16 parts too");
  CHECK(advice->key == "time_step");
  CHECK(std::stod(advice->value) == Approx(1.0 / 120));
  // What is less than by default comes first.
  params.solver.halvings = 2;
  CHECK(halving_advice(params, steps)->key == "solver.halvings");
  params.solver.iterations = 5;
  CHECK(halving_advice(params, steps)->value == "20");
  params.solver.method = SolverMethod::sissm;
  CHECK(halving_advice(params, steps)->value == "auto");
  params.solver.tolerance = 0;  // asks for all iterations
  CHECK_FALSE(halving_advice(params, steps));
}

TEST_CASE("halves that are solved, and steps that end near a solution, are no news") {
  const std::vector<StepSummary> solved(60, halved(StepStatus::converged, 4));
  CHECK_FALSE(halving_advice({}, solved));
  StepSummary slow = halved(StepStatus::iteration_limit, 4);
  slow.residual = 1e-3;
  CHECK_FALSE(halving_advice({}, std::vector<StepSummary>(60, slow)));
  slow.residual = 2e-3;
  slow.halvings = 0;
  const auto whole = halving_advice({}, std::vector<StepSummary>(60, slow));
  REQUIRE(whole);
  CHECK(whole->what == "60 of 60 steps ended unsolved");
}

TEST_CASE("a step that ends too near a solution for halves is not told of by itself") {
  testing::World world = planks(1);
  StepReport report;
  report.status = StepStatus::iteration_limit;
  report.iterations = 80;
  const auto told_at = [&](double residual) {
    report.residual = residual;
    return !contact_advice(world.model, world.params, world.state, report, {}).empty();
  };
  CHECK_FALSE(told_at(0.03));
  CHECK(told_at(0.031));
  world.params.solver.halvings = 0;
  CHECK(told_at(2e-6));
}

TEST_CASE("where many steps are halved in vain it stands in for what is said of one of them") {
  testing::World world = planks(1);
  StepReport report;
  report.status = StepStatus::iteration_limit;
  report.iterations = 80;
  report.residual = 0.5;
  report.halved_bodies = 1;
  report.halvings = 4;
  const auto kinds = [&](const std::vector<StepSummary>& past) {
    std::vector<AdviceKind> out;
    for (const Advice& advice : contact_advice(world.model, world.params, world.state, report, past))
      out.push_back(advice.kind);
    return out;
  };
  CHECK(kinds(std::vector<StepSummary>(20, halved(StepStatus::iteration_limit, 4))) ==
        std::vector{AdviceKind::unsolved_halves});
  CHECK(kinds({}) == std::vector{AdviceKind::iteration_limit});
  CHECK(contact_advice(world.model, world.params, world.state, report)[0].what ==
        "80 iterations were not enough in up to 16 parts of the step: residual 0.5, which is not below the "
        "tolerance of 1e-06");
}

}  // namespace pabd::test_halving_advice
