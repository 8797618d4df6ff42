// SPDX-License-Identifier: MIT
// Joints against closed forms: pendulum, chain, hinge, slider, drives and limits.

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/joint/expand.h"
#include "sim/math/so3.h"
#include "tests/support/scenario.h"

namespace pabd::test_joints {

using testing::add_joint;
using testing::make_joint;
using testing::World;

namespace {

PlacedFrame placed(const World& world, const JointFrame& frame, Index body) {
  if (body == kWorld) return place(frame, {Vec3::Zero(), Mat3::Identity()});
  return place(frame, {world.state.c[body], world.state.R[body]});
}

double angle(const World& world, const Joint& joint) {
  return joint_angle(placed(world, joint.on_i, joint.i), placed(world, joint.on_j, joint.j));
}
double offset(const World& world, const Joint& joint) {
  return joint_offset(placed(world, joint.on_i, joint.i), placed(world, joint.on_j, joint.j));
}

// Complete elliptic integral of the first kind by the arithmetic-geometric mean.
double elliptic_K(double k) {
  double a = 1, b = std::sqrt(1 - k * k);
  while (std::abs(a - b) > 1e-15) {
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
  }
  return kPi / (2 * a);
}

// A rod of length 1 that hangs on a hinge at the origin, raised by `start` from hanging.
World pendulum(double start, double h) {
  World world;
  world.params.h = h;
  const Mat3 R = exp_so3({0, 0, start});
  const Index rod = world.add(Box{{0.02, 0.5, 0.02}}, 2, R * Vec3(0, -0.5, 0), R);
  add_joint(world, make_joint(world, JointType::hinge, kWorld, rod, Vec3::Zero()));
  return world;
}

}  // namespace

TEST_CASE("a pendulum's first quarter period converges to the elliptic integral with h") {
  const double start = 1.0;
  // Physical pendulum: T = 4 K(sin θ₀/2) √(I_o/(m g d)), I_o = m (l²/12 + w²/12 + d²), here with the rod's
  // width.
  const double I_o = (1 + 0.04 * 0.04) / 12 + 0.25;
  const double quarter = elliptic_K(std::sin(start / 2)) * std::sqrt(I_o / (9.81 * 0.5));
  std::vector<double> errors;
  for (const double h : {1.0 / 500, 1.0 / 1000}) {
    World world = pendulum(start, h);
    double before = start, crossing = 0;
    for (int k = 1; crossing == 0 && k * h < 2; ++k) {
      testing::run(world, 1);
      const double now = start + angle(world, world.model.joints[0]);
      if (now <= 0) crossing = h * (k - now / (now - before));
      before = now;
    }
    errors.push_back(std::abs(crossing - quarter));
  }
  CHECK(errors[0] < 0.005 * quarter);
  CHECK(errors[1] < 0.6 * errors[0]);  // first order
}

TEST_CASE("a hinge keeps its five degrees of freedom to 1e-6 of the body, soft and hard") {
  for (const BondPotential potential : {BondPotential::soft, BondPotential::hard}) {
    World world = pendulum(1.2, 1.0 / 60);
    Joint& joint = world.model.joints[0];
    joint.law.potential = potential;
    joint.law.kappa = auto_joint_kappa(world.model, joint_load(world.model, world.params.gravity), joint);
    testing::run(world, 300, {}, [&](const StepReport& r) {
      CHECK(r.method == SolverMethod::newton);
      CHECK(r.max_joint_error < 1e-6);
    });
    CHECK(std::abs(world.state.R[0].col(2).z() - 1) < 1e-6);
  }
}

TEST_CASE("the reaction of a loaded joint is the weight, to 1e-3") {
  World world;
  const Index box = world.add_cube(0.5, 40, {0, -0.25, 0});
  add_joint(world, make_joint(world, JointType::spherical, kWorld, box, Vec3::Zero()));
  testing::run(world, 120);
  BondList list;
  expand(world.model.joints[0], {Vec3::Zero(), Mat3::Identity()}, {world.state.c[box], world.state.R[box]}, 0,
         list);
  const Vec3 force = -evaluate(world.model.joints[0].law, list.bond[0]).gradient;
  CHECK((force - Vec3(0, 40 * 9.81, 0)).norm() < 1e-3 * 40 * 9.81);
}

TEST_CASE("a chain of 100 links, end mass 1 or 100, keeps its joints to 1e-6 of a link for 5 s") {
  for (const double end_mass : {1.0, 100.0}) {
    World world;
    const int links = 100;
    for (int k = 0; k < links; ++k) {
      world.add(Box{{0.5, 0.05, 0.05}}, k + 1 == links ? end_mass : 1.0, {k + 0.5, 0, 0});
    }
    for (int k = 0; k < links; ++k) {
      add_joint(world, make_joint(world, JointType::spherical, k == 0 ? kWorld : k - 1, k, Vec3(k, 0, 0)));
    }
    double worst = 0;
    testing::run(world, 300, {}, [&](const StepReport& r) {
      REQUIRE(r.status != StepStatus::non_finite);
      worst = std::max(worst, r.max_joint_error);
    });
    INFO("end mass " << end_mass);
    CHECK(worst < 1e-6);
    CHECK(world.state.c[links - 1].y() < -20);  // it swings down
  }
}

TEST_CASE("a closed loop of hinges stays closed to 1e-5") {
  World world;
  const int bars = 6;
  const double radius = 1 / (2 * std::sin(kPi / bars));
  std::vector<Vec3> corner;
  for (int k = 0; k < bars; ++k) {
    const double a = 2 * kPi * k / bars;
    corner.push_back({radius * std::cos(a), radius * std::sin(a), 0});
  }
  for (int k = 0; k < bars; ++k) {
    const Vec3 along = corner[(k + 1) % bars] - corner[k];
    const Mat3 R = exp_so3({0, 0, std::atan2(along.y(), along.x())});
    world.add(Box{{0.5, 0.05, 0.05}}, 1, 0.5 * (corner[k] + corner[(k + 1) % bars]), R);
  }
  for (int k = 0; k < bars; ++k) {
    add_joint(world, make_joint(world, JointType::hinge, k, (k + 1) % bars, corner[(k + 1) % bars]));
  }
  add_joint(world, make_joint(world, JointType::hinge, kWorld, 0, world.state.c[0]));
  testing::run(world, 300, {}, [&](const StepReport& r) { CHECK(r.max_joint_error < 1e-5); });
}

TEST_CASE("a slider moves along its line only, with the acceleration of the slope") {
  World world;
  const Vec3 axis = Vec3(3, -1, 0).normalized();
  const Index box = world.add(Box{{0.3, 0.2, 0.1}}, 5, {0, 0, 0});
  add_joint(world, make_joint(world, JointType::slider, kWorld, box, Vec3::Zero(), axis));
  testing::run(world, 60);
  const Vec3 c = world.state.c[box];
  CHECK((c - axis * axis.dot(c)).norm() < 1e-6);
  CHECK((world.state.R[box] - Mat3::Identity()).norm() < 1e-6);
  const double a = world.params.gravity.dot(axis);
  CHECK(world.state.v[box].dot(axis) == Approx(a).epsilon(1e-3));
  CHECK(offset(world, world.model.joints[0]) == Approx(axis.dot(c)).epsilon(1e-6));
}

TEST_CASE("limits hold within 0.5° and 1e-4 m; a drive is followed") {
  SECTION("hinge limit") {
    World world = pendulum(1.0, 1.0 / 60);
    world.model.joints[0].limits = JointRange{-0.5, 0.5};
    double lowest = 0;
    testing::run(world, 240, {},
                 [&](const StepReport&) { lowest = std::min(lowest, angle(world, world.model.joints[0])); });
    CHECK(lowest < -0.49);
    CHECK(lowest > -0.5 - 0.5 * kPi / 180);
  }
  SECTION("slider limit") {
    World world;
    const Index box = world.add_cube(0.4, 5, {0, 0, 0});
    Joint joint = make_joint(world, JointType::slider, kWorld, box, Vec3::Zero(), Vec3::UnitY());
    joint.limits = JointRange{-0.7, 0.1};
    add_joint(world, joint);
    testing::run(world, 240);
    CHECK(world.state.c[box].y() == Approx(-0.7).margin(1e-4));
  }
  SECTION("hinge drive") {
    World world = pendulum(0, 1.0 / 60);
    world.model.joints[0].drive = Profile{{{0, 0}, {1, 0}, {3, 1.2}}};
    testing::run(world, 120);
    CHECK(angle(world, world.model.joints[0]) == Approx(0.6).margin(1e-3));
    testing::run(world, 120);
    CHECK(angle(world, world.model.joints[0]) == Approx(1.2).margin(1e-3));
  }
}

TEST_CASE("without the second bond a driven hinge moves asymmetrically, as the supplement warns") {
  const auto shift = [](bool symmetric) {
    World world;
    world.params.gravity.setZero();
    const Index box = world.add_cube(1, 10, Vec3::Zero());
    Joint joint = make_joint(world, JointType::hinge, kWorld, box, Vec3::Zero());
    joint.symmetric = symmetric;
    joint.law.kappa = 1e4;  // soft enough to see
    joint.drive = Profile{{{0, 0.5}}};
    world.model.joints.push_back(joint);
    testing::run(world, 5);
    return world.state.c[box].norm();
  };
  CHECK(shift(true) < 1e-12);
  CHECK(shift(false) > 1e-3);
}

}  // namespace pabd::test_joints
