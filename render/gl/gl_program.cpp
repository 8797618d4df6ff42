// Compiling and linking shaders.
#include "render/gl/gl_program.h"

#include <vector>

#include "render/gl/frame_uniforms.h"
#include "sim/error.h"

namespace pabd {
namespace {

// The driver's words on one line.
std::string one_line(std::string log) {
  for (char& c : log) {
    if (c == '\n' || c == '\r' || c == '\0') c = ' ';
  }
  while (!log.empty() && log.back() == ' ') log.pop_back();
  return log;
}

GLuint compile(const GlFunctions& gl, const char* name, GLenum stage,
               std::initializer_list<const char*> parts) {
  std::vector<const char*> source = {"#version 330 core\n"};
  source.insert(source.end(), parts);
  const GLuint shader = gl.CreateShader(stage);
  gl.ShaderSource(shader, static_cast<GLsizei>(source.size()), source.data(), nullptr);
  gl.CompileShader(shader);
  GLint ok = GL_FALSE;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (ok == GL_TRUE) return shader;
  std::string log(2048, ' ');
  gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  gl.DeleteShader(shader);
  throw Error(ExitCode::no_gl, std::string("shader '") + name + "' was refused by " + gl.string(GL_RENDERER) +
                                   ": " + one_line(log) + "; try another --backend");
}

}  // namespace

GlProgram::GlProgram(const GlFunctions& gl, const char* name, std::initializer_list<const char*> vertex,
                     std::initializer_list<const char*> fragment)
    : gl_(gl) {
  const GLuint v = compile(gl, name, GL_VERTEX_SHADER, vertex);
  GLuint f = 0;
  try {
    f = compile(gl, name, GL_FRAGMENT_SHADER, fragment);
  } catch (...) {
    gl.DeleteShader(v);
    throw;
  }
  id_ = gl.CreateProgram();
  gl.AttachShader(id_, v);
  gl.AttachShader(id_, f);
  gl.LinkProgram(id_);
  gl.DeleteShader(v);
  gl.DeleteShader(f);
  GLint ok = GL_FALSE;
  gl.GetProgramiv(id_, GL_LINK_STATUS, &ok);
  if (ok != GL_TRUE) {
    std::string log(2048, ' ');
    gl.GetProgramInfoLog(id_, static_cast<GLsizei>(log.size()), nullptr, log.data());
    gl.DeleteProgram(id_);
    throw Error(ExitCode::no_gl, std::string("shader '") + name + "' does not link on " +
                                     gl.string(GL_RENDERER) + ": " + one_line(log) +
                                     "; try another --backend");
  }
  const GLuint block = gl.GetUniformBlockIndex(id_, "Frame");
  if (block != GL_INVALID_INDEX) gl.UniformBlockBinding(id_, block, kFrameBinding);
}

GlProgram::~GlProgram() { gl_.DeleteProgram(id_); }

}  // namespace pabd
