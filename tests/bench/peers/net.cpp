// SPDX-License-Identifier: MIT
// A net of hubs and rods that hangs from its four corners: a rod between neighbours, with a spherical joint
// on the face of each of the two hubs. 100 × 100 hubs have 29,800 bodies and 39,600 joints.
#include <fmt/format.h>

#include "tests/bench/peers/peer_scenes.h"

namespace pabd::peers {

namespace {

constexpr double kPitch = 1, kHub = 0.2,
                 kRod = 0.04;  // distance of hubs, edge of a hub, thickness of a rod; m

std::string body(const std::string& name, const Vec3& size, const Vec3& at, bool fixed) {
  return fmt::format(R"({{"name": "{}", "fixed": {}, "shape": {{"type": "box", "size": [{}, {}, {}]}}, )"
                     R"("position": [{}, {}, {}]}}, )",
                     name, fixed, size.x(), size.y(), size.z(), at.x(), at.y(), at.z());
}

std::string ball_joint(const std::string& a, const std::string& b, const Vec3& at) {
  return fmt::format(R"({{"type": "spherical", "bodies": ["{}", "{}"], "anchor": [{}, {}, {}]}}, )", a, b,
                     at.x(), at.y(), at.z());
}

std::string hub_name(int row, int column) { return fmt::format("hub {}.{}", row, column); }

}  // namespace

std::string hub_net_members(int side) {
  const auto place = [&](int row, int column) -> Vec3 {
    return kPitch * Vec3(column - 0.5 * (side - 1), 0, row - 0.5 * (side - 1));
  };
  std::string bodies, joints;
  const auto rod = [&](int row, int column, int next_row, int next_column) {
    const Vec3 from = place(row, column), to = place(next_row, next_column);
    const Vec3 along = (to - from).normalized();
    const std::string name = fmt::format("rod {}.{} {}.{}", row, column, next_row, next_column);
    const Vec3 size = Vec3::Constant(kRod) + (kPitch - kHub - kRod) * along;
    bodies += body(name, size, 0.5 * (from + to), false);
    joints += ball_joint(hub_name(row, column), name, from + 0.5 * kHub * along);
    joints += ball_joint(name, hub_name(next_row, next_column), to - 0.5 * kHub * along);
  };
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const bool corner = (row == 0 || row + 1 == side) && (column == 0 || column + 1 == side);
      bodies += body(hub_name(row, column), Vec3::Constant(kHub), place(row, column), corner);
      if (column + 1 < side) rod(row, column, row, column + 1);
      if (row + 1 < side) rod(row, column, row + 1, column);
    }
  }
  bodies.resize(bodies.size() - 2);
  joints.resize(joints.size() - 2);
  return R"("bodies": [)" + bodies + R"(], "joints": [)" + joints + "]";
}

}  // namespace pabd::peers
