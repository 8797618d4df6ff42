// SPDX-License-Identifier: MIT
// Programs that each quality has of its own, compiled when it is first asked for.
#pragma once

#include <array>
#include <optional>

#include "render/gl/gl_functions.h"
#include "render/gl/quality.h"

namespace pabd {

// What the shaders of a quality are compiled with. LIVE: in a hurry; TAGGED: things are told apart in the alpha channel;
// KERNEL: texels across the edges of shadows.
constexpr const char* quality_defines(Quality quality) {
  switch (quality) {
    case Quality::draft:
      return "#define LIVE\n#define KERNEL 2\n";
    case Quality::good:
      return "#define TAGGED\n#define KERNEL 4\n";
    case Quality::best:
      break;
  }
  return "#define KERNEL 6\n";
}

template <class Programs>
class PerQuality {
 public:
  explicit PerQuality(const GlFunctions& gl) : gl_(gl) {}

  // Throws Error(no_context) when the driver refuses a shader.
  const Programs& of(Quality quality) {
    auto& programs = programs_[static_cast<std::size_t>(quality)];
    if (!programs) programs.emplace(gl_, quality_defines(quality));
    return *programs;
  }

 private:
  const GlFunctions& gl_;
  std::array<std::optional<Programs>, 3> programs_;
};

}  // namespace pabd
