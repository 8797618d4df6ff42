// SPDX-License-Identifier: MIT
// The ruler for overlap gives what geometry says, for poses as any engine hands them over: it must not favour
// the one whose collision code it borrows.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "sim/math/so3.h"
#include "tests/bench/peers/rulers.h"
#include "tests/support/scenario.h"

namespace pabd::test_rulers {

using namespace peers;
using testing::World;

namespace {

struct Case {
  const char* name;
  World world;
  double overlap;  // from geometry; m
  int points = 1;  // of that depth
};

const double kRoot2 = std::sqrt(2.0);
constexpr double kDepth = 0.01;  // how far the bodies of a case reach into each other; m

Mat3 about(const Vec3& axis, double degrees) {
  return Eigen::AngleAxisd(degrees * kPi / 180, axis.normalized()).toRotationMatrix();
}

World pair_of(const Shape& a, const Mat3& R_a, const Shape& b, const Vec3& c_b, const Mat3& R_b) {
  World world;
  world.add(a, 1, Vec3::Zero(), R_a);
  world.add(b, 1, c_b, R_b);
  return world;
}

World on_ground(const Shape& shape, double height, const Mat3& R) {
  World world;
  world.add_ground();
  world.add(shape, 1, {3, height, -2}, R);
  return world;
}

std::vector<Case> cases() {
  const Mat3 I = Mat3::Identity();
  const Vec3 diagonal = Vec3(1, 2, -2) / 3, up = Vec3::UnitY();
  const Box cube{Vec3::Constant(0.5)}, brick{{0.5, 0.25, 0.25}};
  const Sphere ball{0.3}, marble{0.2};
  const Capsule pin{0.1, 0.6};
  const Mat3 on_edge = about(Vec3::UnitZ(), 45), lying = about(Vec3::UnitX(), 90);
  return {
      {"two spheres", pair_of(ball, I, marble, (0.5 - kDepth) * diagonal, I), kDepth},
      {"sphere in a face", pair_of(brick, I, ball, {0.1, 0.55 - kDepth, 0.05}, I), kDepth},
      {"sphere at an edge",
       pair_of(cube, I, ball, Vec3(0.5, 0.5, 0.1) + (0.3 - kDepth) / kRoot2 * Vec3(1, 1, 0), I), kDepth},
      {"sphere at a corner", pair_of(cube, I, ball, Vec3::Constant(0.5 + (0.3 - kDepth) / std::sqrt(3.0)), I),
       kDepth},
      {"sphere and capsule's side", pair_of(pin, I, ball, {0.4 - kDepth, 0.2, 0}, I), kDepth},
      {"sphere and capsule's end", pair_of(pin, I, ball, {0, 0.7 - kDepth, 0}, I), kDepth},
      {"crossed capsules", pair_of(pin, I, pin, {0, 0.1, 0.2 - kDepth}, about(Vec3::UnitZ(), 70)), kDepth},
      {"capsule upright on a face", pair_of(brick, I, pin, {0.2, 0.65 - kDepth, 0}, I), kDepth},
      {"brick on a brick, turned", pair_of(brick, I, brick, {0.1, 0.5 - kDepth, 0}, about(up, 90)), kDepth,
       4},
      {"corner of a cube in a face",
       pair_of(cube, I, cube, {0.05, 0.5 + std::sqrt(0.75) - kDepth, 0.1},
               rotation_between(Vec3(-1, -1, -1), -up)),
       kDepth},
      {"crossed edges", pair_of(cube, on_edge, cube, {0, kRoot2 - kDepth, 0}, about(Vec3::UnitX(), 45)),
       kDepth},
      {"sphere on the ground", on_ground(ball, 0.3 - kDepth, about(diagonal, 50)), kDepth},
      {"cube on the ground, on an edge", on_ground(cube, 0.5 * kRoot2 - kDepth, on_edge), kDepth, 2},
      {"brick on the ground", on_ground(brick, 0.25 - kDepth, about(up, 20)), kDepth, 4},
      {"capsule on the ground, upright", on_ground(pin, 0.4 - kDepth, I), kDepth},
      {"capsule on the ground, lying", on_ground(pin, 0.1 - kDepth, about(up, 35) * lying), kDepth, 2},
      {"spheres apart", pair_of(ball, I, marble, (0.5 + kDepth) * diagonal, I), 0, 0},
      {"bricks apart", pair_of(brick, I, brick, {0.1, 0.5 + kDepth, 0}, I), 0, 0},
  };
}

// How the engines hand over a pose, as their adapters make it of what they hold.
struct Source {
  const char* name;
  std::function<void(Vec3& c, Mat3& R)> pass;
  double tolerance;  // m
};

const std::vector<Source> kSources = {
    {"doubles", [](Vec3&, Mat3&) {}, 1e-12},
    {"float matrix",
     [](Vec3& c, Mat3& R) {
       c = c.cast<float>().cast<double>();
       R = R.cast<float>().cast<double>();
     },
     1e-6},
    {"float quaternion",
     [](Vec3& c, Mat3& R) {
       c = c.cast<float>().cast<double>();
       R = Quat(R).cast<float>().cast<double>().normalized().toRotationMatrix();
     },
     1e-6},
};

Depth measure(const Model& model, const State& state) {
  Depth depth;
  OverlapRuler(model).measure(state, depth);
  return depth;
}

void check(const Case& expected, const State& state, double tolerance) {
  const Depth depth = measure(expected.world.model, state);
  CHECK(depth.max == Approx(expected.overlap).margin(tolerance));
  CHECK(depth.mean() == Approx(expected.overlap).margin(tolerance));
  CHECK(depth.count == expected.points);
}

}  // namespace

TEST_CASE("overlap is what geometry says, whoever hands over the poses") {
  for (const Case& known : cases()) {
    for (const Source& source : kSources) {
      CAPTURE(known.name, source.name);
      State state = known.world.state;
      for (std::size_t i = 0; i < state.c.size(); ++i) {
        if (!known.world.model.fixed[i]) source.pass(state.c[i], state.R[i]);
      }
      check(known, state, source.tolerance);
    }
  }
}

TEST_CASE("overlap does not depend on where two bodies are and which one comes first") {
  for (const Case& known : cases()) {
    if (known.world.model.fixed[0]) continue;
    CAPTURE(known.name);
    State moved = known.world.state;
    const Mat3 turn = about({1, -2, 3}, 77);
    for (std::size_t i = 0; i < moved.c.size(); ++i) {
      moved.c[i] = Vec3(20, 5, -8) + turn * moved.c[i];
      moved.R[i] = turn * moved.R[i];
    }
    check(known, moved, 1e-12);

    Case swapped = known;
    std::swap(swapped.world.model.shape[0], swapped.world.model.shape[1]);
    std::swap(moved.c[0], moved.c[1]);
    std::swap(moved.R[0], moved.R[1]);
    check(swapped, moved, 1e-12);
  }
}

TEST_CASE("the ruler reads nothing but poses") {
  for (const Case& known : cases()) {
    CAPTURE(known.name);
    State state = known.world.state;
    const Depth at_rest = measure(known.world.model, state);
    state.time = 7;
    state.step = 420;
    state.v.back() = {30, -40, 50};
    state.omega.back() = {-6, 7, 8};
    state.contacts.push_back({1, 0, Vec3(1, 2, 3)});
    const Depth moving = measure(known.world.model, state);
    CHECK(moving.max == at_rest.max);
    CHECK(moving.sum == at_rest.sum);
    CHECK(moving.count == at_rest.count);
  }
}

TEST_CASE("fixed and joined bodies do not overlap") {
  Case known = cases().front();
  SECTION("joined") { known.world.model.no_collide = {{0, 1}}; }
  SECTION("fixed") { known.world.model.fixed = {1, 1}; }
  CHECK(measure(known.world.model, known.world.state).count == 0);
}

TEST_CASE("drift is the distance of a joint's anchors") {
  World world = cases().front().world;
  world.model.joints = {
      pabd::testing::make_joint(world, JointType::spherical, 0, 1, {0.1, 0.2, 0.3}),
      pabd::testing::make_joint(world, JointType::hinge, kWorld, 0, {1, 2, 3}),
  };
  CHECK(joint_drift(world.model, world.state) < 1e-15);
  world.state.c[1] += Vec3(0.03, 0, 0.04);
  CHECK(joint_drift(world.model, world.state) == Approx(0.05).margin(1e-12));
  // The anchor is as far from the centre of body 0 as (1, 2, 3), and perpendicular to the axis of the turn.
  world.state.R[0] = about({0, 3, -2}, 60);
  CHECK(joint_drift(world.model, world.state) == Approx(std::sqrt(14.0)).margin(1e-12));
}

}  // namespace pabd::test_rulers
