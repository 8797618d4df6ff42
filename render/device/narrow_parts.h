// SPDX-License-Identifier: MIT
// The shaders of the narrow phase: which files a pair of kinds needs.
#pragma once

#include <string>
#include <vector>

#include "render/device/shape_table.h"
#include "render/gl/shader_stage.h"

namespace pabd {

// The numbers that these shaders compute with: macros that come before them.
inline constexpr const char* kWideIsFloat =
    "#define WIDE_IS_FLOAT\n#define wide float\n#define wide2 vec2\n#define wide3 vec3\n#define wide4 vec4\n"
    "#define mat_wide3 mat3\n#define WIDE_EPSILON wide(1.2e-7lf)\n";
inline constexpr const char* kWideIsDouble =
    "#define wide double\n#define wide2 dvec2\n#define wide3 dvec3\n#define wide4 dvec4\n"
    "#define mat_wide3 dmat3\n#define WIDE_EPSILON wide(2.2e-16lf)\n";

// How large the hulls of these shapes are: macros, too. Private arrays as large as any hull that is allowed would leave a
// GPU room for a few work groups at a time.
std::string hull_sizes(const ShapeTable& table);

// The files that define find_contacts (shaders/narrow_common.glsl says how to call it) for two bodies of these kinds of
// DeviceShape, in either order; a main follows them. Empty for two planes, which never meet. `solids`: hulls may stand for
// cylinders and cones; where they do, SOLIDS is defined. PARTS is where one is a compound: then contacts are found of two parts at a time.
std::vector<ShaderPart> narrow_parts(int kind_first, int kind_second, bool solids);

}  // namespace pabd
