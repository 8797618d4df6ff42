// SPDX-License-Identifier: MIT
// The shaders of the narrow phase: which files a pair of kinds needs.
#pragma once

#include <vector>

#include "render/device/shape_table.h"
#include "render/gl/shader_stage.h"

namespace pabd {

// The files that define find_contacts (shaders/narrow_common.glsl says how to call it) for two bodies of these kinds of
// DeviceShape, in either order; a main follows them. Empty for two planes, which never meet.
std::vector<ShaderPart> narrow_parts(int kind_first, int kind_second);

}  // namespace pabd
