// SPDX-License-Identifier: MIT
// Programs: errors name files and lines, and the uniform block lies in memory as the driver reads it.
#include <catch2/catch.hpp>

#include "render/gl/frame_block.h"
#include "render/gl/shader_stage.h"
#include "sim/base/error.h"
#include "tests/gl/render_fixture.h"

namespace pabd::test_program {

using Catch::Matchers::Contains;

TEST_CASE("a driver's words name files, however it writes numbers") {
  const SourceLines parts[] = {{"frame_block.h", 7}, {"ground.frag.glsl", 20}};
  CHECK(with_file_names(std::string_view("0:14(3): error: no r\n\0  ", 24), parts) ==
        "ground.frag.glsl:7(3): error: no r");
  CHECK(with_file_names("0(7) : error C1008\n0(8) : warning\n", parts) ==
        "frame_block.h(7) : error C1008 ground.frag.glsl(1) : warning");
  CHECK(with_file_names("ERROR: 0:27: 'x' : undeclared", parts) ==
        "ERROR: ground.frag.glsl:20: 'x' : undeclared");
  CHECK(with_file_names("0:28(3): 0 errors, x0:2, 10:1, 0:", parts) == "0:28(3): 0 errors, x0:2, 10:1, 0:");
  CHECK(with_file_names("", parts).empty());
}

TEST_CASE("a shader that does not compile names its file and line") {
  const RenderFixture f(16, 16);
  const GlFunctions gl(*f.context);
  const ShaderPart vertex = {"good.vert.glsl", "void main() { gl_Position = vec4(0.0); }\n"};
  const ShaderPart part = {"good.glsl", "float halved(float x) { return 0.5 * x; }\n\n"};
  const ShaderPart bad = {"bad.frag.glsl",
                          "out vec4 fragment;\nvoid main() {\n  fragment = vec4(nobody);\n}\n"};
  CHECK_THROWS_WITH((GlProgram(gl, "test", {vertex}, {part, bad})),
                    Contains("shader 'test'") && Contains("bad.frag.glsl:3"));
}

TEST_CASE("the driver's offsets of the uniform block are those of the struct") {
  const RenderFixture f(16, 16);
  const GlFunctions gl(*f.context);
  const ShaderPart vertex = {"v", "void main() { gl_Position = frame.eye; }\n"};
  const ShaderPart fragment = {"f", "out vec4 fragment;\nvoid main() { fragment = vec4(1.0); }\n"};
  const GlProgram program(gl, "test", {frame_block(), vertex}, {fragment});
  CHECK(block_mismatch(gl, program.id(), frame_members()).empty());

  // The size that GL reserves is that of the struct: no member is missing in either.
  GLint size = 0;
  const GLuint block = gl.GetUniformBlockIndex(program.id(), "Frame");
  gl.GetActiveUniformBlockiv(program.id(), block, GL_UNIFORM_BLOCK_DATA_SIZE, &size);
  CHECK(size == static_cast<GLint>(sizeof(FrameUniforms)));

  const BlockMember moved[] = {{"Frame.eye", offsetof(FrameUniforms, light)}};
  CHECK_THAT(block_mismatch(gl, program.id(), moved), Contains("Frame.eye lies at byte 192"));
  const BlockMember unknown[] = {{"Frame.nobody", 0}};
  CHECK_THAT(block_mismatch(gl, program.id(), unknown), Contains("Frame.nobody"));
}

}  // namespace pabd::test_program
