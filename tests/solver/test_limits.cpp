// SPDX-License-Identifier: MIT
// What a step may cost: it can be stopped, and a crowd at one point stays bearable.

#include <catch2/catch.hpp>
#include <cstring>

#include "tests/support/scenario.h"

namespace pabd::test_limits {

namespace {

testing::World crowd(int n, double spread) {
  testing::World world;
  world.add_ground();
  for (int k = 0; k < n; ++k)
    world.add_cube(1, 1000,
                   {spread * std::sin(1.0 * k), 5 + spread * std::sin(2.0 * k), spread * std::cos(3.0 * k)});
  return world;
}

bool same_bytes(const State& a, const State& b) {
  const auto equal = [](const auto& x, const auto& y) {
    return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(x[0])) == 0;
  };
  return equal(a.c, b.c) && equal(a.R, b.R) && equal(a.v, b.v) && equal(a.omega, b.omega) &&
         a.step == b.step && a.time == b.time && a.contacts.size() == b.contacts.size();
}

}  // namespace

TEST_CASE("a step that is stopped keeps the state of its start, wherever it is stopped") {
  const auto method =
      GENERATE(SolverMethod::automatic, SolverMethod::descent, SolverMethod::newton, SolverMethod::sissm);
  testing::World world = crowd(40, 0.4);
  world.params.solver.method = method;
  world.params.solver.tolerance = 0;
  testing::run(world, 1);
  StepWorkspace workspace;
  StepReport report;
  StepOptions options;
  int asked = 0;
  options.stop = [&] { return ++asked < 0; };
  State whole = world.state;
  step(world.model, world.params, options, whole, workspace, report);
  REQUIRE(report.status == StepStatus::iteration_limit);
  const int questions = asked;
  CAPTURE(to_string(method), questions);
  CHECK(questions > world.params.solver.iterations);
  for (int at = 1; at <= questions; at += 1 + questions / 20) {
    State state = world.state;
    asked = 0;
    options.stop = [&] { return ++asked >= at; };
    step(world.model, world.params, options, state, workspace, report);
    CHECK(report.status == StepStatus::interrupted);
    CHECK(same_bytes(state, world.state));
    CHECK(asked <= at + 40);  // it does not go on for long
  }
  // The workspace is as good as before.
  State again = world.state;
  options.stop = {};
  step(world.model, world.params, options, again, workspace, report);
  CHECK(same_bytes(again, whole));
}

TEST_CASE("of bodies at one point each meets a few, and the report says so") {
  const auto spread = GENERATE(0.0, 0.02);
  testing::World world = crowd(300, spread);
  StepWorkspace workspace;
  StepReport report;
  StepOptions options;
  options.report_contacts = true;
  for (int threads : {1, 3}) {
    State state = world.state;
    options.threads = threads;
    step(world.model, world.params, options, state, workspace, report);
    CHECK(report.left_pairs == 300 * 299 / 2 - 8 * 300 + 8 * 9 / 2);
    CHECK(report.contacts <= 8 * 300 * 8);
  }
  // They come apart all the same.
  testing::run(world, 60);
  double farthest = 0;
  for (const Vec3& c : world.state.c) farthest = std::max(farthest, (c - world.state.c[1]).norm());
  CHECK(farthest > 0.5);
}

TEST_CASE("a crowd comes apart without speed") {
  const bool balls = GENERATE(false, true);
  testing::World world;
  for (int k = 0; k < 1000; ++k) {
    if (balls)
      world.add(Sphere{0.5}, 500, Vec3::Zero());
    else
      world.add_cube(1, 1000, Vec3::Zero());
  }
  world.params.gravity.setZero();
  const double speed = world.params.contact.recovery_speed, mass = 1000 * world.model.mass[0];
  double apart = 0;
  testing::run(world, 20, {}, [&](const StepReport& r) {
    CHECK(r.kinetic < 0.5 * mass * speed * speed);
    CHECK(r.halved_bodies == 0);
    CHECK(r.left_pairs > 0);
  });
  for (const Vec3& c : world.state.c) apart = std::max(apart, (c - world.state.c[0]).norm());
  CHECK(apart > 0.5);
}

TEST_CASE("bodies side by side are all met, however many") {
  testing::World world;
  world.add(Box{{50, 0.5, 50}}, 0, {0, -0.5, 0});
  for (int k = 0; k < 400; ++k) world.add_cube(0.5, 10, {0.6 * (k % 20), 0.255, 0.6 * (k / 20)});
  StepOptions options;
  options.report_contacts = true;
  testing::run(world, 1, options, [](const StepReport& r) {
    CHECK(r.left_pairs == 0);
    CHECK(r.too_dense == 0);
    CHECK(r.contacts >= 4 * 400);
  });
}

}  // namespace pabd::test_limits
