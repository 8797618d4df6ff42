// SPDX-License-Identifier: MIT
// `newton` and `auto`: the same minimum as the other solvers, which solver an island gets, and a double
// pendulum against its equations of motion.

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "sim/math/so3.h"
#include "tests/support/scenario.h"

namespace pabd::test_newton {

using testing::add_joint;
using testing::make_joint;
using testing::World;

namespace {

// E at the end of one step from the world's state.
double end_energy(World world, SolverMethod method, Projection projection, int iterations) {
  world.params.solver.method = method;
  world.params.solver.projection = projection;
  world.params.solver.iterations = iterations;
  world.params.solver.tolerance = 0;
  StepReport report;
  testing::run(world, 1, {true, false, 1}, [&](const StepReport& r) { report = r; });
  return report.records.back().energy;
}

// Cubes pushed into each other, without friction, whose bounds would differ between the solvers.
World pressed_stack() {
  World world;
  world.params.contact.mu_static = world.params.contact.mu_dynamic = 0;
  world.params.contact.d_hat = 0.05;
  world.params.contact.kappa = 1e4;
  world.params.contact.recovery_speed = 0;  // the barrier as it is, also for what stands too close
  world.add_ground();
  for (int k = 0; k < 4; ++k)
    world.add_cube(1, 100 * (k + 1), {0.1 * k, 0.5 + 1.01 * k, 0.05 * k}, exp_so3({0.01 * k, 0.2 * k, 0}));
  return world;
}

// Links on soft balls that swing.
World soft_chain(int links) {
  World world;
  for (int k = 0; k < links; ++k) world.add(Box{{0.5, 0.1, 0.1}}, 1 + k, {k + 0.5, 0, 0});
  for (int k = 0; k < links; ++k) {
    Joint joint = make_joint(world, JointType::spherical, k == 0 ? kWorld : k - 1, k, Vec3(k, 0, 0));
    joint.law.kappa = 1e5;
    world.model.joints.push_back(joint);
    if (k > 0) world.model.no_collide.emplace_back(k - 1, k);
  }
  for (Index i = 0; i < world.model.size(); ++i) world.state.omega[i] = {0.5, 1, -2};
  return world;
}

// How many bodies `newton` solves in the next step.
std::size_t newton_bodies(World& world) {
  StepWorkspace workspace;
  StepReport report;
  step(world.model, world.params, {}, world.state, workspace, report);
  std::size_t bodies = 0;
  for (const IslandReport& island : report.islands)
    bodies += island.solver == SolverMethod::newton ? static_cast<std::size_t>(island.bodies) : 0;
  return bodies;
}

// Angles and rates of two rods of length 1 and mass m from hanging, by their Lagrangian.
struct Rods {
  double angle[2], rate[2];
};

Rods derivative(const Rods& s, double I, double g) {
  // I: inertia of a rod about its end, for m = 1.
  const double difference = s.angle[0] - s.angle[1];
  const double M00 = I + 1, M11 = I, M01 = 0.5 * std::cos(difference);
  const double f0 = -0.5 * std::sin(difference) * s.rate[1] * s.rate[1] - 1.5 * g * std::sin(s.angle[0]);
  const double f1 = 0.5 * std::sin(difference) * s.rate[0] * s.rate[0] - 0.5 * g * std::sin(s.angle[1]);
  const double det = M00 * M11 - M01 * M01;
  return {{s.rate[0], s.rate[1]}, {(M11 * f0 - M01 * f1) / det, (M00 * f1 - M01 * f0) / det}};
}

Rods add(const Rods& s, double h, const Rods& d) {
  Rods out;
  for (int k = 0; k < 2; ++k) {
    out.angle[k] = s.angle[k] + h * d.angle[k];
    out.rate[k] = s.rate[k] + h * d.rate[k];
  }
  return out;
}

// Runge–Kutta of fourth order; its own error is far below what is compared.
Rods reference(Rods s, double I, double g, double time, int steps) {
  const double h = time / steps;
  for (int n = 0; n < steps; ++n) {
    const Rods a = derivative(s, I, g), b = derivative(add(s, h / 2, a), I, g),
               c = derivative(add(s, h / 2, b), I, g), d = derivative(add(s, h, c), I, g);
    s = add(add(add(add(s, h / 6, a), h / 3, b), h / 3, c), h / 6, d);
  }
  return s;
}

double angle_of(const Mat3& R) { return std::atan2(R(1, 0), R(0, 0)); }

}  // namespace

TEST_CASE("every solver ends at newton's E to 1e-6: contacts") {
  const World world = pressed_stack();
  const double newton = end_energy(world, SolverMethod::newton, Projection::automatic, 100);
  CHECK(end_energy(world, SolverMethod::automatic, Projection::automatic, 100) ==
        Approx(newton).epsilon(1e-6));
  CHECK(end_energy(world, SolverMethod::descent, Projection::tangent, 3000) == Approx(newton).epsilon(1e-6));
  CHECK(end_energy(world, SolverMethod::descent, Projection::weighted, 3000) == Approx(newton).epsilon(1e-6));
  CHECK(end_energy(world, SolverMethod::sissm, Projection::weighted, 20000) == Approx(newton).epsilon(1e-6));
}

TEST_CASE("every solver ends at newton's E to 1e-6: joints; sissm's own projection ends above it") {
  const World world = soft_chain(5);
  const double newton = end_energy(world, SolverMethod::newton, Projection::automatic, 50);
  CHECK(end_energy(world, SolverMethod::descent, Projection::tangent, 3000) == Approx(newton).epsilon(1e-6));
  CHECK(end_energy(world, SolverMethod::descent, Projection::weighted, 5000) == Approx(newton).epsilon(1e-6));
  CHECK(end_energy(world, SolverMethod::sissm, Projection::weighted, 20000) == Approx(newton).epsilon(1e-6));
  // polar(Â) forgets the weights: another fixed point (Deviation D1).
  CHECK(end_energy(world, SolverMethod::sissm, Projection::polar, 20000) > 1.001 * newton);
}

TEST_CASE("newton's last iterations on a jointed chain converge faster than linearly") {
  World world = soft_chain(30);
  world.params.solver.method = SolverMethod::newton;
  int fast = 0, steps = 0;
  testing::run(world, 20, {true, false, 1}, [&](const StepReport& r) {
    REQUIRE(r.status == StepStatus::converged);
    CHECK(r.iterations <= 10);
    const std::size_t n = r.records.size();
    ++steps;
    if (n >= 2 && r.records[n - 1].residual < 0.05 * r.records[n - 2].residual) ++fast;
  });
  CHECK(fast >= 0.9 * steps);
}

TEST_CASE("newton's last iterations on a hit beyond the onset of the barrier converge faster than linearly") {
  const double speed = GENERATE(1.5, 3.0, 6.0), mu = GENERATE(0.0, 0.5), tilt = GENERATE(0.0, 0.3);
  World world;
  world.params.solver.method = SolverMethod::newton;
  world.params.solver.halvings = 0;
  world.params.solver.iterations = 60;
  world.params.contact.mu_static = world.params.contact.mu_dynamic = mu;
  world.params.contact.kappa = 50 * speed;
  world.add_ground();
  const Index cube = world.add_cube(1, 1000, {0, 0.52 + 0.5 * std::sin(tilt) - 0.5 * (1 - std::cos(tilt)), 0},
                                    exp_so3({0, 0.4, tilt}));
  world.state.v[cube] = {0.3, -speed, 0};
  StepReport report;
  testing::run(world, 1, {true, false, 1}, [&](const StepReport& r) { report = r; });
  CAPTURE(speed, mu, tilt, report.min_gap, report.iterations);
  REQUIRE(report.status == StepStatus::converged);
  const std::size_t n = report.records.size();
  REQUIRE(report.min_gap < 0.8 * world.params.contact.d_hat);  // beyond ε = 0.2
  REQUIRE(n >= 3);
  CHECK(report.records[n - 1].residual < 0.05 * report.records[n - 2].residual);
}

TEST_CASE("a taut straight row of planks between two walls holds falling crates") {
  World world;
  const int planks = 20;
  for (int k = 0; k < planks; ++k) world.add(Box{{0.14, 0.03, 0.5}}, 10, {0.3 * (k + 0.5), 0, 0});
  for (int k = 0; k <= planks; ++k)
    add_joint(world, make_joint(world, JointType::hinge, k == 0 ? kWorld : k - 1, k == planks ? kWorld : k,
                                {0.3 * k, 0, 0}));
  for (int k = 0; k < 3; ++k) world.add_cube(0.5, 125, {1 + 2.0 * k, 1 + 0.5 * k, 0});
  for (int k = 0; k < planks; ++k) {  // neighbours do not collide
    if (k + 1 < planks) world.model.no_collide.emplace_back(k, k + 1);
  }
  double worst = 0;
  testing::run(world, 240, {}, [&](const StepReport& r) {
    REQUIRE(r.status != StepStatus::non_finite);
    worst = std::max(worst, r.max_joint_error);
  });
  CHECK(worst < 1e-5);
  for (int k = 0; k < 3; ++k) CHECK(world.state.c[planks + k].y() > 0.2);
}

TEST_CASE("auto: newton for joints, stacks at rest and large mass ratios, descent for what moves in a heap") {
  World stack;
  stack.add_ground();
  for (int k = 0; k < 5; ++k) stack.add_cube(1, 100, {0, 0.509 + 1.009 * k, 0});
  CHECK(newton_bodies(stack) == 5);

  World jointed = soft_chain(3);
  CHECK(newton_bodies(jointed) == 3);

  World heap;  // 5 × 5 × 5 cubes that fall on each other
  heap.add_ground();
  for (int k = 0; k < 125; ++k) {
    heap.add_cube(0.5, 10, {0.505 * (k % 5), 0.25 + 0.505 * (k / 25), 0.505 * (k / 5 % 5)});
    heap.state.v.back() = {0, -1, 0};
  }
  heap.params.solver.halvings = 0;  // halves go to newton
  CHECK(newton_bodies(heap) == 0);
  heap.params.solver.method = SolverMethod::newton;
  CHECK(newton_bodies(heap) == 125);
}

TEST_CASE("newton gives the same bytes for 1, 2 and 8 threads") {
  std::vector<State> ends;
  for (const int threads : {1, 2, 8}) {
    World world = pressed_stack();
    world.params.solver.method = SolverMethod::newton;
    testing::run(world, 20, {false, false, threads});
    ends.push_back(world.state);
  }
  for (const State& end : ends) {
    for (std::size_t i = 0; i < end.c.size(); ++i) {
      CHECK(std::memcmp(end.c[i].data(), ends[0].c[i].data(), sizeof(Vec3)) == 0);
      CHECK(std::memcmp(end.R[i].data(), ends[0].R[i].data(), sizeof(Mat3)) == 0);
    }
  }
}

TEST_CASE("a double pendulum follows its equations of motion for 10 s, with an error that falls as h²") {
  const double start[2] = {0.35, 0.6}, width = 0.04, g = 9.81;
  const double I = (1 + width * width) / 12 + 0.25;
  const Rods exact = reference({{start[0], start[1]}, {0, 0}}, I, g, 10, 20000);
  std::vector<double> errors;
  for (const int steps_a_second : {500, 1000}) {
    World world;
    world.params.h = 1.0 / steps_a_second;
    world.params.solver.integrator = Integrator::bdf2;
    Vec3 end = Vec3::Zero();
    for (int k = 0; k < 2; ++k) {
      const Mat3 R = exp_so3({0, 0, start[k]});
      world.add(Box{{width / 2, 0.5, width / 2}}, 1, end + R * Vec3(0, -0.5, 0), R);
      add_joint(world, make_joint(world, JointType::hinge, k == 0 ? kWorld : 0, k, end));
      end += R * Vec3(0, -1, 0);
    }
    world.model.no_collide.emplace_back(0, 1);
    testing::run(world, 10 * steps_a_second);
    double error = 0;
    for (int k = 0; k < 2; ++k) error = std::hypot(error, angle_of(world.state.R[k]) - exact.angle[k]);
    errors.push_back(error);
  }
  INFO(errors[0] << " " << errors[1]);
  CHECK(errors[0] < 1e-3);
  CHECK(errors[1] < 0.27 * errors[0]);
  CHECK(errors[1] > 0.23 * errors[0]);
}

}  // namespace pabd::test_newton
