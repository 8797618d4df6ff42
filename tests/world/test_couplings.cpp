// SPDX-License-Identifier: MIT
// Joints that follow others, against closed forms: gears, rack and pinion, screws; what they hold and what they keep.
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/body/mass_properties.h"
#include "sim/body/shape_kind.h"
#include "tests/world/world.h"

namespace pabd::test_couplings {

using namespace world;

namespace {

constexpr double kThin = 0.1;

// A disc about z with a hinge to `on`, the world where that is empty.
std::string add_wheel(Setting& setting, double radius, double mass, const Vec3& at, const std::string& on,
                      spec::Joint joint = {}, std::optional<Keyed<Vec3>> torque = {}) {
  const std::string name = setting.add(spec::Body{.shape = make_shape("cylinder", {radius, kThin}),
                                                  .mass = mass,
                                                  .position = at,
                                                  .orientation = along_z(),
                                                  .torque = std::move(torque)});
  joint.type = JointType::hinge;
  joint.i = on;
  joint.j = name;
  joint.name = "hinge of " + name;
  joint.anchor = at;
  joint.axis = Vec3::UnitZ();
  setting.builder.add(joint);
  return name;
}

std::string hinge_of(const std::string& name) { return "hinge of " + name; }

double disc(double mass, double radius) { return 0.5 * mass * radius * radius; }

Keyed<Vec3> constant(const Vec3& v) { return {{{0, v}}}; }

}  // namespace

TEST_CASE("two gears turn as one: M = (I + r² I′) α, for turns without end and any ratio") {
  const double h = GENERATE(1.0 / 30, 1.0 / 60, 1.0 / 240), ratio = GENERATE(-2.0, -0.618, 7.25);
  const SolverMethod method = GENERATE(SolverMethod::automatic, SolverMethod::newton, SolverMethod::descent);
  CAPTURE(h, ratio, to_string(method));
  constexpr double kTorque = 1.5, kTime = 3;
  const double inertia = disc(2, 0.2) + ratio * ratio * disc(5, 0.3);
  Setting setting(h);
  setting.builder.params.solver.method = method;
  const std::string a = add_wheel(setting, 0.2, 2, {0, 0, 0}, "", {}, constant({0, 0, kTorque}));
  const std::string b =
      add_wheel(setting, 0.3, 5, {1, 0, 0}, "", {.follows = spec::Follows{hinge_of(a), ratio}});
  Run run(setting);
  run.go(kTime);
  CHECK(run.omega(a).z() == Approx(kTorque * kTime / inertia).epsilon(1e-4));
  CHECK(run.omega(b).z() == Approx(ratio * run.omega(a).z()).epsilon(1e-4));
  CHECK(run.at_limit + run.halved == 0);
  CHECK(run.joint_error < 1e-8);
  CHECK(run.rise < 1e-9);
  // The torque between them.
  const double passed = disc(5, 0.3) * ratio * kTorque / inertia;
  CHECK(run.report.joint_reports[1].coupling == Approx(passed).epsilon(1e-3));
  CHECK(run.report.joint_reports[0].coupling == 0);
}

TEST_CASE("a rack falls as its pinion lets it: m g = (m + I/r²) a") {
  const double h = GENERATE(1.0 / 60, 1.0 / 240), radius = 0.2, mass = 3;
  Setting setting(h);
  const std::string pinion = add_wheel(setting, radius, 2, {0, 0, 0}, "");
  const std::string rack = setting.add(Box{{0.025, 1, 0.05}}, mass, {0.25, 0, 0});
  setting.builder.add(spec::Joint{.type = JointType::slider,
                                  .j = rack,
                                  .anchor = Vec3(0.25, 0, 0),
                                  .axis = Vec3::UnitY(),
                                  .follows = spec::Follows{hinge_of(pinion), radius}});
  Run run(setting);
  run.go(1);
  CAPTURE(h);
  CHECK(run.v(rack).y() == Approx(-kG * mass / (mass + disc(2, radius) / (radius * radius))).epsilon(1e-4));
  CHECK(run.omega(pinion).z() * radius == Approx(run.v(rack).y()).epsilon(1e-5));
  CHECK(run.joint_error < 1e-8);
}

TEST_CASE("a nut falls down a screw as its lead lets it: m g = (m + I/p²) a, p = lead/2π") {
  const double h = GENERATE(1.0 / 60, 1.0 / 240), lead = GENERATE(0.3, -0.05, 2.0);
  Setting setting(h);
  const std::string nut = setting.add(make_shape("cylinder", {0.1, 0.1}), 2, {0, 0, 0});
  setting.builder.add(spec::Joint{.type = JointType::cylindrical,
                                  .j = nut,
                                  .anchor = Vec3(0, 0, 0),
                                  .axis = Vec3::UnitY(),
                                  .lead = lead});
  Run run(setting);
  run.go(1);
  const double p = lead / (2 * kPi);
  CAPTURE(h, lead);
  CHECK(run.v(nut).y() == Approx(-kG * 2 / (2 + disc(2, 0.1) / (p * p))).epsilon(1e-4));
  CHECK(run.omega(nut).y() * p == Approx(run.v(nut).y()).epsilon(1e-4));
}

// Nothing outside holds them: what one gets the others give.
TEST_CASE("gears on a body in free flight keep its momentum, however it tumbles") {
  const double h = GENERATE(1.0 / 60, 1.0 / 240), ratio = GENERATE(-2.0, 0.37);
  Setting setting(h);
  setting.builder.params.gravity.setZero();
  const std::string base = setting.add(spec::Body{.shape = Box{{1, 0.1, 0.1}},
                                                  .mass = 10,
                                                  .position = Vec3(0.5, 0, -0.3),
                                                  .angular_velocity = Vec3(100, 50, 30)});
  spec::Joint driven;
  driven.motor = spec::Motor{.force = Profile{{{0, 2.0}}}};
  const std::string a = add_wheel(setting, 0.2, 2, {0, 0, 0}, base, driven);
  add_wheel(setting, 0.3, 5, {1, 0, 0}, base, {.follows = spec::Follows{hinge_of(a), ratio}});
  Run run(setting);
  const auto spin = [&] {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < run.state.v.size(); ++i)
      sum += run.scene.model.mass[i] * run.state.c[i].cross(run.state.v[i]) +
             run.state.R[i] * inertia_tensor(run.scene.model.J[i]) * run.state.R[i].transpose() *
                 run.state.omega[i];
    return sum;
  };
  const Vec3 before = spin();
  run.go(3);
  CAPTURE(h, ratio);
  CHECK((spin() - before).norm() < 1e-11);
  CHECK(run.momentum().norm() < 1e-12);
  CHECK(run.joint_error < 1e-6);
}

// Fingers of a gripper that close together, each with half the force of the motor: 2 μ F/2 against m g.
TEST_CASE("a gripper whose fingers are coupled lifts what F μ > m g holds, and lets go of the rest") {
  const double h = GENERATE(1.0 / 60, 1.0 / 240);
  for (const double share : {0.93, 1.07}) {
    Setting setting(h, 0.5, 0.002);
    setting.ground();
    const std::string palm = setting.add(Box{{0.3, 0.05, 0.05}}, 1, {0, 0.5, 0});
    const std::string left = setting.add(Box{{0.02, 0.2, 0.05}}, 0.2, {-0.15, 0.25, 0});
    const std::string right = setting.add(Box{{0.02, 0.2, 0.05}}, 0.2, {0.15, 0.25, 0});
    const std::string load = setting.add(Box{{0.1, 0.1, 0.05}}, 1, {0.01, 0.101, 0});
    const auto slider = [&](const std::string& i, const std::string& j, const Vec3& at, const Vec3& axis) {
      return spec::Joint{.type = JointType::slider, .i = i, .j = j, .name = j, .anchor = at, .axis = axis};
    };
    spec::Joint lift = slider("", palm, {0, 0.5, 0}, Vec3::UnitY());
    lift.drive = Profile{{{0, 0.0}, {1, 0.0}, {2, 0.4}}};
    spec::Joint closes = slider(palm, left, {-0.15, 0.5, 0}, Vec3::UnitX());
    closes.motor = spec::Motor{.force = Profile{{{0, share * kG / 0.5}}}};
    spec::Joint follows = slider(palm, right, {0.15, 0.5, 0}, Vec3::UnitX());
    follows.follows = spec::Follows{left, -1};
    for (const spec::Joint& joint : {lift, closes, follows}) setting.builder.add(joint);
    Run run(setting);
    run.go(4);
    CAPTURE(h, share);
    CHECK(run.c(left).x() + run.c(right).x() == Approx(0).margin(1e-7));
    CHECK(run.c(load).x() == Approx(0).margin(1e-3));  // between them
    CHECK((run.c(load).y() > 0.35) == (share > 1));
  }
}

// The first is turned, each of the others follows the one before: the last turns as it does.
TEST_CASE("a train of gears on a beam that swings stays in step") {
  const double h = GENERATE(1.0 / 60, 1.0 / 240);
  const int count = GENERATE(3, 12);
  Setting setting(h);
  const std::string beam = setting.add(Box{{0.2 * count, 0.05, 0.05}}, 3, {0.2 * count, 0, -0.3});
  setting.join(JointType::hinge, "", beam, {0, 0, -0.3});
  std::vector<std::string> gears;
  for (int k = 0; k < count; ++k) {
    spec::Joint joint;
    if (k > 0)
      joint.follows = spec::Follows{hinge_of(gears.back()), -1};
    else
      joint.motor = spec::Motor{.force = Profile{{{0, 3.0}}}};
    gears.push_back(add_wheel(setting, 0.19, 1 + k % 3, {0.4 * k, 0, 0}, beam, joint));
  }
  Run run(setting);
  run.go(2);
  const double first = run.omega(gears.front()).z() - run.omega(beam).z();
  CAPTURE(h, count, first);
  for (int k = 1; k < count; ++k) {
    const double own = run.omega(gears[static_cast<std::size_t>(k)]).z() - run.omega(beam).z();
    CHECK(own == Approx(k % 2 ? -first : first).epsilon(1e-5));
  }
  CHECK(run.joint_error < 1e-6);
  CHECK(run.unsolved == 0);
}

}  // namespace pabd::test_couplings
