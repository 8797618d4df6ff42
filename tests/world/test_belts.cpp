// SPDX-License-Identifier: MIT
// Surfaces that move of themselves carry what touches them by friction, as closed forms have it.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/world/world.h"

namespace pabd::test_belts {

using namespace world;

namespace {

constexpr double kSpeed = 1.5, kMu = 0.4;

// A fixed box whose top is at y = 0, turned about y.
void add_belt(Setting& setting, const Vec3& velocity, double degrees = 0) {
  setting.add(spec::Body{.name = "belt",
                         .shape = Box{{20, 0.1, 20}},
                         .fixed = true,
                         .position = Vec3(0, -0.1, 0),
                         .orientation = spec::AxisAngle{Vec3::UnitY(), degrees},
                         .surface_velocity = velocity});
}

}  // namespace

TEST_CASE(
    "a box that is put on a belt is taken along with μ g until it is as fast, whichever way the belt lies") {
  const double h = GENERATE(1.0 / 60, 1.0 / 240), degrees = GENERATE(0.0, 35.0, 200.0);
  const SolverMethod method = GENERATE(SolverMethod::automatic, SolverMethod::descent);
  CAPTURE(h, degrees);
  Setting setting(h, kMu);
  setting.builder.params.solver.method = method;
  add_belt(setting, {kSpeed, 0, 0}, degrees);
  const std::string box = setting.add(Box{{0.2, 0.1, 0.2}}, 3, {0, 0.11, 0});
  Run run(setting);
  const Vec3 way = Mat3(Eigen::AngleAxisd(degrees * kDegree, Vec3::UnitY())) * Vec3::UnitX();
  run.go(0.2);
  CHECK((run.v(box) - kMu * kG * 0.2 * way).norm() < 0.02);
  run.go(1.8);
  CHECK((run.v(box) - kSpeed * way).norm() < 1e-3);
  CHECK(run.omega(box).norm() < 1e-3);
  // Half of what the belt does is heat.
  CHECK(run.work == Approx(3 * kSpeed * kSpeed).epsilon(0.05));
  CHECK(run.held == 0);
}

TEST_CASE("a ball that is put on a belt rolls with two sevenths of its speed") {
  const double h = GENERATE(1.0 / 60, 1.0 / 240), radius = GENERATE(0.05, 0.4);
  CAPTURE(h, radius);
  Setting setting(h, kMu);
  add_belt(setting, {kSpeed, 0, 0});
  const std::string ball = setting.add(Sphere{radius}, 2, {0, radius + 0.01, 0});
  Run run(setting);
  run.go(2);
  CHECK(run.v(ball).x() == Approx(2 * kSpeed / 7).epsilon(2e-3));
  CHECK(run.omega(ball).z() == Approx(5 * kSpeed / 7 / radius).epsilon(0.02));
}

TEST_CASE("a belt carries a box uphill where its friction is above the slope, and not where it is below") {
  for (const double share : {1.2, 0.8}) {
    CAPTURE(share);
    const double degrees = 20, mu = share * std::tan(degrees * kDegree);
    Setting setting(1.0 / 120, mu);
    const spec::Orientation turn = about_z(-degrees);
    setting.add(spec::Body{.shape = Box{{20, 0.1, 2}},
                           .fixed = true,
                           .position = -0.1 * uphill_normal(degrees),
                           .orientation = turn,
                           .surface_velocity = Vec3(-1, 0, 0)});
    const std::string box = setting.add(Box{{0.2, 0.1, 0.2}}, 3, 0.11 * uphill_normal(degrees), turn);
    Run run(setting);
    run.go(3);
    const double down = run.v(box).dot(downhill(degrees));
    if (share > 1) CHECK(down == Approx(-1).epsilon(1e-3));
    if (share < 1)
      CHECK(down ==
            Approx(3 * kG * (std::sin(degrees * kDegree) - mu * std::cos(degrees * kDegree))).epsilon(0.01));
  }
}

TEST_CASE("a body with a belt drives off on the ground, its wheels being its surface") {
  Setting setting(1.0 / 120, 0.6);
  setting.ground();
  const std::string tank = setting.add(spec::Body{.shape = Box{{0.5, 0.2, 0.3}},
                                                  .mass = 40.0,
                                                  .position = Vec3(0, 0.21, 0),
                                                  .surface_velocity = Vec3(-1, 0, 0)});
  Run run(setting);
  run.go(2);
  CHECK(run.v(tank).x() == Approx(1).epsilon(1e-3));
}

TEST_CASE("a belt that floats gives what it takes: momentum is kept") {
  const double h = GENERATE(1.0 / 60, 1.0 / 240);
  CAPTURE(h);
  Setting setting(h, 0.5);
  setting.builder.params.gravity.setZero();
  setting.add(spec::Body{.shape = Box{{1, 0.1, 1}},
                         .mass = 5.0,
                         .position = Vec3(0, -0.11, 0),
                         .surface_velocity = Vec3(2, 0, 0)});
  setting.add(spec::Body{
      .shape = Box{{0.3, 0.3, 0.3}}, .mass = 1.0, .position = Vec3(0, 0.32, 0), .velocity = Vec3(0, -1, 0)});
  Run run(setting);
  const Vec3 before = run.momentum();
  run.go(0.5);
  CHECK((run.momentum() - before).norm() < 1e-9);
  CHECK(run.v("b1").x() > 0.05);
}

}  // namespace pabd::test_belts
