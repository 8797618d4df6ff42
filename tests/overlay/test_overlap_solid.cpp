// SPDX-License-Identifier: MIT
// The solid that two boxes have in common, against volumes known in closed form.
#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "app/overlay/overlap_solid.h"
#include "sim/body/convex_hull.h"
#include "sim/math/so3.h"

namespace pabd::test_overlap_solid {

namespace {

double volume(const Box& a, const Pose& at_a, const Box& b, const Pose& at_b) {
  const auto points = overlap_corners(a, at_a, b, at_b);
  if (points.size() < 4) return 0;
  const HullResult hull = make_hull(points);
  return hull.hull ? hull.hull->volume : 0;
}

Mat3 turn(double angle, const Vec3& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

}  // namespace

TEST_CASE("boxes side by side, inside of each other, and apart") {
  const Box unit{{0.5, 0.5, 0.5}}, small{{0.1, 0.2, 0.3}};
  const Pose here{Vec3::Zero(), Mat3::Identity()};
  CHECK(volume(unit, here, unit, {Vec3(0.15, 0.9, 0.08), Mat3::Identity()}) ==
        Approx(0.85 * 0.1 * 0.92).epsilon(1e-9));
  CHECK(volume(unit, here, unit, here) == Approx(1));
  const Pose inside{Vec3(0.05, -0.1, 0.02), turn(0.7, Vec3(1, 2, 3))};
  CHECK(volume(unit, here, small, inside) == Approx(8 * 0.1 * 0.2 * 0.3).epsilon(1e-9));
  CHECK(volume(small, inside, unit, here) == Approx(8 * 0.1 * 0.2 * 0.3).epsilon(1e-9));
  CHECK(overlap_corners(unit, here, unit, {Vec3(0, 1.2, 0), Mat3::Identity()}).empty());
  CHECK(overlap_corners(unit, here, unit, {Vec3(1.3, 0, 0), turn(0.785398, Vec3(0, 1, 0))}).empty());
}

TEST_CASE("two cubes turned by 45 degrees share a regular octagon; turning both changes nothing") {
  const Box unit{{0.5, 0.5, 0.5}};
  const double octagon = 2 * (std::sqrt(2.0) - 1);  // area of a regular one of width 1
  for (const double angle : {0.0, 0.3, 1.1}) {
    const Mat3 R = turn(angle, Vec3(0.3, 1, -0.4));
    const Pose a{Vec3(1, 2, 3), R}, b{Vec3(1, 2, 3), R * turn(0.25 * kPi, Vec3::UnitY())};
    CAPTURE(angle);
    CHECK(volume(unit, a, unit, b) == Approx(octagon).epsilon(1e-9));
  }
}

TEST_CASE("a corner inside is a tetrahedron, and its triangles are drawn where it is") {
  const Box unit{{0.5, 0.5, 0.5}};
  const Mat3 R = rotation_between(Vec3(-1, -1, -1), Vec3(0, -1, 0));
  const Pose lower{Vec3(0, 0.5, 0), Mat3::Identity()};
  const Pose upper{Vec3(0, 1 - 0.1 + 0.5 * std::sqrt(3.0), 0), R};
  const auto points = overlap_corners(unit, lower, unit, upper);
  // A cube's corner cut off at depth h: h³ √3/2.
  CHECK(make_hull(points).hull->volume == Approx(0.001 * std::sqrt(3.0) / 2).epsilon(1e-9));
  const auto solid = convex_solid(points, Vec4f(1, 0, 0, 0.5f));
  REQUIRE(solid);
  REQUIRE(solid->mesh->corners.size() == 12);
  const Mat4f& m = solid->instances[0].transform;
  for (const Vec3f& corner : solid->mesh->corners) {
    const Vec4f at = m * corner.homogeneous();
    CHECK(at.y() >= 0.9f - 1e-5f);
    CHECK(at.y() <= 1.0f + 1e-5f);
  }
  CHECK_FALSE(convex_solid({}, Vec4f::Zero()));
}

}  // namespace pabd::test_overlap_solid
