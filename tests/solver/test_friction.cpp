// SPDX-License-Identifier: MIT
// A crate on a slope: it sticks below the friction angle and slides above it with Coulomb's acceleration.

#include <catch2/catch.hpp>
#include <cmath>

#include "sim/math/so3.h"
#include "tests/support/scenario.h"

namespace pabd::test_friction {

using testing::World;

namespace {

struct Slope {
  World world;
  Vec3 down;  // unit, along the slope
};

Slope crate_on_slope(double degrees, double mu) {
  const double angle = degrees * kPi / 180;
  Slope s;
  s.world.params.solver.method = SolverMethod::descent;
  s.world.params.contact.mu_static = s.world.params.contact.mu_dynamic = mu;
  const Mat3 tilt = exp_so3({0, 0, angle});
  s.down = -(tilt * Vec3::UnitX());
  s.world.add_ground(tilt * Vec3::UnitY());
  s.world.add(Box{{0.5, 0.1, 0.5}}, 200, tilt * Vec3(0, 0.1 + 0.0099, 0), tilt);
  return s;
}

}  // namespace

TEST_CASE("μ = 0.5 sticks at 26° without creeping") {
  Slope s = crate_on_slope(26, 0.5);
  testing::run(s.world, 120);
  const Vec3 start = s.world.state.c[1];
  testing::run(s.world, 300);
  CHECK((s.world.state.c[1] - start).norm() < 1e-6);
  CHECK(s.world.state.v[1].norm() < 1e-6);
}

TEST_CASE("μ = 0.5 slides at 27°, 30° and 45° with g (sin θ − μ cos θ), to 1 %") {
  for (const double degrees : {27.0, 30.0, 45.0}) {
    Slope s = crate_on_slope(degrees, 0.5);
    testing::run(s.world, 60);
    const double v0 = s.world.state.v[1].dot(s.down);
    testing::run(s.world, 60);
    const double v1 = s.world.state.v[1].dot(s.down);
    const double angle = degrees * kPi / 180;
    INFO(degrees << "°");
    CHECK(v1 - v0 == Approx(9.81 * (std::sin(angle) - 0.5 * std::cos(angle))).epsilon(0.01));
  }
}

TEST_CASE("without friction the crate slides with g sin θ") {
  Slope s = crate_on_slope(20, 0);
  testing::run(s.world, 60);
  CHECK(s.world.state.v[1].dot(s.down) == Approx(9.81 * std::sin(20 * kPi / 180)).epsilon(1e-3));
}

TEST_CASE("static and dynamic friction differ: between their angles only what rests stays") {
  for (const double push : {0.0, 0.5}) {
    Slope s = crate_on_slope(22, 0.5);  // tan 22° = 0.40
    s.world.params.contact.mu_dynamic = 0.2;
    const Vec3 gravity =
        s.world.params.gravity;  // let it settle under its weight first: landing would break it loose
    s.world.params.gravity = gravity - s.down * s.down.dot(gravity);
    testing::run(s.world, 60);
    s.world.params.gravity = gravity;
    s.world.state.v[1] = push * s.down;
    testing::run(s.world, 120);
    const double speed = s.world.state.v[1].dot(s.down);
    if (push == 0) {
      CHECK(std::abs(speed) < 1e-6);
    } else {
      CHECK(
          speed ==
          Approx(0.5 + 2 * 9.81 * (std::sin(22 * kPi / 180) - 0.2 * std::cos(22 * kPi / 180))).epsilon(0.02));
    }
  }
}

TEST_CASE("a sphere rolls down a slope at 5/7 of g sin θ") {
  World world;
  world.params.solver.method = SolverMethod::descent;
  const double angle = 10 * kPi / 180;
  const Mat3 tilt = exp_so3({0, 0, angle});
  world.add_ground(tilt * Vec3::UnitY());
  world.add(Sphere{0.5}, 10, tilt * Vec3(0, 0.5 + 0.0095, 0));
  testing::run(world, 60);
  const Vec3 down = -(tilt * Vec3::UnitX());
  const double v0 = world.state.v[1].dot(down);
  testing::run(world, 60);
  CHECK(world.state.v[1].dot(down) - v0 == Approx(5.0 / 7 * 9.81 * std::sin(angle)).epsilon(0.02));
  CHECK(world.state.omega[1].norm() * 0.5 == Approx(world.state.v[1].norm()).epsilon(0.03));
}

}  // namespace pabd::test_friction
