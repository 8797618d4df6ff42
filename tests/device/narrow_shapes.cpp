// SPDX-License-Identifier: MIT
// See narrow_shapes.h.
#include "tests/device/narrow_shapes.h"

#include "sim/body/compound.h"
#include "sim/body/convex_hull.h"
#include "sim/body/shape_kind.h"
#include "tests/collision/reference.h"

namespace pabd::testing {

using namespace reference;

namespace {

// Three bars that cross, an angle, and stones side by side.
std::vector<Shape> compounds() {
  const auto box = [](const Vec3& lo, const Vec3& hi) {
    std::vector<Vec3> points;
    for (int k = 0; k < 8; ++k)
      points.emplace_back(k & 1 ? hi.x() : lo.x(), k & 2 ? hi.y() : lo.y(), k & 4 ? hi.z() : lo.z());
    return Hull{make_hull(points).hull};
  };
  // Not about the middle, where each bar would lie in a box as deep to one side as to the other.
  const Vec3 x(0.55, 0.12, 0.09), y(0.1, 0.6, 0.13), z(0.08, 0.11, 0.5), back(0.42, 0.45, 0.4);
  const auto bar = [&](const Vec3& end) { return box(-end.cwiseMin(back), end); };
  std::vector<Hull> stones;
  Random random(6);
  for (int k = 0; k < 3; ++k) {
    std::vector<Vec3> points;
    for (int i = 0; i < 9; ++i) points.push_back(Vec3(0.45 * (k - 1), 0, 0) + 0.4 * random.direction());
    stones.push_back(Hull{make_hull(points).hull});
  }
  return {make_compound({bar(x), bar(y), bar(z)}),
          make_compound({box({0, 0, -0.3}, {0.8, 0.2, 0.3}), box({0, 0.2, -0.3}, {0.2, 0.7, 0.3})}),
          make_compound(stones)};
}

}  // namespace

std::vector<Shape> shapes_of(int kind) {
  switch (kind) {
    case kDeviceCompound:
      return compounds();
    case kSolid:
      return {make_shape("cylinder", {0.4, 0.8}), make_shape("cylinder", {0.6, 0.1}),
              make_shape("cylinder", {0.1, 1.4}), make_shape("cone", {0.5, 1}),
              make_shape("cone", {0.6, 0.3})};
    case kDeviceBox:
      return {Box{{0.5, 0.5, 0.5}}, Box{{0.3, 0.5, 0.4}}, Box{{0.7, 0.2, 0.3}}, Box{{0.6, 0.03, 0.5}},
              Box{{0.05, 0.7, 0.08}}};
    case kDeviceSphere:
      return {Sphere{0.4}, Sphere{0.3}};
    case kDeviceCapsule:
      return {Capsule{0.2, 0.8}, Capsule{0.15, 0.9}, Capsule{0.3, 0.5}, Capsule{0.05, 0.9}};
    case kDevicePlane:
      return {Plane{Vec3::UnitY(), 0.1}, Plane{Vec3(0.6, 0.8, 0), -0.3}, Plane{Vec3(1, 2, -2) / 3, 0.2}};
    default:
      return {rock(4, 0.8, 11),   rock(9, 0.5, 8),    rock(12, 0.5, 1), hull_of_box({0.3, 0.5, 0.4}),
              prism(8, 0.4, 0.3), prism(30, 0.5, 0.2)};
  }
}

}  // namespace pabd::testing
