// SPDX-License-Identifier: MIT
// The shapes of a model as the shaders of the narrow phase read them (shaders/shape_table.glsl): each shape once.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/body/model.h"

namespace pabd {

// Kinds, in the order of the alternatives of Shape.
enum DeviceShape : int {
  kDeviceBox,
  kDeviceSphere,
  kDeviceCapsule,
  kDevicePlane,
  kDeviceHull,
  kDeviceShapes
};

inline constexpr std::size_t kMostDeviceHullFaces = 32;  // which have at most 60 vertices (Euler)

// One shape; what is in `size` is in shape_table.glsl. m.
struct ShapeRecord {
  double size[4];
  std::uint32_t kind, first, vertices, faces, corners, edges, unused[2];
};
static_assert(sizeof(ShapeRecord) == 64, "as std430 lays it out");

struct ShapeTable {
  std::vector<ShapeRecord> shapes;
  std::vector<std::uint64_t> hulls;    // never empty: it begins with the box of half edges 1
  std::vector<std::uint32_t> of_body;  // number in `shapes`
};

// Equal shapes share a record. Precondition: why_not_on_device() is empty.
ShapeTable make_shape_table(const Model& model);

// The first body whose shape the GPU cannot take, and why, in one line; empty when there is none.
std::string why_not_on_device(const Model& model);

}  // namespace pabd
