// SPDX-License-Identifier: MIT
// The universal joint: what it leaves free, what it holds, and Hooke's relation between two shafts.

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/joint/attach.h"
#include "sim/joint/expand.h"
#include "sim/math/so3.h"
#include "tests/support/scenario.h"

namespace pabd::test_universal {

using testing::World;

namespace {

const Vec3 kX = Vec3::UnitX(), kY = Vec3::UnitY(), kZ = Vec3::UnitZ();

Mat3 turned(const Vec3& axis, double angle) { return exp_so3(angle * axis); }

Joint universal(const World& world, Index i, Index j, const Vec3& anchor, const Vec3& n, const Vec3& e) {
  Joint joint;
  joint.type = JointType::universal;
  joint.i = i;
  joint.j = j;
  joint.arm = 0.25;
  attach(world.state, anchor, joint_frame(joint.type, n, e), joint);
  return joint;
}

void bonds_at(const Joint& joint, const PlacedFrame& fi, const PlacedFrame& fj, BondList& list) {
  traits_of(joint.type).expand(joint, fi, fj, 0, list);
}

double stretch(const PointBond& bond) { return (bond.y_b - bond.y_a).norm() - bond.length; }

}  // namespace

TEST_CASE("a universal joint: turns about both axes stretch nothing and are what it measures") {
  const Mat3 R = turned(Vec3(1, -2, 0.5).normalized(), 0.8);
  Joint joint;
  joint.type = JointType::universal;
  joint.arm = 0.3;
  const PlacedFrame fi{{3, -1, 2}, R};
  for (const double phi : {-2.9, -0.7, 0.0, 0.4, 1.9}) {
    for (const double psi : {-1.3, 0.0, 0.6, 2.4}) {
      const PlacedFrame fj{fi.y, R * turned(kX, phi) * turned(kY, psi)};
      BondList list;
      bonds_at(joint, fi, fj, list);
      REQUIRE(list.count == 3);
      for (int b = 0; b < list.count; ++b) CHECK(std::abs(stretch(list.bond[b])) < 1e-15);
      const auto measures = traits_of(joint.type).measures;
      REQUIRE(measures.size() == 2);
      CHECK(measures[0].value(fi, fj) == Approx(phi).margin(1e-14));
      CHECK(measures[1].value(fi, fj) == Approx(psi).margin(1e-14));
    }
  }
}

TEST_CASE(
    "a universal joint: a turn δ across both axes stretches its two bonds by arm (√(2 + 2 sin δ) − √2)") {
  Joint joint;
  joint.type = JointType::universal;
  joint.arm = 0.3;
  const PlacedFrame fi{Vec3::Zero(), Mat3::Identity()};
  for (const double delta : {-0.5, -1e-3, 1e-3, 0.3}) {
    const PlacedFrame fj{Vec3::Zero(), turned(kZ, delta)};  // n · e = −sin δ
    BondList list;
    bonds_at(joint, fi, fj, list);
    const double expected = 0.3 * (std::sqrt(2 + 2 * std::sin(delta)) - std::sqrt(2.0));
    CHECK(stretch(list.bond[1]) == Approx(expected).epsilon(1e-10));
    CHECK(stretch(list.bond[2]) == Approx(expected).epsilon(1e-10));
    // Opposite directions: a moment and no force.
    CHECK((list.bond[1].y_b - list.bond[1].y_a + list.bond[2].y_b - list.bond[2].y_a).norm() < 1e-15);
  }
}

TEST_CASE("a universal joint holds the moment across both axes and none about them") {
  // A load beside the anchor whose weight turns about x = n × e; the cross stands at several angles about it.
  for (const double angle : {0.0, 0.6, 1.8, -2.5}) {
    for (const bool swapped : {false, true}) {
      World world;
      const Vec3 anchor(1, 2, -0.5), arm(0.1, -0.2, 0.7);
      const Index box = world.add(Box{{0.1, 0.1, 0.4}}, 3, anchor + arm);
      const Mat3 R = turned(kX, angle);
      const Vec3 n = R * kY, e = R * kZ;
      const auto add = [&](Index i, Index j) { add_joint(world, universal(world, i, j, anchor, n, e)); };
      swapped ? add(box, kWorld) : add(kWorld, box);
      world.params.h = 1e-3;
      StepOptions options;
      options.report_joints = true;
      JointReport report;
      testing::run(world, 1, options, [&](const StepReport& r) { report = r.joint_reports[0]; });
      // Free about n and e: M = J α + … with the moment along x alone, ω = 0 at the start. About the anchor,
      // J α = r × m g + M x̂ and α · x̂ = 0.
      const Mat3 J = inertia_tensor(world.model.J[box]) +
                     3 * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose());
      const Vec3 weight = 3 * world.params.gravity;
      const Mat3 inverse = J.inverse();
      const double M = -(inverse * arm.cross(weight)).x() / inverse(0, 0);
      const double sign = swapped ? -1 : 1;
      CHECK(report.moment.x() * sign == Approx(M).epsilon(2e-3));
      CHECK(std::hypot(report.moment.y(), report.moment.z()) < 2e-3 * std::abs(M));
      // And it moves as that says.
      const Vec3 alpha = inverse * (arm.cross(weight) + M * kX);
      CHECK((world.state.omega[box] / world.params.h - alpha).norm() < 5e-3 * alpha.norm());
    }
  }
}

TEST_CASE("two shafts at an angle β: tan φ₂ = tan φ₁ cos β") {
  for (const double beta : {10.0, 30.0, 50.0}) {
    const double b = beta * kPi / 180;
    World world;
    world.params.gravity.setZero();
    const Vec3 s(std::cos(b), 0, std::sin(b));
    const Index first = world.add(Box{{0.5, 0.05, 0.05}}, 1, -0.6 * kX);
    const Index second = world.add(Box{{0.5, 0.05, 0.05}}, 1, 0.6 * s, turned(-kY, b));
    Joint drive = make_joint(world, JointType::hinge, kWorld, first, -kX, kX);
    drive.drive = Profile{{{0, 0}, {1, 2 * kPi}}};
    add_joint(world, drive);
    add_joint(world, make_joint(world, JointType::hinge, kWorld, second, s, s));
    // φ = 0: n upright, e in the plane of the shafts.
    add_joint(world, universal(world, first, second, Vec3::Zero(), kY, Vec3(-std::sin(b), 0, std::cos(b))));
    world.params.h = 1.0 / 240;
    const Mat3 start = world.state.R[second];
    double largest = 0;
    testing::run(world, 240, {}, [&](const StepReport& report) {
      REQUIRE(report.status == StepStatus::converged);
      const double phi = log_so3(world.state.R[first]).x();
      const double out = log_so3(world.state.R[second] * start.transpose()).dot(s);
      const double theory = std::atan2(std::sin(phi) * std::cos(b), std::cos(phi));
      largest = std::max(largest, std::abs(std::remainder(out - theory, 2 * kPi)));
    });
    INFO("β " << beta);
    CHECK(world.state.time == Approx(1));
    CHECK(largest < 1e-5);
  }
}

}  // namespace pabd::test_universal
