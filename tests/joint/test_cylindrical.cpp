// SPDX-License-Identifier: MIT
// The cylindrical joint: it slides along its axis and spins about it as if nothing were there, and holds the rest.

#include <catch2/catch.hpp>
#include <cmath>

#include "sim/joint/expand.h"
#include "sim/math/so3.h"
#include "tests/support/scenario.h"

namespace pabd::test_cylindrical {

using testing::World;

namespace {

// A box on an axis that falls by `alpha` below the horizontal.
struct Slope {
  World world;
  Vec3 down;
  Index box;
  explicit Slope(double alpha, bool swapped = false, const Vec3& anchor = {0.3, 1, -2}) {
    world.params.solver.integrator = Integrator::euler;  // whose way is known to rounding
    down = Vec3(std::cos(alpha), -std::sin(alpha), 0);
    box = world.add(Box{{0.2, 0.1, 0.1}}, 2.5, anchor, frame_about(down));
    const Index i = swapped ? box : kWorld, j = swapped ? kWorld : box;
    add_joint(world, make_joint(world, JointType::cylindrical, i, j, anchor, down));
  }
  PlacedFrame frame(bool of_j) const {
    const Joint& joint = world.model.joints[0];
    const Index body = of_j ? joint.j : joint.i;
    const Pose pose = body == kWorld ? Pose{Vec3::Zero(), Mat3::Identity()}
                                     : Pose{world.state.c[body], world.state.R[body]};
    return place(of_j ? joint.on_j : joint.on_i, pose);
  }
  double measured(std::size_t which) const {
    return traits_of(JointType::cylindrical).measures[which].value(frame(false), frame(true));
  }
};

}  // namespace

TEST_CASE("a cylindrical joint: g sin α along its axis, the spin about it is kept") {
  for (const double degrees : {0.0, 15.0, 40.0, 90.0}) {
    for (const bool swapped : {false, true}) {
      Slope slope(degrees * kPi / 180, swapped);
      World& world = slope.world;
      const double spin = 2;
      world.state.omega[slope.box] = spin * slope.down;
      const Vec3 start = world.state.c[slope.box];
      const int steps = 60;
      testing::run(world, steps, {}, [](const StepReport& r) { REQUIRE(r.status == StepStatus::converged); });
      const double h = world.params.h, g = 9.81 * std::sin(degrees * kPi / 180);
      INFO("α " << degrees << (swapped ? " swapped" : ""));
      CHECK((world.state.v[slope.box] - g * steps * h * slope.down).norm() < 1e-6);
      // Implicit steps: Σ k h² g.
      const double way = 0.5 * g * h * h * steps * (steps + 1);
      CHECK((world.state.c[slope.box] - start - way * slope.down).norm() < 1e-6);
      CHECK((world.state.omega[slope.box] - spin * slope.down).norm() < 1e-6);
      // What it measures: j is the box, or the world seen from it.
      const double sign = swapped ? -1 : 1;
      CHECK(slope.measured(0) == Approx(sign * way).margin(1e-6));
      CHECK(slope.measured(1) == Approx(sign * spin * steps * h).margin(1e-5));
    }
  }
}

TEST_CASE(
    "a cylindrical joint carries the weight across its axis, no force along it and no moment about it") {
  for (const double degrees : {10.0, 35.0, 70.0}) {
    Slope slope(degrees * kPi / 180);
    slope.world.state.omega[slope.box] = 3 * slope.down;
    StepOptions options;
    options.report_joints = true;
    JointReport report;
    testing::run(slope.world, 20, options, [&](const StepReport& r) { report = r.joint_reports[0]; });
    const Vec3 weight = 2.5 * slope.world.params.gravity, n = slope.down;
    INFO("α " << degrees);
    CHECK((report.force + weight - weight.dot(n) * n).norm() < 1e-5 * weight.norm());
    CHECK(std::abs(report.moment.dot(n)) < 1e-6 * weight.norm());
  }
}

TEST_CASE("a cylindrical joint stops at its limits, in offset and in angle") {
  Slope slope(40 * kPi / 180);
  World& world = slope.world;
  Joint& joint = world.model.joints[0];
  joint.limits = JointRange{-0.1, 0.25};
  joint.twist = Twist::limited;
  joint.twist_limits = JointRange{-0.5, 0.4};
  joint.limit_scale = kLimitScale;
  world.state.omega[slope.box] = 2 * slope.down;
  double farthest = 0, widest = 0;
  testing::run(world, 120, {}, [&](const StepReport&) {
    farthest = std::max(farthest, slope.measured(0));
    widest = std::max(widest, slope.measured(1));
  });
  CHECK(farthest == Approx(0.25).margin(2e-3));
  CHECK(widest == Approx(0.4).margin(2e-2));
}

TEST_CASE("a driven cylindrical joint is where its drive says, and still spins freely") {
  Slope slope(25 * kPi / 180);
  World& world = slope.world;
  world.model.joints[0].drive = Profile{{{0, 0}, {1, 0.3}}};
  world.state.omega[slope.box] = -1.5 * slope.down;
  testing::run(world, 30);
  CHECK(slope.measured(0) == Approx(0.3 * world.state.time).margin(1e-6));
  CHECK(slope.measured(1) == Approx(-1.5 * world.state.time).margin(1e-5));
}

}  // namespace pabd::test_cylindrical
