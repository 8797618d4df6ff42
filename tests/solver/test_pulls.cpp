// SPDX-License-Identifier: MIT
// Pulling a body while a simulation runs: a soft spring of a step that is no part of the model.

#include <catch2/catch.hpp>
#include <cmath>

#include "sim/math/so3.h"
#include "tests/support/scenario.h"

namespace pabd::test_pulls {

using testing::World;

namespace {

constexpr SolverMethod kMethods[] = {SolverMethod::sissm, SolverMethod::descent, SolverMethod::newton,
                                     SolverMethod::automatic};

StepOptions with_pull(const Pull& pull) {
  StepOptions options;
  options.pulls.push_back(pull);
  return options;
}

// `iterations` are always done: sissm halves what is left in each.
World world_of(SolverMethod method, const Vec3& gravity, int iterations = 80) {
  World world;
  world.params.solver.method = method;
  world.params.solver.iterations = iterations;
  world.params.solver.tolerance = 0;
  world.params.gravity = gravity;
  return world;
}

}  // namespace

TEST_CASE("a body pulled at its centre follows implicit Euler of an oscillator to 1e-9") {
  const double m = 3, kappa = 50, h = 1.0 / 60;
  const Vec3 target(0.3, -0.2, 0.1);
  for (const SolverMethod method : kMethods) {
    CAPTURE(to_string(method));
    World world = world_of(method, Vec3::Zero());
    world.add_cube(0.5, m, {1, 0, 0});
    Vec3 x(1, 0, 0), v = Vec3::Zero();
    StepWorkspace workspace;
    StepReport report;
    double worst = 0;
    for (int k = 0; k < 300; ++k) {
      step(world.model, world.params, with_pull({0, Vec3::Zero(), target, kappa}), world.state, workspace,
           report);
      // (m/h²)(x − x − h v) + κ (x − t) = 0
      const Vec3 next = (m / (h * h) * (x + h * v) + kappa * target) / (m / (h * h) + kappa);
      v = (next - x) / h;
      x = next;
      worst = std::max(worst, (world.state.c[0] - x).norm());
    }
    CHECK(worst < 1e-9);
    CHECK(report.elastic == Approx(0.5 * kappa * (world.state.c[0] - target).squaredNorm()).epsilon(1e-9));
    CHECK(report.max_joint_error == 0);  // a spring is no joint
  }
}

TEST_CASE("a pulled body swings with ω² = κ/m to 1 % while h ω is small") {
  const double m = 3, kappa = 50, h = 1e-3;
  World world = world_of(SolverMethod::automatic, Vec3::Zero());
  world.params.h = h;
  world.add_cube(0.5, m, {1, 0, 0});
  double crossed = 0;
  int crossings = 0;
  double before = 1;
  testing::run(world, 4000, with_pull({0, Vec3::Zero(), Vec3::Zero(), kappa}), [&](const StepReport& r) {
    const double x = world.state.c[0].x();
    if (before * x < 0) {
      crossed = r.time;
      ++crossings;
    }
    before = x;
  });
  const double period = 2 * kPi * std::sqrt(m / kappa);
  REQUIRE(crossings == 5);  // at 1/4, 3/4, 5/4, … of a period
  CHECK(crossed == Approx((0.25 + 0.5 * (crossings - 1)) * period).epsilon(0.01));
}

TEST_CASE("a body that hangs from a pull comes to rest m g/κ below it, the held corner uppermost") {
  const double m = 2, kappa = 400, g = 9.81;
  const Vec3 held(0.2, 0.2, 0.2), target(0.1, 3, -0.4);
  for (const SolverMethod method : kMethods) {
    CAPTURE(to_string(method));
    World world = world_of(method, {0, -g, 0}, 60);
    world.params.h = 0.05;  // damps
    // sissm's own projection has another fixed point (Deviation D1).
    world.params.solver.projection = Projection::weighted;
    world.add_cube(0.4, m, {0.1, 2.5, -0.4});
    testing::run(world, 3000, with_pull({0, held, target, kappa}));
    const Vec3 y = world.state.c[0] + world.state.R[0] * held;
    CHECK((y - (target - Vec3(0, m * g / kappa, 0))).norm() < 1e-6);
    const Vec3 below = world.state.c[0] - y;
    CHECK(below.y() == Approx(-held.norm()).epsilon(1e-6));
  }
}

TEST_CASE("a fixed body is not pulled, and pulls that are gone leave no trace") {
  World pulled = world_of(SolverMethod::automatic, {0, -9.81, 0}, 20);
  pulled.add_ground();
  for (int k = 0; k < 3; ++k) pulled.add_cube(1, 100, {0, 0.509 + 1.01 * k, 0});
  World free = pulled;
  StepWorkspace used, fresh;
  StepReport report;
  State state = pulled.state;  // warms the workspace up with a pull
  step(pulled.model, pulled.params, with_pull({1, Vec3::Zero(), {5, 5, 5}, 1e4}), state, used, report);
  CHECK_FALSE(same_bits(state, pulled.state));
  for (int k = 0; k < 30; ++k) {
    step(pulled.model, pulled.params, with_pull({0, Vec3::Zero(), {5, 5, 5}, 1e6}), pulled.state, used,
         report);
    step(free.model, free.params, {}, free.state, fresh, report);
  }
  CHECK(same_bits(pulled.state, free.state));
}

TEST_CASE("every solver moves pulled links of a chain to the same E to 1e-9, for every thread count") {
  std::vector<double> energies;
  std::vector<State> ends;
  for (const SolverMethod method : {SolverMethod::newton, SolverMethod::descent, SolverMethod::automatic}) {
    World world = world_of(method, {0, -9.81, 0}, method == SolverMethod::descent ? 4000 : 40);
    for (int k = 0; k < 4; ++k) world.add(Box{{0.5, 0.1, 0.1}}, 2, {k + 0.5, 0, 0});
    for (int k = 0; k < 4; ++k) {
      const Index before = k == 0 ? kWorld : k - 1;
      Joint joint = testing::make_joint(world, JointType::spherical, before, k, Vec3(k, 0, 0));
      joint.law.kappa = 1e5;
      world.model.joints.push_back(joint);
      if (k > 0) world.model.no_collide.emplace_back(k - 1, k);
    }
    StepOptions options = with_pull({3, {0.5, 0, 0}, {3, 2, 1}, 2000});
    options.pulls.push_back({1, {0, 0.1, 0}, {1, -1, 0}, 500});
    options.record_iterations = true;
    World again = world;
    std::vector<double> energy;
    testing::run(world, 10, options, [&](const StepReport& r) { energy.push_back(r.records.back().energy); });
    energies.push_back(energy.front());
    ends.push_back(world.state);
    options.threads = 3;
    testing::run(again, 10, options);
    CHECK(same_bits(world.state, again.state));
  }
  CHECK(energies[1] == Approx(energies[0]).epsilon(1e-9));
  CHECK(energies[2] == Approx(energies[0]).epsilon(1e-9));
  // Descent's rounding of E leaves 1e-6 m a step.
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK((ends[1].c[i] - ends[0].c[i]).norm() < 2e-4);
    CHECK((ends[2].c[i] - ends[0].c[i]).norm() < 1e-9);
  }
  CHECK(ends[0].c[3].y() > 0.1);
}

TEST_CASE("a pull drags a crate over the ground when it is stronger than friction, and only then") {
  const double m = 10, mu = 0.5, g = 9.81, kappa = 200;
  const double holds = mu * m * g / kappa;  // stretch that friction holds; m
  for (const double stretch : {0.9 * holds, 1.3 * holds}) {
    World world = world_of(SolverMethod::automatic, {0, -g, 0}, 40);
    world.add_ground();
    world.add_cube(1, m, {0, 0.509, 0});
    testing::run(world, 60);
    const Vec3 start = world.state.c[1];
    testing::run(world, 60, with_pull({1, Vec3::Zero(), start + Vec3(stretch, 0, 0), kappa}));
    const double moved = world.state.c[1].x() - start.x();
    if (stretch < holds) {
      CHECK(std::abs(moved) < 1e-3);
    } else {
      CHECK(moved > 0.1 * holds);
    }
  }
}

}  // namespace pabd::test_pulls
