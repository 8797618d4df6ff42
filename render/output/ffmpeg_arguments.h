// SPDX-License-Identifier: MIT
// Command lines of ffmpeg.
#pragma once

#include <fmt/format.h>

#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace pabd {

using Arguments = std::vector<std::string>;

// Complains of what is wrong, and says nothing else.
inline constexpr const char* kQuietFfmpeg = "-nostdin -hide_banner -nostats -loglevel error";

// The words of a command line, which blanks set apart.
template <class... T>
Arguments words(fmt::format_string<T...> line, T&&... values) {
  std::istringstream in(fmt::format(line, std::forward<T>(values)...));
  Arguments out;
  for (std::string word; in >> word;) out.push_back(word);
  return out;
}

inline void append(Arguments& arguments, const Arguments& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
}

// Pictures from pipe:0, frame after frame.
inline Arguments raw_input(const char* format, int width, int height, double fps) {
  return words("-f rawvideo -pixel_format {} -video_size {}x{} -framerate {:.10g} -i pipe:0 -an", format,
               width, height, fps);
}

// What ffmpeg said, without the addresses of its parts: "[libx264 @ 0x5632…] broken" is "[libx264] broken".
inline std::string without_addresses(std::string said) {
  constexpr std::string_view kAt = " @ 0x";
  for (auto at = said.find(kAt); at != std::string::npos; at = said.find(kAt, at))
    said.erase(at, said.find_first_not_of("0123456789abcdef", at + kAt.size()) - at);
  return said;
}

// A file, also one whose name has blanks or a colon.
inline std::string file_argument(const std::string& path) { return "file:" + path; }

}  // namespace pabd
