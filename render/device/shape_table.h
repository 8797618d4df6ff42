// SPDX-License-Identifier: MIT
// The shapes of a model as the shaders of the narrow phase read them (shaders/shape_table.glsl): each shape once.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/body/model.h"

namespace pabd {

// Kinds, in the order of the alternatives of Shape. A cylinder or a cone is the hull that stands for it.
enum DeviceShape : int {
  kDeviceBox,
  kDeviceSphere,
  kDeviceCapsule,
  kDevicePlane,
  kDeviceHull,
  kDeviceCompound,
  kDeviceShapes
};

inline constexpr std::size_t kMostDeviceHullFaces =
    32;  // of a part, which have at most 60 vertices (Euler); a solid has 64

// One shape; what is in `size` is in shape_table.glsl. m.
struct ShapeRecord {
  double size[4];
  std::uint32_t kind, first, vertices, faces, corners, edges, ends, parts;
};
static_assert(sizeof(ShapeRecord) == 64, "as std430 lays it out");

struct ShapeTable {
  std::vector<ShapeRecord> shapes;
  std::vector<std::uint64_t> hulls;                   // never empty: it begins with the box of half edges 1
  std::vector<std::uint32_t> of_body;                 // number in `shapes`
  bool has_solids = false;                            // cylinders or cones
  std::uint32_t face_corners = 4, hull_vertices = 8;  // the most of a hull or box
};

// Equal shapes share a record; the parts of compounds have theirs too. Precondition: why_not_on_device() is empty.
ShapeTable make_shape_table(const Model& model);

// The first body whose shape the GPU cannot take, and why, in one line; empty when there is none.
std::string why_not_on_device(const Model& model);

}  // namespace pabd
