// SPDX-License-Identifier: MIT
// A vertex and a fragment shader, linked.
#pragma once

#include <initializer_list>
#include <string>

#include "render/gl/gl_objects.h"
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

}  // namespace pabd
