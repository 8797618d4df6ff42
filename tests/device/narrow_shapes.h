// SPDX-License-Identifier: MIT
// Shapes for tests of the narrow phase on the GPU.
#pragma once

#include <vector>

#include "render/device/shape_table.h"
#include "sim/body/shape.h"

namespace pabd::testing {

inline constexpr int kSolid = kDeviceShapes;  // a kind of its own here, on the GPU a hull

// Some of that kind: of DeviceShape, or kSolid.
std::vector<Shape> shapes_of(int kind);

}  // namespace pabd::testing
