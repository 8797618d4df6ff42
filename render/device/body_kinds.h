// SPDX-License-Identifier: MIT
// What a model's bodies are, as the solver on the GPU reads it: bodies that are alike share a record.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/device/device_layout.h"
#include "render/device/shape_table.h"
#include "sim/body/model.h"

namespace pabd::device {

struct BodyKinds {
  std::vector<BodyKind> kinds;
  std::vector<std::uint32_t> of_body;  // its kind
  std::vector<std::uint32_t> planes;   // bodies
  double smallest_radius = 1;          // bounding radius of the smallest body that moves; m
};
BodyKinds make_body_kinds(const Model& model, const ShapeTable& shapes);

}  // namespace pabd::device
