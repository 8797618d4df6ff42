// SPDX-License-Identifier: MIT
// Bodies that nothing touches, against the discrete solution and conservation laws.

#include <catch2/catch.hpp>

#include "sim/math/so3.h"
#include "tests/support/scenario.h"

namespace pabd::test_free_flight {

using testing::World;

namespace {

Vec3 angular_momentum(const World& world, Index i) {
  const Mat3& R = world.state.R[i];
  return R * inertia_tensor(world.model.J[i]) * R.transpose() * world.state.omega[i];
}

double spin_energy(const World& world, Index i) {
  return 0.5 * world.state.omega[i].dot(angular_momentum(world, i));
}

World spinning_box(const Vec3& omega) {
  World world;
  world.params.gravity.setZero();
  world.add(Box{{0.5, 0.3, 0.1}}, 12, Vec3::Zero());  // three different moments
  world.state.omega[0] = omega;
  return world;
}

}  // namespace

TEST_CASE("a projectile follows its parabola, by Euler the discrete one, to 1e-9 relative") {
  World world;
  world.params.solver.integrator = GENERATE(Integrator::bdf2, Integrator::euler);
  world.add(Sphere{0.1}, 3, {1, 50, -2});
  const Vec3 v0(4, 6, -1);
  world.state.v[0] = v0;
  const int n = 180;
  testing::run(world, n);
  // Semi-implicit Euler: v_n = v_0 + n h g, c_n = c_0 + n h v_0 + h² g n(n+1)/2.
  const int more = world.params.solver.integrator == Integrator::euler ? 1 : 0;
  const double h = world.params.h;
  const Vec3 v = v0 + n * h * world.params.gravity;
  const Vec3 c = Vec3(1, 50, -2) + n * h * v0 + h * h * world.params.gravity * (0.5 * n * (n + more));
  CHECK((world.state.v[0] - v).norm() < 1e-9 * v.norm());
  CHECK((world.state.c[0] - c).norm() < 1e-9 * c.norm());
}

TEST_CASE("a free spinning box keeps its angular momentum to 1e-10") {
  World world = spinning_box({3, 6, -2});
  const Vec3 before = angular_momentum(world, 0);
  testing::run(world, 1000);
  CHECK((angular_momentum(world, 0) - before).norm() < 1e-10 * before.norm());
  CHECK((world.state.R[0].transpose() * world.state.R[0] - Mat3::Identity()).norm() < 1e-14);
}

TEST_CASE("a body spinning about a principal axis keeps its speed: no numerical damping") {
  World world = spinning_box({0, 0, 6});
  testing::run(world, 1000);
  CHECK(world.state.omega[0].z() == Approx(6).epsilon(1e-12));
}

TEST_CASE("spin about the middle axis flips over (Dzhanibekov), about the others it stays") {
  // Box 1.0 × 0.6 × 0.2: I_x < I_y < I_z, so y is the unstable axis.
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 omega = Vec3::Constant(1e-3);
    omega[axis] = 8;
    World world = spinning_box(omega);
    const double energy = spin_energy(world, 0);
    double lowest = 1;
    testing::run(world, 1200, {}, [&](const StepReport&) {
      const Vec3 body_axis = world.state.R[0].col(axis);
      lowest = std::min(lowest, body_axis[axis]);
    });
    INFO("axis " << axis << ", lowest cosine " << lowest);
    if (axis == 1) {
      CHECK(lowest < -0.99);  // the body turned over
    } else {
      CHECK(lowest > 0.999);
    }
    CHECK(spin_energy(world, 0) == Approx(energy).epsilon(1e-11));
  }
}

TEST_CASE(
    "free rotation keeps energy and angular momentum to 1e-12 a step, for boxes, rods and plates at any "
    "speed") {
  const double turns = GENERATE(0.01, 0.3, 1.0, 2.5, 20.0, 60.0);  // ‖ω‖ h; rad
  const Vec3 half =
      GENERATE(Vec3(0.5, 0.3, 0.1), Vec3(0.5, 0.02, 0.021), Vec3(0.3, 0.31, 0.32), Vec3(0.5, 0.5, 0.01));
  const Vec3 about = GENERATE(Vec3(1, 2, 3), Vec3(0.01, 1, -0.02), Vec3(-5, 0.1, 1));
  World world;
  world.params.gravity.setZero();
  world.add(Box{half}, 12, Vec3::Zero());
  world.state.omega[0] = turns / world.params.h * about.normalized();
  const Vec3 momentum = angular_momentum(world, 0);
  const double energy = spin_energy(world, 0);
  testing::run(world, 100);
  INFO("‖ω‖h " << turns << ", half " << half.transpose() << ", about " << about.transpose());
  CHECK((angular_momentum(world, 0) - momentum).norm() < 1e-10 * momentum.norm());
  CHECK(std::abs(spin_energy(world, 0) - energy) < 1e-10 * energy);
}

}  // namespace pabd::test_free_flight
