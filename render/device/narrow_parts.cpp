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

std::vector<ShaderPart> narrow_parts(int kind_first, int kind_second, bool solids) {
  using namespace shaders;
  std::vector<ShaderPart> parts = {shape_table, narrow_common};
  if (solids && (kind_first == kDeviceHull || kind_second == kDeviceHull)) parts.push_back(narrow_solid);
  // A compound is one hull after the other.
  if (kind_first == kDeviceCompound || kind_second == kDeviceCompound) parts.push_back(narrow_compound);
  if (kind_first == kDeviceCompound) kind_first = kDeviceHull;
  if (kind_second == kDeviceCompound) kind_second = kDeviceHull;
  const auto add = [&](std::initializer_list<ShaderPart> more) {
    parts.insert(parts.end(), more);
    parts.insert(parts.end(), {narrow_found, narrow_again, narrow_measured});
    return parts;
  };
  const auto both = [](int i, int j) { return kDeviceShapes * std::min(i, j) + std::max(i, j); };
  switch (both(kind_first, kind_second)) {
    case both(kDeviceSphere, kDeviceSphere):
      return add({narrow_sphere_sphere});
    case both(kDeviceSphere, kDeviceCapsule):
      return add({narrow_capsule_sphere});
    case both(kDeviceCapsule, kDeviceCapsule):
      return add({narrow_side_by_side, narrow_capsule_capsule});
    case both(kDevicePlane, kDeviceSphere):
      return add({narrow_plane_sphere});
    case both(kDevicePlane, kDeviceCapsule):
      return add({narrow_plane_capsule});
    case both(kDevicePlane, kDeviceBox):
      return add({narrow_plane_box});
    case both(kDeviceBox, kDeviceSphere):
      return add({narrow_box_sphere});
    case both(kDeviceBox, kDeviceBox):
      return add({narrow_side_by_side, narrow_box_face, narrow_box_box});
    case both(kDevicePlane, kDeviceHull):
      return add({narrow_hull, narrow_spread, narrow_plane_hull});
    case both(kDeviceSphere, kDeviceHull):
      return add({narrow_hull, narrow_hull_sphere});
    case both(kDeviceBox, kDeviceCapsule):
    case both(kDeviceCapsule, kDeviceHull):
      return add({narrow_side_by_side, narrow_hull, narrow_hull_capsule});
    case both(kDeviceBox, kDeviceHull):
    case both(kDeviceHull, kDeviceHull):
      return add({narrow_side_by_side, narrow_hull, narrow_spread, narrow_hull_face, narrow_hull_hull});
    default:
      return {};
  }
}

}  // namespace pabd
