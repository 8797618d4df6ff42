// SPDX-License-Identifier: MIT
// Reactions of joints against statics.

#include <catch2/catch.hpp>
#include <cmath>

#include "sim/joint/expand.h"
#include "tests/support/scenario.h"

namespace pabd::test_joint_reactions {

using testing::World;

namespace {

// Of the weight of all bodies. Automatic κ stretches by 1e-8 of the thinnest body under it: the rounding of
// positions, 1e-16 m a metre, is 1e-7 of it.
constexpr double kExact = 5e-6;

// The reactions of the last step.
std::vector<JointReport> reactions_after(World& world, int steps) {
  StepOptions options;
  options.report_joints = true;
  std::vector<JointReport> out;
  testing::run(world, steps, options, [&](const StepReport& r) {
    REQUIRE(r.status == StepStatus::converged);
    out = r.joint_reports;
  });
  REQUIRE(out.size() == world.model.joints.size());
  return out;
}

void check(const Vec3& actual, const Vec3& expected, double scale) {
  INFO(actual.transpose() << " instead of " << expected.transpose());
  CHECK((actual - expected).norm() <= kExact * scale);
}

}  // namespace

TEST_CASE("a hanging chain: every joint carries what hangs below it") {
  for (const BondPotential potential : {BondPotential::soft, BondPotential::hard}) {
    World world;
    const int links = 7;
    std::vector<double> below(links, 0.0);  // mass; kg
    double total = 0;
    for (int k = links - 1; k >= 0; --k) {
      total += 0.5 + 1.3 * k;
      below[static_cast<std::size_t>(k)] = total;
    }
    for (int k = 0; k < links; ++k) world.add(Box{{0.05, 0.18, 0.05}}, 0.5 + 1.3 * k, {2, -0.4 * k - 0.2, 1});
    for (int k = 0; k < links; ++k) {
      Joint joint = make_joint(world, JointType::spherical, k == 0 ? kWorld : k - 1, k, {2, -0.4 * k, 1});
      joint.law.potential = potential;
      add_joint(world, joint);
    }
    const auto reactions = reactions_after(world, 60);
    for (std::size_t k = 0; k < reactions.size(); ++k) {
      const double weight = below[k] * 9.81;
      check(reactions[k].force, {0, weight, 0}, total * 9.81);
      check(reactions[k].moment, Vec3::Zero(), total * 9.81 * 0.4);  // a ball holds no moment
    }
  }
}

TEST_CASE("a cantilever of three beams: force and moment at each fixed joint, whichever body comes first") {
  for (const bool turned : {false, true}) {
    World world;
    const Vec3 along = Vec3(2, 0.5, 1).normalized();
    const double mass[] = {3, 2, 1};
    for (int k = 0; k < 3; ++k) world.add(Box{{0.5, 0.05, 0.05}}, mass[k], (k + 0.5) * along);
    for (int k = 0; k < 3; ++k) {
      const Index before = k == 0 ? kWorld : k - 1;
      add_joint(world, turned ? make_joint(world, JointType::fixed, k, before, k * along)
                              : make_joint(world, JointType::fixed, before, k, k * along));
    }
    const auto reactions = reactions_after(world, 120);
    for (int k = 0; k < 3; ++k) {
      Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
      for (int outer = k; outer < 3; ++outer) {
        const Vec3 weight(0, -mass[outer] * 9.81, 0);
        force -= weight;
        moment -= ((outer + 0.5 - k) * along).cross(weight);
      }
      const double sign = turned ? -1 : 1;  // the first body acts on the second
      check(reactions[static_cast<std::size_t>(k)].force, sign * force, 6 * 9.81);
      check(reactions[static_cast<std::size_t>(k)].moment, sign * moment, 6 * 9.81 * 3);
    }
  }
}

TEST_CASE("a driven hinge: the torque about its axis is m g L cos θ where it holds") {
  const double mass = 5, length = 0.7;
  for (const double theta : {0.5, -1.1, 2.2}) {
    World world;
    const Index arm = world.add(Box{{length, 0.05, 0.1}}, mass, {length, 0, 0});
    Joint hinge = make_joint(world, JointType::hinge, kWorld, arm, Vec3::Zero(), Vec3::UnitZ());
    hinge.drive = Profile{{{0, 0}, {1, theta}}};
    add_joint(world, hinge);
    const JointReport held = reactions_after(world, 180)[0];
    const double torque = mass * 9.81 * length * std::cos(theta);
    check(held.axis, Vec3::UnitZ(), 1);
    check(held.force, {0, mass * 9.81, 0}, mass * 9.81);
    check(held.moment, {0, 0, torque}, mass * 9.81 * length);
  }
}

TEST_CASE("a slider and a rod: forces across the axis, and along the rod") {
  World world;
  // A cart on a level rail that a rod holds back against a slope of gravity.
  world.params.gravity = {3, -9, 0};
  const Index cart = world.add_cube(0.4, 6, {0, 1, 0});
  add_joint(world, make_joint(world, JointType::slider, kWorld, cart, {0, 1, 0}, Vec3::UnitX()));
  Joint rod;
  rod.type = JointType::distance;
  rod.i = kWorld;
  rod.j = cart;
  rod.length = 2;
  rod.on_i = {{-2, 1, 0}, Mat3::Identity()};
  rod.on_j = {Vec3::Zero(), Mat3::Identity()};
  add_joint(world, rod);
  const auto reactions = reactions_after(world, 120);
  check(reactions[0].force, {0, 6 * 9, 0}, 54);
  check(reactions[0].moment, Vec3::Zero(), 54);
  check(reactions[1].force, {-6 * 3, 0, 0}, 54);
}

TEST_CASE("reactions are there only when they are asked for, and a hand on a body is none") {
  World world;
  const Index box = world.add_cube(0.5, 40, {0, -0.25, 0});
  add_joint(world, make_joint(world, JointType::spherical, kWorld, box, Vec3::Zero()));
  StepOptions options;
  testing::run(world, 1, options, [](const StepReport& r) { CHECK(r.joint_reports.empty()); });
  options.report_joints = true;
  options.pulls = {{box, Vec3::Zero(), {0, -0.25, 0}, 10}};
  testing::run(world, 1, options, [](const StepReport& r) { CHECK(r.joint_reports.size() == 1); });
}

}  // namespace pabd::test_joint_reactions
