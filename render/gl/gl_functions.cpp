// SPDX-License-Identifier: MIT
// Looking up the GL entry points, and errors in words.
#include "render/gl/gl_functions.h"

#include "sim/base/error.h"

namespace pabd {

GlFunctions::GlFunctions(GlContext& context) {
#define PABD_LOAD(entry, type)                                                                \
  entry = reinterpret_cast<PFNGL##type##PROC>(context.proc_address("gl" #entry));             \
  if (entry == nullptr) {                                                                     \
    throw Error(ErrorKind::no_context,                                                        \
                context.name() + ": the driver lacks gl" #entry +                             \
                    " of OpenGL 3.3; update Mesa or the GPU driver, or: " + driver_remedy()); \
  }
  PABD_GL_FUNCTIONS(PABD_LOAD)
#undef PABD_LOAD
}

std::string GlFunctions::string(GLenum name) const {
  const GLubyte* text = GetString(name);
  return text != nullptr ? reinterpret_cast<const char*>(text) : "unknown";
}

GLint GlFunctions::integer(GLenum name) const {
  GLint value = 0;
  GetIntegerv(name, &value);
  return value;
}

void GlFunctions::set(const DrawState& state) const {
  const auto turn = [&](GLenum what, bool on) { on ? Enable(what) : Disable(what); };
  turn(GL_DEPTH_TEST, state.depth_test);
  turn(GL_CULL_FACE, state.cull);
  turn(GL_BLEND, state.blend);
  DepthFunc(state.depth);
  DepthMask(state.write_depth ? GL_TRUE : GL_FALSE);
}

void GlFunctions::forget_errors() const {
  constexpr int kKinds = 16;  // each kind has one flag; a context that is lost never ends to say so
  for (int i = 0; i < kKinds && GetError() != GL_NO_ERROR; ++i) {
  }
}

void GlFunctions::check(const char* doing) const {
  const GLenum error = GetError();
  if (error == GL_NO_ERROR) return;
  forget_errors();
  throw Error(ErrorKind::no_context, std::string(doing) + " failed with " + gl_error_name(error) + " (" +
                                         string(GL_RENDERER) + ", " + string(GL_VERSION) +
                                         "); try a smaller --size, or: " + driver_remedy());
}

const char* gl_error_name(GLenum error) {
  switch (error) {
    case GL_NO_ERROR:
      return "GL_NO_ERROR";
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "GL_OUT_OF_MEMORY";
    case 0x0507:  // of GL 4.5
      return "GL_CONTEXT_LOST";
    default:
      return "an unknown GL error";
  }
}

}  // namespace pabd
