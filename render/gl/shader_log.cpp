// SPDX-License-Identifier: MIT
// See shader_log.h.
#include "render/gl/shader_log.h"

#include <algorithm>
#include <charconv>

namespace pabd {
namespace {

bool is_blank(char c) { return c == '\n' || c == '\r' || c == '\0' || c == ' '; }

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

}  // namespace pabd
