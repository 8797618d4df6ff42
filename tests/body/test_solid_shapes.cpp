// SPDX-License-Identifier: MIT
// Shapes that the table alone describes: mass and inertia against textbooks and quadrature, bounds against
// points of the surface, and the polyhedron that contacts see.
#include <catch2/catch.hpp>
#include <functional>

#include "sim/body/mass_properties.h"
#include "sim/body/shape_kind.h"

namespace pabd::test_solid_shapes {

namespace {

constexpr double kDensity = 700, kRadius = 0.35, kHeight = 1.3;

// A solid of revolution about y; its centre of mass should be at 0.
struct Round {
  Shape shape;
  double low, high;
  std::function<double(double)> radius;  // at the height y
  double mass;
  Vec3 inertia;
};

Round cylinder() {
  const double m = kDensity * kPi * kRadius * kRadius * kHeight;
  const double across = m / 12 * (3 * kRadius * kRadius + kHeight * kHeight);
  return {make_shape("cylinder", {kRadius, kHeight}),
          -kHeight / 2,
          kHeight / 2,
          [](double) { return kRadius; },
          m,
          {across, 0.5 * m * kRadius * kRadius, across}};
}

// Hibbeler, Engineering Mechanics: 3/10 m r² about the axis, 3/80 m (4 r² + h²) across it.
Round cone() {
  const double m = kDensity * kPi * kRadius * kRadius * kHeight / 3;
  const double across = 3 * m / 80 * (4 * kRadius * kRadius + kHeight * kHeight);
  return {make_shape("cone", {kRadius, kHeight}),
          -kHeight / 4,
          3 * kHeight / 4,
          [](double y) { return kRadius * (0.75 - y / kHeight); },
          m,
          {across, 0.3 * m * kRadius * kRadius, across}};
}

std::vector<Round> solids() { return {cylinder(), cone()}; }

double relative_error(const Mat3& a, const Mat3& b) { return (a - b).norm() / b.norm(); }

// Of a point of the surface from the shape's own numbers: the corner circles are what reaches farthest.
double farthest(const Round& solid, const Vec3& u) {
  double most = -1e300;
  for (const double y : {solid.low, solid.high}) {
    for (int k = 0; k < 720; ++k) {
      const double a = 2 * kPi * k / 720, r = solid.radius(y);
      most = std::max(most, u.dot(Vec3(r * std::cos(a), y, r * std::sin(a))));
    }
  }
  return most;
}

}  // namespace

TEST_CASE("solids have the textbook mass and inertia about their centre of mass") {
  for (const Round& solid : solids()) {
    INFO(kind_of(solid.shape).name);
    const MassProperties p = mass_properties(solid.shape, kDensity);
    CHECK(p.mass == Approx(solid.mass).epsilon(1e-14));
    CHECK(relative_error(inertia_tensor(p.J), solid.inertia.asDiagonal()) < 1e-14);
  }
}

TEST_CASE("solids agree with a sum over slabs, whose centre of mass is the origin") {
  for (const Round& solid : solids()) {
    INFO(kind_of(solid.shape).name);
    const int n = 20000;
    const double dy = (solid.high - solid.low) / n;
    double mass = 0, moment = 0;
    Vec3 J = Vec3::Zero();
    for (int k = 0; k < n; ++k) {
      const double y = solid.low + (k + 0.5) * dy, r = solid.radius(y), slab = kDensity * kPi * r * r * dy;
      mass += slab;
      moment += slab * y;
      J += slab * Vec3(r * r / 4, y * y, r * r / 4);
    }
    const MassProperties p = mass_properties(solid.shape, kDensity);
    CHECK(p.mass == Approx(mass).epsilon(1e-7));
    CHECK(std::abs(moment / mass) < 1e-7);
    CHECK(relative_error(p.J, J.asDiagonal()) < 1e-7);
  }
}

TEST_CASE("bounds and radii of solids are those of their rims") {
  for (const Round& solid : solids()) {
    INFO(kind_of(solid.shape).name);
    for (int k = 0; k < 50; ++k) {
      const Mat3 R = Eigen::AngleAxisd(0.7 * k, Vec3(1, 0.3 * k, -1).normalized()).toRotationMatrix();
      const Vec3 c(k, -1, 2);
      const Aabb box = bounds(solid.shape, c, R);
      for (int axis = 0; axis < 3; ++axis) {
        const Vec3 u = R.row(axis).transpose();
        CHECK(box.hi[axis] - c[axis] == Approx(farthest(solid, u)).epsilon(2e-5));
        CHECK(c[axis] - box.lo[axis] == Approx(farthest(solid, -u)).epsilon(2e-5));
      }
    }
    double radius = 0, inside = std::min(-solid.low, solid.high);
    for (int k = 0; k <= 100000; ++k) {
      const double y = solid.low + (solid.high - solid.low) * k / 100000;
      radius = std::max(radius, std::hypot(y, solid.radius(y)));
      inside = std::min(inside, std::hypot(y, solid.radius(y)));
    }
    CHECK(bounding_radius(solid.shape) == Approx(radius).epsilon(1e-12));
    CHECK(inner_radius(solid.shape) == Approx(inside).epsilon(1e-8));
  }
  CHECK(inner_radius(make_shape("cone", {2, 0.4})) == Approx(0.1));  // a flat one: down to its base
}

TEST_CASE("contacts see a polyhedron with its corners on the rims and flat ends") {
  for (const Round& solid : solids()) {
    INFO(kind_of(solid.shape).name);
    const HullData& hull = *as<Hull>(as<Solid>(solid.shape).data->facets).data;
    REQUIRE(hull.vertices.size() + hull.faces.size() == hull.edges.size() + 2);  // Euler
    int on_ground = 0;
    for (const Vec3& x : hull.vertices) {
      const bool low = std::abs(x.y() - solid.low) < 1e-15;
      on_ground += x.y() == hull.vertices[0].y();
      CHECK((low || std::abs(x.y() - solid.high) < 2e-15));
      CHECK(std::hypot(x.x(), x.z()) == Approx(solid.radius(low ? solid.low : solid.high)).margin(1e-15));
    }
    CHECK(on_ground == 32);
    for (const HullFace& face : hull.faces) {
      CHECK(face.normal.norm() == Approx(1).epsilon(1e-15));
      for (std::size_t k = 0; k < face.count; ++k) {
        const Vec3& a = hull.vertices[hull.loop[face.first + k]];
        const Vec3& b = hull.vertices[hull.loop[face.first + (k + 1) % face.count]];
        const Vec3& c = hull.vertices[hull.loop[face.first + (k + 2) % face.count]];
        CHECK(face.normal.dot(a) == Approx(face.offset).margin(1e-15));
        CHECK((b - a).cross(c - b).dot(face.normal) > 0);  // anticlockwise from outside
      }
      for (const Vec3& x : hull.vertices) CHECK(face.normal.dot(x) < face.offset + 1e-15);
    }
    CHECK(hull.volume == Approx(volume(solid.shape)).epsilon(0.0065));  // a polygon of 32 sides in its circle
  }
}

}  // namespace pabd::test_solid_shapes
