// SPDX-License-Identifier: MIT
// Bodies that nothing outside holds keep their momentum in every step, converged or not.

#include <catch2/catch.hpp>

#include "tests/support/scenario.h"

namespace pabd::test_momentum {

namespace {

struct Momentum {
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();  // about the origin
};

Momentum momentum_of(const testing::World& world) {
  Momentum sum;
  for (Index i = 0; i < world.model.size(); ++i) {
    if (world.model.fixed[i]) continue;
    const Vec3 p = world.model.mass[i] * world.state.v[i];
    const Mat3& R = world.state.R[i];
    sum.linear += p;
    sum.angular += world.state.c[i].cross(p) +
                   R * (inertia_tensor(world.model.J[i]) * (R.transpose() * world.state.omega[i]));
  }
  return sum;
}

// Steps, and checks every one against what its bodies exchanged: Σ m ‖Δv‖, and Σ ‖c‖ m ‖Δv‖ for the moments.
// Returns what was exchanged in all steps.
double check_each_step(testing::World& world, int steps) {
  StepWorkspace workspace;
  StepReport report;
  double all = 0;
  for (int k = 0; k < steps; ++k) {
    const Momentum before = momentum_of(world);
    const State start = world.state;
    step(world.model, world.params, {}, world.state, workspace, report);
    const Momentum after = momentum_of(world);
    double exchanged = 0, moment = 0, weight = 0;
    Vec3 fallen = Vec3::Zero(), turned = Vec3::Zero();
    for (Index i = 0; i < world.model.size(); ++i) {
      const double m = world.model.mass[i];
      const Vec3 fall = m * world.params.h * world.params.gravity;
      const Vec3 p = m * (world.state.v[i] - start.v[i]) - fall;
      exchanged += p.norm();
      moment += start.c[i].norm() * p.norm() + m * (world.state.omega[i] - start.omega[i]).norm();
      weight += m * world.state.v[i].norm();  // rounding of what is there
      fallen += fall;
      turned += start.c[i].cross(fall);
    }
    CAPTURE(k, exchanged, weight, to_string(report.status));
    CHECK((after.linear - before.linear - fallen).norm() <= 1e-9 * exchanged + 1e-13 * weight);
    CHECK((after.angular - before.angular - turned).norm() <= 1e-9 * moment + 1e-12 * weight);
    all += exchanged;
  }
  return all;
}

// A block of n³ cubes, d̂ apart, in weightlessness.
void add_block(testing::World& world, int n, const Vec3& centre) {
  const double pitch = 0.5 + world.params.contact.d_hat;
  for (int k = 0; k < n * n * n; ++k) {
    const Vec3 place(k % n, k / n % n, k / (n * n));
    world.add_cube(0.5, 60, centre + pitch * (place - Vec3::Constant(0.5 * (n - 1))));
  }
}

testing::World block_hit_by_a_ball(int n, const Vec3& from, const Vec3& velocity) {
  testing::World world;
  world.params.gravity.setZero();
  add_block(world, n, Vec3::Zero());
  world.state.v[world.add(Sphere{0.3}, 150, from)] = velocity;
  return world;
}

}  // namespace

TEST_CASE("a block of cubes that a ball hits keeps momentum, however few iterations") {
  const auto method =
      GENERATE(SolverMethod::automatic, SolverMethod::descent, SolverMethod::newton, SolverMethod::sissm);
  const auto iterations = GENERATE(1, 4, 20);
  testing::World world = block_hit_by_a_ball(4, {-1.5, 0.35, 0.4}, {7, 0.5, -1});
  world.params.solver.method = method;
  world.params.solver.iterations = iterations;
  CAPTURE(to_string(method), iterations);
  CHECK(check_each_step(world, 12) > 300);  // the ball brings 1065 N s
}

TEST_CASE("momentum at other steps, coefficients, sizes and under gravity") {
  const auto h = GENERATE(1.0 / 30, 1.0 / 240, 1.0 / 1000);
  const auto mu = GENERATE(0.0, 0.9);
  testing::World world = block_hit_by_a_ball(3, {0.2, 1.3, -0.1}, {0, -11, 2});
  world.params.h = h;
  world.params.contact.mu_static = world.params.contact.mu_dynamic = mu;
  world.params.gravity = Vec3(0.3, -9.81, 0);
  // Weight turns by the levers of the start of each half, and of the middle of a parabola.
  world.params.solver.halvings = 0;
  world.params.solver.integrator = Integrator::euler;
  CAPTURE(h, mu);
  CHECK(check_each_step(world, static_cast<int>(0.15 / h)) > 100);
}

TEST_CASE("a free chain that turns keeps its angular momentum") {
  testing::World world;
  world.params.gravity.setZero();
  constexpr int kLinks = 7;
  const Vec3 spin(0, 0.5, 4);
  for (int k = 0; k < kLinks; ++k) {
    const Vec3 place(0, 0.5 * k, 0);
    world.add(Capsule{0.05, 0.2}, 2, place);
    world.state.v.back() = spin.cross(place);
    world.state.omega.back() = spin;
  }
  for (Index k = 0; k + 1 < kLinks; ++k)
    add_joint(world, make_joint(world, JointType::spherical, k, k + 1, Vec3(0, 0.5 * k + 0.25, 0)));
  const auto method = GENERATE(SolverMethod::newton, SolverMethod::descent);
  world.params.solver.method = method;
  world.params.contact.mu_static = world.params.contact.mu_dynamic = 0;
  world.model.no_collide.clear();
  for (Index k = 0; k + 1 < kLinks; ++k) world.model.no_collide.emplace_back(k, k + 1);
  CAPTURE(to_string(method));
  const double L = momentum_of(world).angular.norm();
  CHECK(check_each_step(world, 60) > 1);
  CHECK(momentum_of(world).angular.norm() == Approx(L).epsilon(1e-9));
}

TEST_CASE("what a ball does not touch does not feel it") {
  testing::World world = block_hit_by_a_ball(2, {-0.85, 0, 0}, {3, 0, 0});
  // Beside the block, within reach of detection, and never touched: it leaves faster than the block breaks.
  const Index alone = world.add_cube(0.5, 60, {0, 0.505 + 0.014 + 0.25, 0});
  world.state.v[alone] = {0.1, 2, 0.2};
  testing::run(world, 30);
  CHECK(world.state.v[alone] == Vec3(0.1, 2, 0.2));
  CHECK(world.state.omega[alone] == Vec3::Zero());
}

}  // namespace pabd::test_momentum
