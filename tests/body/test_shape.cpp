// SPDX-License-Identifier: MIT
// Bounds and radii of shapes against points sampled on their surfaces.
#include <catch2/catch.hpp>
#include <random>

#include "sim/body/shape.h"
#include "tests/support/draws.h"

namespace pabd::test_shape {

namespace {

std::mt19937 generator(12345);

double uniform(double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(generator); }
Vec3 random_direction() {
  std::normal_distribution<double> normal;
  return testing::draw_vector([&] { return normal(generator); }).normalized();
}
Mat3 random_rotation() {
  const double angle = uniform(-kPi, kPi);
  return Eigen::AngleAxisd(angle, random_direction()).toRotationMatrix();
}

// Furthest point of a shape along u in the body frame, by enumeration of what the shape is made of.
double support(const Shape& shape, const Vec3& u) {
  if (const auto* box = std::get_if<Box>(&shape)) {
    double best = -1e300;
    for (int k = 0; k < 8; ++k) {
      const Vec3 sign(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
      best = std::max(best, u.dot(box->half.cwiseProduct(sign)));
    }
    return best;
  }
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return sphere->radius * u.norm();
  const auto& capsule = std::get<Capsule>(shape);
  const Vec3 end(0, capsule.length / 2, 0);
  return std::max(u.dot(end), -u.dot(end)) + capsule.radius * u.norm();
}

const Shape kShapes[] = {Box{{0.2, 0.5, 0.9}}, Sphere{0.4}, Capsule{0.3, 1.1}, Capsule{0.25, 0}};

}  // namespace

TEST_CASE("bounds are tight under random rotations") {
  for (int trial = 0; trial < 200; ++trial) {
    const Mat3 R = random_rotation();
    const Vec3 c = testing::draw_vector([] { return uniform(-5, 5); });
    for (const Shape& shape : kShapes) {
      const Aabb aabb = bounds(shape, c, R);
      for (int k = 0; k < 3; ++k) {
        const Vec3 u = R.transpose().col(k);  // world axis k seen from the body
        REQUIRE(aabb.hi[k] == Approx(c[k] + support(shape, u)).margin(1e-13));
        REQUIRE(aabb.lo[k] == Approx(c[k] - support(shape, -u)).margin(1e-13));
      }
    }
  }
}

TEST_CASE("the bounding radius is the largest support over all directions") {
  for (const Shape& shape : kShapes) {
    double largest = 0;
    for (int k = 0; k < 20000; ++k) largest = std::max(largest, support(shape, random_direction()));
    const double r = bounding_radius(shape);
    CHECK(largest <= r + 1e-13);
    CHECK(largest > 0.99 * r);
  }
}

TEST_CASE("the inner radius is half the smallest width over all directions") {
  for (const Shape& shape : kShapes) {
    double smallest = 1e300;
    for (int k = 0; k < 20000; ++k) {
      const Vec3 u = random_direction();
      smallest = std::min(smallest, 0.5 * (support(shape, u) + support(shape, -u)));
    }
    const double r = inner_radius(shape);
    CHECK(smallest >= r - 1e-13);
    CHECK(smallest < 1.1 * r);
  }
}

TEST_CASE("a plane is unbounded") {
  const Shape plane = Plane{Vec3::UnitY(), 0.5};
  const Aabb aabb = bounds(plane, Vec3::Zero(), Mat3::Identity());
  CHECK(std::isinf(bounding_radius(plane)));
  CHECK(std::isinf(inner_radius(plane)));
  for (int k = 0; k < 3; ++k) {
    CHECK(aabb.lo[k] == -std::numeric_limits<double>::infinity());
    CHECK(aabb.hi[k] == std::numeric_limits<double>::infinity());
  }
}

}  // namespace pabd::test_shape
