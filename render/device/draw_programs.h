// SPDX-License-Identifier: MIT
// Compute programs that make what is drawn of bodies: the parts and names that they share.
#pragma once

#include <span>
#include <string>

#include "render/device/compute_program.h"

namespace pabd::device {

inline constexpr unsigned kDrawThreads = 256;  // of a work group
inline constexpr unsigned kDepthCell = 2;      // pixels of a side (shaders/device_draw_depths.glsl)

// `classes`: meshes that are drawn by a command each. `defines`: more of them, whole lines. `parts`: what comes after the
// layout of view, poses and parts of bodies. Throws Error(no_context).
ComputeProgram compile_draw_program(const ComputeFunctions& gl, const char* name, std::size_t classes,
                                    const std::string& defines, std::span<const ShaderPart> parts);

// With a thread for each of `threads` things; what comes after it sees what it wrote.
void run_draw_program(const ComputeFunctions& gl, const ComputeProgram& program, std::size_t threads);

}  // namespace pabd::device
