// SPDX-License-Identifier: MIT
// GL objects that delete themselves. The context must be current when they are made and when they go.
#pragma once

#include <utility>

#include "render/gl/gl_functions.h"

namespace pabd {

template <auto Generate, auto Delete>
class GlObject {
 public:
  explicit GlObject(const GlFunctions& gl) : gl_(&gl) { (gl.*Generate)(1, &id_); }
  ~GlObject() {
    if (id_ != 0) (gl_->*Delete)(1, &id_);
  }
  GlObject(GlObject&& other) noexcept : gl_(other.gl_), id_(std::exchange(other.id_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(id_, other.id_);
    return *this;
  }

  GLuint id() const { return id_; }

 private:
  const GlFunctions* gl_;
  GLuint id_ = 0;
};

using GlBuffer = GlObject<&GlFunctions::GenBuffers, &GlFunctions::DeleteBuffers>;
using GlVertexArray = GlObject<&GlFunctions::GenVertexArrays, &GlFunctions::DeleteVertexArrays>;
using GlTexture = GlObject<&GlFunctions::GenTextures, &GlFunctions::DeleteTextures>;
using GlRenderbuffer = GlObject<&GlFunctions::GenRenderbuffers, &GlFunctions::DeleteRenderbuffers>;
using GlFramebuffer = GlObject<&GlFunctions::GenFramebuffers, &GlFunctions::DeleteFramebuffers>;

// Storage for a texture of one level, which becomes that of the active unit; `filter`: GL_NEAREST or GL_LINEAR, clamped
// to the edge. `pixels` may be null.
inline void make_texture(const GlFunctions& gl, const GlTexture& texture, GLint format, GLsizei width,
                         GLsizei height, GLenum channels, GLenum type, GLint filter,
                         const void* pixels = nullptr) {
  gl.BindTexture(GL_TEXTURE_2D, texture.id());
  gl.TexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, channels, type, pixels);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

}  // namespace pabd
