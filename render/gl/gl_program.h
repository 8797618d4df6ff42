// SPDX-License-Identifier: MIT
// A vertex and a fragment shader, linked.
#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <string>

#include "render/gl/gl_objects.h"
#include "render/gl/quality.h"
#include "render/gl/shader_stage.h"

namespace pabd {

class GlProgram {
 public:
  // Each source is the concatenation of its parts, after "#version 330 core". Throws Error(no_context) with
  // `name` and the driver's words, in which lines are those of the parts' files; also where the driver lays
  // out the block Frame in another way than FrameUniforms.
  GlProgram(const GlFunctions& gl, const char* name, std::initializer_list<ShaderPart> vertex,
            std::initializer_list<ShaderPart> fragment);
  ~GlProgram();
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  GLuint id() const { return id_; }
  void use() const { gl_.UseProgram(id_); }
  GLint uniform(const char* name) const { return gl_.GetUniformLocation(id_, name); }

 protected:
  const GlFunctions& gl_;

 private:
  GLuint id_ = 0;
};

// A program that covers the viewport with one triangle, whose corners shaders/corner.glsl makes.
class ScreenProgram : public GlProgram {
 public:
  ScreenProgram(const GlFunctions& gl, const char* name, const ShaderPart& vertex,
                std::initializer_list<ShaderPart> fragment);
  void draw() const;

 private:
  GlVertexArray array_;
};

// Tells a program with shaders/lighting.glsl or sun_visibility.glsl the texture units of its maps. The program must be in use.
void bind_maps(const GlFunctions& gl, const GlProgram& program);

// What the shaders of a quality are compiled with. LIVE: fast; TAGGED: the alpha channel has a tag per thing;
// KERNEL: texels across the edges of shadows.
constexpr const char* quality_defines(Quality quality) {
  switch (quality) {
    case Quality::draft:
      return "#define LIVE\n#define KERNEL 2\n";
    case Quality::good:
      return "#define TAGGED\n#define KERNEL 6\n";
    case Quality::best:
      break;
  }
  return "#define KERNEL 6\n";
}

// Programs that each quality has of its own, compiled when it is first asked for.
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
