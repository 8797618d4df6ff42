// SPDX-License-Identifier: MIT
// The map of values (render/visual/value_map.h) as shaders/device_draw_make.comp.glsl reads it.
#pragma once

#include "render/device/draw_buffers.h"

namespace pabd {
struct ValueRange;
}

namespace pabd::device {

inline constexpr int kValueColors =
    4096;  // of the map: what lies between two of them is off by less than 1e-7

// Bodies are coloured by a float each from now on; `values`: GL name of a buffer, 0: by their own colours again.
void set_value_colors(unsigned values, const ValueRange& range, DrawView& view, DrawBuffers& buffers);

}  // namespace pabd::device
