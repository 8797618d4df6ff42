// SPDX-License-Identifier: MIT
// A bridge of planks that hang between two points of the world, each hinged to the next.
//
//   θ_k     slope of plank k                                             rad
//   t       difference of tan θ from plank to plank: weight of a plank over the horizontal tension
//   L       length of a plank                                            m
//
// With tan θ_k = t (k − (n − 1)/2) each plank without load is in equilibrium: the vertical force changes by
// one plank's weight from plank to plank. So all that moves is what the boxes set in motion.
#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "tests/bench/peers/peer_scenes.h"

namespace pabd::peers {

namespace {

constexpr int kPlanks = 50;
constexpr Vec3::Scalar kLength = 1, kPlankThickness = 0.1, kWidth = 2;  // of a plank; m
constexpr double kEndSlope = 0.5;                                       // tan θ of the outermost planks
constexpr int kLoaded[] = {12, 18, 24, 30, 36};                         // planks with a box on them
constexpr double kBox = 0.6, kGap = 0.0095;                             // edge and distance from the plank; m

std::string box(const std::string& name, const Vec3& size, const Vec3& at, double angle) {
  return fmt::format(
      R"({{"name": "{}", "shape": {{"type": "box", "size": [{}, {}, {}]}}, "position": [{}, {}, {}], )"
      R"("orientation": [{}, 0, 0, {}]}})",
      name, size.x(), size.y(), size.z(), at.x(), at.y(), at.z(), std::cos(angle / 2), std::sin(angle / 2));
}

std::string hinge(const std::string& a, const std::string& b, const Vec3& at) {
  return fmt::format(R"({{"type": "hinge", "bodies": [{}, {}], "anchor": [{}, {}, {}], "axis": [0, 0, 1]}})",
                     a, b, at.x(), at.y(), at.z());
}

}  // namespace

std::string bridge_members() {
  const double half = 0.5 * (kPlanks - 1);
  std::vector<double> slope;
  for (int k = 0; k < kPlanks; ++k) slope.push_back(std::atan(kEndSlope * (k - half) / half));

  std::string planks, boxes, joints;
  Vec3 pin(0, 20, 0);
  std::string before = "null";
  for (int k = 0; k < kPlanks; ++k) {
    const double angle = slope[static_cast<std::size_t>(k)];
    const Vec3 along(std::cos(angle), std::sin(angle), 0), up(-along.y(), along.x(), 0);
    const Vec3 middle = pin + 0.5 * kLength * along;
    const std::string name = fmt::format("plank {}", k), quoted = '"' + name + '"';
    planks += box(name, {kLength, kPlankThickness, kWidth}, middle, angle) + ", ";
    joints += hinge(before, quoted, pin) + ", ";
    for (const int loaded : kLoaded) {
      if (loaded != k) continue;
      const double above = 0.5 * (kPlankThickness + kBox) + kGap;
      boxes += ", " + box(fmt::format("box {}", k), Vec3::Constant(kBox), middle + above * up, angle);
    }
    pin += kLength * along;
    before = quoted;
  }
  planks.resize(planks.size() - 2);
  return R"("bodies": [)" + planks + boxes + R"(], "joints": [)" + joints + hinge(before, "null", pin) + "]";
}

}  // namespace pabd::peers
