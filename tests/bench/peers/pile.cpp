// SPDX-License-Identifier: MIT
// A pile that falls into a box without lid: the ground and four fixed walls around the bodies' grid, so that
// it stays deep instead of spreading.
#include <fmt/format.h>

#include "tests/bench/peers/peer_scenes.h"

namespace pabd::peers {

namespace {

constexpr double kSpacing = 1.2;    // of the bodies at the start; m
constexpr double kClearance = 0.1;  // of the outermost cells from the walls; m
constexpr double kThickness = 1;    // of a wall; m

std::string wall(const char* name, const Vec3& size, const Vec3& at) {
  return fmt::format(R"(, {{"name": "{}", "fixed": true, "shape": {{"type": "box", "size": [{}, {}, {}]}}, )"
                     R"("position": [{}, {}, {}]}})",
                     name, size.x(), size.y(), size.z(), at.x(), at.y(), at.z());
}

}  // namespace

std::string walled_pile_members(int columns) {
  const double inside = 0.5 * columns * kSpacing + kClearance, middle = inside + 0.5 * kThickness;
  const double height = (columns + 2) * kSpacing, long_side = 2 * (inside + kThickness);
  const Vec3 across(kThickness, height, long_side), along(long_side, height, kThickness);
  std::string bodies = R"({"name": "ground", "shape": {"type": "plane"}})";
  bodies += wall("left wall", across, {-middle, 0.5 * height, 0});
  bodies += wall("right wall", across, {middle, 0.5 * height, 0});
  bodies += wall("back wall", along, {0, 0.5 * height, -middle});
  bodies += wall("front wall", along, {0, 0.5 * height, middle});
  return fmt::format(
      R"("bodies": [{}], "generate": [{{"type": "pile", "count": {}, "columns": {}, "spacing": {}, )"
      R"("size": [0.6, 0.5, 0.5], "vary": 0.15, "seed": 7}}])",
      bodies, columns * columns * columns, columns, kSpacing);
}

}  // namespace pabd::peers
