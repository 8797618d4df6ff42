// SPDX-License-Identifier: MIT
// Compiling and linking shaders.
#include "render/gl/gl_program.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "render/gl/frame_block.h"
#include "render/gl/shader_log.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

// Gathering is core in GL 4.0 only, but nearly every 3.3 driver has it; shaders test for the macro.
constexpr const char* kHeader =
    "#version 330 core\n"
    "#ifdef GL_ARB_texture_gather\n"
    "#extension GL_ARB_texture_gather : enable\n"
    "#endif\n";

GLuint compile(const GlFunctions& gl, const char* name, GLenum stage,
               std::initializer_list<ShaderPart> parts) {
  std::string source;
  std::vector<SourceLines> lines;
  const auto add = [&](const ShaderPart& part) {
    const std::string_view text = part.text;
    source += text;
    lines.push_back({part.file, static_cast<int>(std::count(text.begin(), text.end(), '\n'))});
  };
  add({"header", kHeader});
  for (const ShaderPart& part : parts) add(part);
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
  throw Error(ErrorKind::no_context, std::string("shader '") + name + "' was refused by " +
                                         gl.string(GL_RENDERER) + ": " + with_file_names(log, lines) + "; " +
                                         driver_remedy());
}

}  // namespace

GlProgram::GlProgram(const GlFunctions& gl, const char* name, std::initializer_list<ShaderPart> vertex,
                     std::initializer_list<ShaderPart> fragment)
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
    throw Error(ErrorKind::no_context, std::string("shader '") + name + "' does not link on " +
                                           gl.string(GL_RENDERER) + ": " + with_file_names(log, {}) + "; " +
                                           driver_remedy());
  }
  const GLuint block = gl.GetUniformBlockIndex(id_, "Frame");
  if (block == GL_INVALID_INDEX) return;
  const std::string mismatch = block_mismatch(gl, id_, frame_members());
  if (!mismatch.empty()) {
    gl.DeleteProgram(id_);
    throw Error(ErrorKind::no_context, std::string("shader '") + name + "' on " + gl.string(GL_RENDERER) +
                                           ": " + mismatch + "; " + driver_remedy());
  }
  gl.UniformBlockBinding(id_, block, kFrameBinding);
}

GlProgram::~GlProgram() { gl_.DeleteProgram(id_); }

void bind_maps(const GlFunctions& gl, const GlProgram& program) {
  constexpr std::pair<const char*, GLint> kUnits[] = {
      {"shadow_map", 0}, {"floor_map", 1}, {"shadow_range", 3}};
  for (const auto& [name, unit] : kUnits) {
    const GLint place = program.uniform(name);
    if (place >= 0) gl.Uniform1i(place, unit);
  }
}

}  // namespace pabd
