// SPDX-License-Identifier: MIT
// See shader_stage.h.
#include "render/gl/shader_stage.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "render/gl/shader_log.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

[[noreturn]] void refuse(const GlFunctions& gl, const char* name, const char* how, std::string_view log,
                         std::span<const SourceLines> lines) {
  throw Error(ErrorKind::no_context, std::string("shader '") + name + "' " + how + gl.string(GL_RENDERER) +
                                         ": " + with_file_names(log, lines) + "; " + driver_remedy());
}

}  // namespace

GLuint compile_stage(const GlFunctions& gl, const char* name, GLenum stage,
                     std::span<const ShaderPart> parts) {
  std::string source;
  std::vector<SourceLines> lines;
  for (const ShaderPart& part : parts) {
    const std::string_view text = part.text;
    source += text;
    lines.push_back({part.file, static_cast<int>(std::count(text.begin(), text.end(), '\n'))});
  }
  const char* const text = source.c_str();
  const GLuint shader = gl.CreateShader(stage);
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  GLint ok = GL_FALSE;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (ok == GL_TRUE) return shader;
  std::string log(2048, ' ');
  gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  gl.DeleteShader(shader);
  refuse(gl, name, "was refused by ", log, lines);
}

GLuint link_stages(const GlFunctions& gl, const char* name, std::span<const GLuint> shaders) {
  const GLuint program = gl.CreateProgram();
  for (const GLuint shader : shaders) gl.AttachShader(program, shader);
  gl.LinkProgram(program);
  for (const GLuint shader : shaders) gl.DeleteShader(shader);
  GLint ok = GL_FALSE;
  gl.GetProgramiv(program, GL_LINK_STATUS, &ok);
  if (ok == GL_TRUE) return program;
  std::string log(2048, ' ');
  gl.GetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
  gl.DeleteProgram(program);
  refuse(gl, name, "does not link on ", log, {});
}

}  // namespace pabd
