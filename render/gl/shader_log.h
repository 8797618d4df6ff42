// SPDX-License-Identifier: MIT
// What a driver says of a shader, with the names of its files.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace pabd {

// A part of a source, as long as it is.
struct SourceLines {
  std::string_view file;
  int lines = 0;
};

// The driver's words in one line, in which places in the whole source become places in its parts, which follow one
// another: "0:14(3): error" and "0(14) : error" become "lighting.glsl:2(3): error" and "lighting.glsl(2) : error"
// where a part of 12 lines precedes lighting.glsl. Numbers of source strings are of no use for it: Mesa forgets them.
std::string with_file_names(std::string_view log, std::span<const SourceLines> parts);

}  // namespace pabd
