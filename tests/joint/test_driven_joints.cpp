// SPDX-License-Identifier: MIT
// Prescribed rotations of spherical joints S(8–10), and angles beyond their limits.

#include <catch2/catch.hpp>
#include <cmath>

#include "sim/joint/attach.h"
#include "sim/joint/auto_kappa.h"
#include "sim/joint/expand.h"
#include "sim/math/so3.h"
#include "tests/support/scenario.h"

namespace pabd::test_driven_joints {

using testing::World;

namespace {

// A box that hangs off-centre on a spherical joint at the origin.
World hanging_box(const TurnProfile& turn, int arms) {
  World world;
  const Index box = world.add(Box{{0.3, 0.2, 0.1}}, 4, {0.4, -0.1, 0.05});
  Joint joint;
  joint.j = box;
  joint.arm = 0.2;
  joint.arms = static_cast<std::uint8_t>(arms);
  joint.turn = turn;
  attach(world.state, Vec3::Zero(), Mat3::Identity(), joint);
  joint.law.kappa = auto_joint_kappa(world.model, joint_load(world.model, world.params.gravity), joint);
  world.model.joints.push_back(joint);
  return world;
}

}  // namespace

TEST_CASE("a prescribed rotation about three axes is reached and followed to 1e-5") {
  const Vec3 end(0.4, -0.7, 1.1);
  World world = hanging_box({{{0, Vec3::Zero()}, {1, end}}}, 7);
  testing::run(world, 30);
  CHECK((log_so3(world.state.R[0]) - 0.5 * end).norm() < 1e-5);
  testing::run(world, 60);
  CHECK((log_so3(world.state.R[0]) - end).norm() < 1e-5);  // stays after the last key
  CHECK((world.state.c[0] - world.state.R[0] * Vec3(0.4, -0.1, 0.05)).norm() < 1e-6);
}

TEST_CASE("two held directions hold everything, one leaves the turn about itself free") {
  const Vec3 held(0, 0.3, 0);
  World two = hanging_box({{{0, Vec3::Zero()}, {0.5, held}}}, 3);
  testing::run(two, 60);
  CHECK((log_so3(two.state.R[0]) - held).norm() < 1e-5);

  // Only the direction x is held: the box turns about it, because its centre of mass lies beside that line.
  World one = hanging_box({{{0, Vec3::Zero()}}}, 1);
  one.params.h = 0.001;  // larger steps damp the swing
  double largest = 0;
  testing::run(one, 1000, {}, [&](const StepReport&) {
    const Mat3& R = one.state.R[0];
    CHECK((R.col(0) - Vec3::UnitX()).norm() < 1e-5);
    largest = std::max(largest, std::abs(log_so3(R).x()));
  });
  // A pendulum about x whose centre of mass starts 26.6° beside its lowest place swings to twice that.
  CHECK(largest == Approx(2 * std::atan2(0.05, 0.1)).epsilon(0.02));
}

TEST_CASE("a spherical joint with a turn has two bonds a direction, one without symmetry") {
  const PlacedFrame at{Vec3::Zero(), Mat3::Identity()};
  Joint joint;
  joint.turn = TurnProfile{{{0, Vec3::Zero()}}};
  for (const auto& [arms, symmetric, bonds] :
       {std::tuple{7, true, 7}, {5, true, 5}, {2, true, 3}, {7, false, 4}}) {
    joint.arms = static_cast<std::uint8_t>(arms);
    joint.symmetric = symmetric;
    BondList list;
    traits_of(JointType::spherical).expand(joint, at, at, 0, list);
    CHECK(list.count == bonds);
    for (int b = 0; b < list.count; ++b) CHECK((list.bond[b].y_a - list.bond[b].y_b).norm() < 1e-15);
  }
}

TEST_CASE("an angle outside its limits is held at the bound that is nearer on the circle") {
  const JointRange range{-170 * kPi / 180, 90 * kPi / 180};
  CHECK_FALSE(passed_angle(range, 0));
  CHECK_FALSE(passed_angle(range, range.lo));
  CHECK(passed_angle(range, 95 * kPi / 180) == range.hi);
  CHECK(passed_angle(range, -175 * kPi / 180) == range.lo);
  CHECK(passed_angle(range, 175 * kPi / 180) == range.lo);  // 15° past the lower bound, the other way round
  CHECK(passed_angle({-kPi, 1}, kPi - 0.01) == -kPi);
}

TEST_CASE("limits as soft as the automatic stiffness makes them hold within 0.5° and 1e-4 m") {
  const auto run_with = [](JointType type, const Vec3& axis, const JointRange& limits) {
    World world;
    const Index box = world.add(Box{{0.3, 0.2, 0.1}}, 4, {0.4, 0, 0});
    Joint joint = testing::make_joint(world, type, kWorld, box, Vec3::Zero(), axis);
    joint.limits = limits;
    joint.limit_scale = kLimitScale;
    testing::add_joint(world, joint);
    double lowest = 0;
    testing::run(world, 180, {}, [&](const StepReport&) {
      const PlacedFrame fi = place(joint.on_i, {Vec3::Zero(), Mat3::Identity()}),
                        fj = place(joint.on_j, {world.state.c[0], world.state.R[0]});
      lowest = std::min(lowest, type == JointType::hinge ? joint_angle(fi, fj) : joint_offset(fi, fj));
    });
    return lowest;
  };
  const double hinge = run_with(JointType::hinge, Vec3::UnitZ(), {-0.6, 0.1});
  CHECK(hinge <= -0.6);
  CHECK(hinge > -0.6 - 0.5 * kPi / 180);
  const double slider = run_with(JointType::slider, Vec3::UnitY(), {-0.5, 0});
  CHECK(slider <= -0.5);
  CHECK(slider > -0.5 - 1e-4);
}

TEST_CASE("a slider's twist is free, locked or limited; its offset follows a drive") {
  struct End {
    double twist, offset;
  };
  // A box beside its axis, so that its weight twists it.
  const auto after = [](Twist twist, double seconds) -> End {
    World world;
    const Index box = world.add(Box{{0.3, 0.2, 0.1}}, 4, {0, 0, 0.4});
    Joint joint = testing::make_joint(world, JointType::slider, kWorld, box, Vec3::Zero(), Vec3::UnitX());
    joint.twist = twist;
    joint.twist_limits = JointRange{-0.3, 0.3};
    joint.drive = Profile{{{0, 0}, {2, 1}}};
    testing::add_joint(world, joint);
    double largest = 0;
    testing::run(world, static_cast<int>(std::lround(60 * seconds)), {}, [&](const StepReport& r) {
      CHECK(r.max_joint_error < 1e-6);
      const PlacedFrame fi = place(joint.on_i, {Vec3::Zero(), Mat3::Identity()}),
                        fj = place(joint.on_j, {world.state.c[0], world.state.R[0]});
      largest = std::max(largest, std::abs(joint_angle(fi, fj)));
    });
    const PlacedFrame fi = place(joint.on_i, {Vec3::Zero(), Mat3::Identity()}),
                      fj = place(joint.on_j, {world.state.c[0], world.state.R[0]});
    return {largest, joint_offset(fi, fj)};
  };
  CHECK(after(Twist::free, 1).twist > 1);
  CHECK(after(Twist::locked, 1).twist < 1e-6);
  const End limited = after(Twist::limited, 1);
  CHECK(limited.twist >= 0.3);
  CHECK(limited.twist < 0.3 + 0.5 * kPi / 180);
  for (const Twist twist : {Twist::free, Twist::locked, Twist::limited})
    CHECK(after(twist, 1.5).offset == Approx(0.75).margin(1e-5));
}

}  // namespace pabd::test_driven_joints
