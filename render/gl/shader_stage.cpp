// SPDX-License-Identifier: MIT
// See shader_stage.h.
#include "render/gl/shader_stage.h"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/error.h"

namespace pabd {
namespace {

bool is_blank(char c) { return c == '\n' || c == '\r' || c == '\0' || c == ' '; }

// The lines that name an error, where there are any: some drivers warn of a hundred things first.
std::string errors_of(const std::string& log) {
  std::istringstream lines(log);
  std::string errors;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("error") != std::string::npos) errors += line + "\n";
  }
  return errors.empty() ? log : errors;
}

[[noreturn]] void refuse(const GlFunctions& gl, const char* name, const char* how, const std::string& log,
                         std::span<const SourceLines> lines) {
  throw Error(ErrorKind::no_context, std::string("shader '") + name + "' " + how + gl.string(GL_RENDERER) +
                                         ": " + with_file_names(errors_of(log), lines) + "; " +
                                         driver_remedy());
}

// The driver's log of a shader or a program, by the entry points for it.
std::string log_of(GLuint id, PFNGLGETSHADERIVPROC ask, PFNGLGETSHADERINFOLOGPROC read) {
  GLint length = 0;
  ask(id, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(std::clamp(length, 1, 1 << 20)), '\0');
  GLsizei written = 0;
  read(id, static_cast<GLsizei>(log.size()), &written, log.data());
  log.resize(static_cast<std::size_t>(std::max(written, 0)));
  return log;
}

}  // namespace

std::string with_file_names(std::string_view log, std::span<const SourceLines> parts) {
  // "file:line" of a place "0:line" at the beginning of `words` and how long that is; 0 where none is.
  const auto place = [&](std::string_view words, std::string& out) -> std::size_t {
    if (!words.starts_with("0:") && !words.starts_with("0(")) return 0;
    int line = 0;
    const char* const end = std::from_chars(words.data() + 2, words.data() + words.size(), line).ptr;
    for (const SourceLines& part : parts) {
      if (line >= 1 && line <= part.lines) {
        out.append(part.file).append(1, words[1]).append(std::to_string(line));
        return static_cast<std::size_t>(end - words.data());
      }
      line -= part.lines;
    }
    return 0;
  };
  std::string out;
  for (std::size_t i = 0; i < log.size();) {
    const bool begins = i == 0 || is_blank(log[i - 1]);
    const std::size_t taken = begins ? place(log.substr(i), out) : 0;
    if (taken == 0) out += is_blank(log[i]) ? ' ' : log[i];
    i += std::max<std::size_t>(1, taken);
  }
  out.erase(out.find_last_not_of(' ') + 1);
  return out;
}

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
  const std::string log = log_of(shader, gl.GetShaderiv, gl.GetShaderInfoLog);
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
  const std::string log = log_of(program, gl.GetProgramiv, gl.GetProgramInfoLog);
  gl.DeleteProgram(program);
  refuse(gl, name, "does not link on ", log, {});
}

}  // namespace pabd
