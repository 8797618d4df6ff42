// SPDX-License-Identifier: MIT
// One place a headless context may come from, as create_headless_context tries them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "render/context/context.h"

namespace pabd {

struct ContextCandidate {
  std::string name;
  // Returns a current context, or null with the reason in `failure`.
  std::function<std::unique_ptr<GlContext>(std::string& failure)> create;
};

inline constexpr int kGlMajor = 3;
inline constexpr int kGlMinor = 3;

// What is asked for, in this order: some drivers give no more than that, and compute shaders need 4.3.
struct GlVersion {
  int major, minor;
};
inline constexpr GlVersion kAskedVersions[] = {{4, 3}, {kGlMajor, kGlMinor}};

// Appends the candidates of EGL: each device (hardware first), then surfaceless. Never throws for a machine
// without.
void add_egl_candidates(std::vector<ContextCandidate>& out);
void add_osmesa_candidates(std::vector<ContextCandidate>& out);

// For Mesa's software renderer, before any GL library is opened. It takes vectors as wide as the processor's; every machine is
// asked for the same width, unless the user set LP_NATIVE_VECTOR_WIDTH. The memory of a frame stays with the process.
void prepare_software_gl();

// Asks the current context for its version; empty when it is at least the wanted one.
std::string check_gl_version(GlContext& context);

}  // namespace pabd
