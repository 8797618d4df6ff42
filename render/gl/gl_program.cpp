// SPDX-License-Identifier: MIT
// Compiling and linking shaders.
#include "render/gl/gl_program.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "render/gl/frame_block.h"
#include "render/gl/shader_files.h"
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
  std::vector<ShaderPart> all = {{"header", kHeader}};
  all.insert(all.end(), parts.begin(), parts.end());
  return compile_stage(gl, name, stage, all);
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
  id_ = link_stages(gl, name, std::array{v, f});
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

ScreenProgram::ScreenProgram(const GlFunctions& gl, const char* name, const ShaderPart& vertex,
                             std::initializer_list<ShaderPart> fragment)
    : GlProgram(gl, name, {shaders::corner, vertex}, fragment), array_(gl) {}

void ScreenProgram::draw() const {
  gl_.BindVertexArray(array_.id());
  use();
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

void bind_maps(const GlFunctions& gl, const GlProgram& program) {
  constexpr std::pair<const char*, GLint> kUnits[] = {
      {"shadow_map", 0}, {"floor_map", 1}, {"shadow_range", 3}};
  for (const auto& [name, unit] : kUnits) {
    const GLint place = program.uniform(name);
    if (place >= 0) gl.Uniform1i(place, unit);
  }
}

}  // namespace pabd
