// A vertex and a fragment shader, linked.
#pragma once

#include <initializer_list>
#include <string>

#include "render/gl/gl_functions.h"

namespace pabd {

class GlProgram {
 public:
  // Each source is the concatenation of its parts, after "#version 330 core". Throws Error(no_gl) with `name`
  // and the driver's words.
  GlProgram(const GlFunctions& gl, const char* name, std::initializer_list<const char*> vertex,
            std::initializer_list<const char*> fragment);
  ~GlProgram();
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  void use() const { gl_.UseProgram(id_); }
  GLint uniform(const char* name) const { return gl_.GetUniformLocation(id_, name); }

 private:
  const GlFunctions& gl_;
  GLuint id_ = 0;
};

// Tells a program that uses kLightingGlsl the texture units of its maps. The program must be in use.
void bind_maps(const GlFunctions& gl, const GlProgram& program);

}  // namespace pabd
