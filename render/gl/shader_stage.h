// SPDX-License-Identifier: MIT
// Compiling one shader and linking several, with errors that name files and lines.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "render/gl/gl_functions.h"

namespace pabd {

// GLSL of a file, or of what stands for one: whole lines. The texts outlive it.
struct ShaderPart {
  const char* file;  // how errors name it: "ground.frag.glsl"
  const char* text;
};

// A shader of `stage` from its parts in order; the first has the #version. Throws Error(no_context) with `name` and the
// driver's words, in which lines are those of the parts' files.
GLuint compile_stage(const GlFunctions& gl, const char* name, GLenum stage,
                     std::span<const ShaderPart> parts);

// A part of a source, as long as it is.
struct SourceLines {
  std::string_view file;
  int lines = 0;
};

// The driver's words in one line, in which places in the whole source become places in its parts, which follow one
// another: "0:14(3): error" and "0(14) : error" become "lighting.glsl:2(3): error" and "lighting.glsl(2) : error"
// where a part of 12 lines precedes lighting.glsl. Numbers of source strings are of no use for it: Mesa forgets them.
std::string with_file_names(std::string_view log, std::span<const SourceLines> parts);

// A program of these shaders, which are deleted. Throws Error(no_context) with `name` and the driver's words.
GLuint link_stages(const GlFunctions& gl, const char* name, std::span<const GLuint> shaders);

}  // namespace pabd
