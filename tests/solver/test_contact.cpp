// SPDX-License-Identifier: MIT
// Contact forces against statics and conservation laws.

#include <catch2/catch.hpp>
#include <cmath>

#include "sim/math/so3.h"
#include "tests/support/scenario.h"

namespace pabd::test_contact {

using testing::World;

namespace {

Barrier barrier_of(const World& world) {
  const ContactParams& c = world.params.contact;
  return {c.barrier, c.N, c.d_hat, resolve_kappa(world.model, world.params), c.onset};
}

// The gap at which one contact carries `force`, by bisection.
double equilibrium_gap(const Barrier& barrier, double force) {
  double lo = 1e-9 * barrier.d_hat, hi = barrier.d_hat;
  for (int k = 0; k < 200; ++k) {
    const double mid = 0.5 * (lo + hi);
    (-evaluate(barrier, mid).first > force ? lo : hi) = mid;
  }
  return lo;
}

}  // namespace

// Gap of a 20 kg sphere that came to rest on a plane.
double resting_gap(World& world) {
  world.add_ground();
  world.add(Sphere{0.5}, 20, {0, 0.5 + 0.008, 0});
  testing::run(world, 600);
  CHECK(world.state.v[1].norm() < 1e-9);
  return world.state.c[1].y() - 0.5;
}

TEST_CASE("a sphere rests on a plane at the gap where −Ψ'(d) = m g, to 1e-6") {
  for (const auto& [method, projection] : {std::pair{SolverMethod::descent, Projection::tangent},
                                           std::pair{SolverMethod::descent, Projection::weighted},
                                           std::pair{SolverMethod::sissm, Projection::weighted}}) {
    for (const BarrierKind kind : {BarrierKind::polynomial, BarrierKind::even, BarrierKind::log}) {
      World world;
      world.params.solver.method = method;
      world.params.solver.projection = projection;
      world.params.solver.iterations = 60;
      world.params.solver.tolerance = 1e-12;
      world.params.contact.barrier = kind;
      world.params.contact.N = 4;
      world.params.contact.kappa = kind == BarrierKind::log ? 5e5 : 5.0;
      const double gap = resting_gap(world);
      INFO(to_string(method) << " " << to_string(projection) << " " << to_string(kind));
      CHECK(gap == Approx(equilibrium_gap(barrier_of(world), 20 * 9.81)).epsilon(1e-6));
    }
  }
}

TEST_CASE(
    "a sphere rests on the quadratic barrier where its closed form says, past the onset and within it") {
  const double force = 20 * 9.81, onset = 0.2;
  for (const double kappa : {5.0, 100.0}) {
    World world;
    world.params.contact.barrier = BarrierKind::quadratic;
    world.params.contact.kappa = kappa;
    world.params.contact.onset = onset;
    const double d_hat = world.params.contact.d_hat, load = force * d_hat / kappa;
    const double u = load > onset / 2 ? load + onset / 2 : std::sqrt(2 * onset * load);
    CHECK((u > onset) == (kappa == 5.0));
    CHECK(resting_gap(world) == Approx(d_hat * (1 - u)).epsilon(1e-6));
  }
}

// The affine step moves the lower face of a cube by h² f (1/m + r²/J) = 4 h² f/m, J = m r²/3; the projection
// takes three of the four parts back. At rest the global step carries the weight where the affine face is, so
// the projected one sits deeper: −4 Ψ'(d) = m g + 4 α · 3 g h², α the weight of the split.
TEST_CASE("sissm with the supplement's projection rests deeper, by the squeeze that is projected away") {
  World world;
  world.params.solver.method = SolverMethod::sissm;
  world.params.solver.projection = Projection::polar;
  world.params.solver.iterations = 200;
  world.params.solver.tolerance = 1e-12;
  world.params.contact.kappa = 5.0;
  world.params.contact.mu_static = world.params.contact.mu_dynamic = 0;  // friction would add to the weight α
  world.add_ground();
  world.add_cube(1, 20, {0, 0.5 + 0.008, 0});
  testing::run(world, 900);
  CHECK(world.state.v[1].norm() < 1e-9);
  const double gap = world.state.c[1].y() - 0.5;
  const Barrier barrier = barrier_of(world);
  const double squeeze = 3 * 9.81 * world.params.h * world.params.h;
  const double alpha = binomial_split(barrier, gap).stiffness;
  CHECK(-4 * evaluate(barrier, gap).first == Approx(20 * 9.81 + 4 * alpha * squeeze).epsilon(1e-6));
  CHECK(gap < equilibrium_gap(barrier, 5 * 9.81) - 0.1 * squeeze);
}

TEST_CASE("round bodies gain no energy from a hard landing without friction") {
  const auto drop = [](const Shape& shape) {
    World world;
    world.params.contact.mu_static = world.params.contact.mu_dynamic = 0;
    world.add_ground();
    const Mat3 tilt = Quat(0.866025, 0, 0, 0.5).normalized().toRotationMatrix();
    world.add(shape, 40, {0, 4, 0}, tilt);
    world.state.omega[1] = Vec3(30, 50, 0) * (kPi / 180);
    return world;
  };
  for (const Shape& shape : {Shape(Capsule{0.169, 0.26}), Shape(Sphere{0.3}), Shape(Box{{0.2, 0.3, 0.25}})}) {
    World world = drop(shape);
    const double start = 40 * 9.81 * 4 + 0.5 * world.state.omega[1].dot(inertia_tensor(world.model.J[1]) *
                                                                        world.state.omega[1]);
    double highest = 0, lowest = 1;
    testing::run(world, 600, {}, [&](const StepReport& r) {
      highest = std::max(highest, r.kinetic + r.potential);
      lowest = std::min(lowest, world.state.c[1].y());
    });
    CHECK(highest < start * 1.05);
    CHECK(lowest > 0.1);
  }
}

TEST_CASE("with κ auto a crate rests on four contacts that each carry a quarter of its weight") {
  World world;
  world.add_ground();
  world.add_cube(1, 1000, {0, 0.509, 0});
  StepReport last;
  testing::run(world, 300, {false, true, 1}, [&](const StepReport& r) { last = r; });
  REQUIRE(last.contact_reports.size() == 4);
  for (const ContactReport& c : last.contact_reports) {
    CHECK(c.normal_force == Approx(1000 * 9.81 / 4).epsilon(1e-6));
    CHECK(c.friction.norm() < 1e-6);
  }
}

TEST_CASE("the change of momentum and spin is the impulse of the reported contact forces") {
  World world;
  world.params.solver.iterations = 2000;
  world.params.solver.tolerance = 1e-13;
  world.params.contact.mu_static = world.params.contact.mu_dynamic = 0.3;
  world.add_ground();
  const Mat3 tilt = exp_so3({0.3, 0.5, -0.4});
  const double mass = 100;
  const Index box = world.add(Box{{0.5, 0.3, 0.4}}, mass, {0, 0.62, 0}, tilt);
  world.state.v[box] = {1, -3, 0.5};
  world.state.omega[box] = {1, -2, 0.7};
  const auto spin = [&] {
    const Mat3& R = world.state.R[box];
    return Vec3(R * inertia_tensor(world.model.J[box]) * R.transpose() * world.state.omega[box]);
  };
  const double h = world.params.h;
  int hits = 0;
  for (int k = 0; k < 30; ++k) {
    const Vec3 p0 = mass * world.state.v[box], L0 = spin();
    StepReport report;
    testing::run(world, 1, {false, true, 1}, [&](const StepReport& r) { report = r; });
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
    for (const ContactReport& c : report.contact_reports) {
      const Vec3 f = c.normal_force * c.n + c.friction;  // on b: the box
      force += f;
      torque += (c.y_b - world.state.c[box]).cross(f);
    }
    if (force.norm() > 1) ++hits;
    CHECK((mass * world.state.v[box] - p0 - h * (force + mass * world.params.gravity)).norm() < 1e-6 * mass);
    CHECK((spin() - L0 - h * torque).norm() < 1e-6 * mass);
  }
  CHECK(hits > 3);
}

TEST_CASE("two free boxes that collide keep their common momentum") {
  World world;
  world.params.gravity.setZero();
  world.params.solver.iterations = 2000;
  world.params.solver.tolerance = 1e-13;
  const Index a = world.add_cube(1, 5, {-0.8, 0, 0});
  const Index b = world.add_cube(1, 20, {0.8, 0.3, 0.1}, exp_so3({0.2, 0.4, 0.1}));
  world.state.v[a] = {4, 0, 0};
  testing::run(world, 60);
  const Vec3 momentum = 5 * world.state.v[a] + 20 * world.state.v[b];
  CHECK((momentum - Vec3(20, 0, 0)).norm() < 1e-6);
  CHECK(world.state.v[b].x() > 0.1);  // it was hit
}

TEST_CASE("boxes that start 0.1 inside each other separate and gain no more than the barrier held") {
  for (const SolverMethod method : {SolverMethod::descent, SolverMethod::sissm}) {
    World world;
    world.params.gravity.setZero();
    world.params.solver.method = method;
    world.params.solver.iterations = 100;
    world.params.contact.d_hat = 0.05;
    world.params.contact.kappa = 50;
    world.add_cube(1, 1000, {0, 0.5, 0});
    world.add_cube(1, 1000, {0.2, 1.4, 0.1});
    const double stored = 4 * evaluate(barrier_of(world), -0.1).value;  // four corners of the overlap
    StepReport last;
    testing::run(world, 240, {}, [&](const StepReport& r) {
      CHECK(r.status != StepStatus::non_finite);
      CHECK(r.kinetic + r.elastic <= stored * (1 + 1e-9));
      last = r;
    });
    INFO(to_string(method));
    CHECK(last.max_penetration == 0);
    CHECK(last.contacts == 0);
    CHECK(last.kinetic > 0);
  }
}

TEST_CASE("a log barrier that starts in penetration is reported, never silently force-free") {
  World world;
  world.params.contact.barrier = BarrierKind::log;
  world.add_ground();
  world.add(Sphere{0.5}, 20, {0, 0.49, 0});
  const State before = world.state;
  testing::run(world, 1, {}, [&](const StepReport& r) { CHECK(r.status == StepStatus::non_finite); });
  CHECK(world.state.c[1] == before.c[1]);
  CHECK(world.state.step == 0);
}

}  // namespace pabd::test_contact
