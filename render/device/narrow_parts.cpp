// SPDX-License-Identifier: MIT
// See narrow_parts.h.
#include "render/device/narrow_parts.h"

#include <algorithm>

#include "render/device/shader_files.h"

namespace pabd {

std::string hull_sizes(const ShapeTable& table) {
  return "#define FACE_CORNERS " + std::to_string(table.face_corners) + "\n#define HULL_VERTICES " +
         std::to_string(table.hull_vertices) + "\n";
}

namespace {

// A pair of kinds of DeviceShape, the lower one first; the parts in the order of their functions.
struct PairOfKinds {
  int low, high;
  ShaderPart room;  // MOST_FOUND: how many contacts add_contact keeps at most
  std::vector<ShaderPart> parts;
};

const std::vector<PairOfKinds>& pairs_of_kinds() {
  using namespace shaders;
  static const ShaderPart one = {"room", "#define MOST_FOUND 1\n"}, two = {"room", "#define MOST_FOUND 2\n"},
                          three = {"room", "#define MOST_FOUND 3\n"},
                          five = {"room", "#define MOST_FOUND 5\n"},
                          eight = {"room", "#define MOST_FOUND 8\n"},
                          eleven = {"room", "#define MOST_FOUND 11\n"};
  // Capsules: two ends and what is nearer. A capsule: two over a face, three along an edge. Hulls: eight over a face, three
  // along edges.
  static const std::vector<PairOfKinds> pairs = {
      {kDeviceSphere, kDeviceSphere, one, {round_contact, sphere_sphere}},
      {kDeviceSphere, kDeviceCapsule, one, {round_contact, capsule_sphere}},
      {kDeviceCapsule, kDeviceCapsule, three, {round_contact, side_by_side, capsule_capsule}},
      {kDeviceSphere, kDevicePlane, one, {plane_sphere}},
      {kDeviceCapsule, kDevicePlane, two, {plane_capsule}},
      {kDeviceBox, kDevicePlane, one, {narrow_plane_box}},
      {kDeviceBox, kDeviceSphere, one, {box_sphere}},
      {kDeviceBox, kDeviceCapsule, five, {side_by_side, narrow_hull, hull_distance, hull_capsule}},
      {kDeviceBox, kDeviceBox, three, {side_by_side, narrow_box_face, narrow_box_box}},
      {kDevicePlane, kDeviceHull, eight, {narrow_hull, narrow_spread, narrow_plane_hull}},
      {kDeviceSphere, kDeviceHull, one, {narrow_hull, hull_distance, hull_sphere}},
      {kDeviceCapsule, kDeviceHull, five, {side_by_side, narrow_hull, hull_distance, hull_capsule}},
      {kDeviceBox,
       kDeviceHull,
       eleven,
       {side_by_side, narrow_hull, hull_distance, narrow_spread, narrow_hull_face, narrow_hull_hull}},
      {kDeviceHull,
       kDeviceHull,
       eleven,
       {side_by_side, narrow_hull, hull_distance, narrow_spread, narrow_hull_face, narrow_hull_hull}},
  };
  return pairs;
}

}  // namespace

std::vector<ShaderPart> narrow_parts(int kind_first, int kind_second, bool solids) {
  using namespace shaders;
  std::vector<ShaderPart> out = {shape_table, narrow_common, pair_common};
  if (solids && (kind_first == kDeviceHull || kind_second == kDeviceHull)) out.push_back(narrow_solid);
  // A compound is one hull after the other.
  if (kind_first == kDeviceCompound || kind_second == kDeviceCompound) out.push_back(narrow_compound);
  if (kind_first == kDeviceCompound) kind_first = kDeviceHull;
  if (kind_second == kDeviceCompound) kind_second = kDeviceHull;
  for (const auto& [low, high, room, parts] : pairs_of_kinds()) {
    if (low != std::min(kind_first, kind_second) || high != std::max(kind_first, kind_second)) continue;
    out.push_back(room);
    out.insert(out.end(), parts.begin(), parts.end());
    out.insert(out.end(), {narrow_found, narrow_again, narrow_measured});
    return out;
  }
  return {};
}

}  // namespace pabd
