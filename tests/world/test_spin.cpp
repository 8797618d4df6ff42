// SPDX-License-Identifier: MIT
// Tops, gyroscopes and bodies that spin freely.
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/body/mass_properties.h"
#include "sim/body/shape_kind.h"
#include "tests/world/world.h"

namespace pabd::test_spin {

using namespace world;

// The bicycle wheel on a string: Goldstein, Classical Mechanics, section 5.7. Steps of implicit Euler are of first order.
TEST_CASE("a gyroscope with a level axle turns with m g l/(I ω)") {
  const double radius = GENERATE(0.05, 0.3), spin = GENERATE(40.0, 120.0);  // in units of sqrt(g/r)/10
  CAPTURE(radius, spin);
  const double h = 1.0 / 2000, arm = 0.8 * radius, rate = 0.1 * spin * std::sqrt(kG / radius);
  Setting setting(h);
  const std::string wheel = setting.add(spec::Body{.shape = make_shape("cylinder", {radius, 0.1 * radius}),
                                                   .mass = 2.0,
                                                   .position = Vec3(arm, 0, 0),
                                                   .orientation = along_x()});
  setting.join(JointType::spherical, "", wheel, Vec3::Zero());
  Run run(setting);
  const double precession = kG * arm / (radius * radius / 2 * rate);
  run.send(wheel, Vec3(0, precession, 0).cross(Vec3(arm, 0, 0)), {rate, precession, 0});
  const double seconds = 0.5 / precession;
  run.go(seconds);
  const double angle = std::atan2(-run.c(wheel).z(), run.c(wheel).x());
  CHECK(angle == Approx(precession * run.state.time).epsilon(0.01));
  CHECK(std::abs(run.c(wheel).y()) < 0.02 * arm);
  CHECK(run.rise < 1e-6 * run.begin);
}

// Explicit gyroscopic terms blow up: avian issue 400 and pull request 420; Catto's talk of 2015 on numerical methods.
TEST_CASE("a slim body that spins fast about any axis keeps its angular momentum and makes no energy") {
  const Vec3 axis = GENERATE(Vec3(1, 0.1, 0), Vec3(0.1, 1, 0.05), Vec3(0.02, 0.1, 1));
  const double slim = GENERATE(0.3, 0.03), rate = GENERATE(10.0, 200.0), h = GENERATE(1.0 / 60, 1.0 / 500);
  CAPTURE(axis.transpose(), slim, rate, h);
  Setting setting(h);
  setting.builder.params.gravity = Vec3::Zero();
  const std::string rod = setting.add(
      spec::Body{.shape = Box{Vec3(1, slim, 0.6 * slim) / 2}, .mass = 1.0, .position = Vec3(0, 0, 0)});
  Run run(setting);
  run.send(rod, Vec3::Zero(), rate * axis);
  const Mat3 I = inertia_tensor(run.scene.model.J[0]);
  const auto angular = [&]() -> Vec3 { return run.R(rod) * I * run.R(rod).transpose() * run.omega(rod); };
  const Vec3 before = angular();
  run.go(2);
  CHECK((angular() - before).norm() < 1e-9 * before.norm());
  CHECK(run.rise < 0.01 * run.begin);  // the midpoint rule's own error, which comes and goes
}

// A spinning box on a table: friction at four corners, at the half diagonal ρ, slows it by 3 μ g/ρ.
TEST_CASE("a box that spins on the floor slows down by 3 μ g/ρ and stops") {
  const double mu = GENERATE(0.1, 0.4), edge = GENERATE(0.1, 0.8), h = GENERATE(1.0 / 60, 1.0 / 240);
  CAPTURE(mu, edge, h);
  Setting setting(h, mu, 0.005 * edge);
  setting.ground();
  const std::string box = setting.add(Box{Vec3(1, 0.1, 0.7) * edge / 2}, 3, {0, 0.055 * edge, 0});
  Run run(setting);
  run.go(0.3);
  const double rho = edge / 2 * std::sqrt(1 + 0.49), slowing = 3 * mu * kG / rho, rate = slowing * 0.5;
  run.send(box, Vec3::Zero(), {0, rate, 0});
  run.go(0.25);
  CHECK(run.omega(box).y() == Approx(rate - slowing * 0.25).epsilon(0.02));
  run.go(0.5);
  CHECK(run.omega(box).norm() < 1e-6);
  CHECK(run.rise < 1e-9);
}

}  // namespace pabd::test_spin
