// SPDX-License-Identifier: MIT
// Is a video what it should be? Asked before it gets its name.
#pragma once

#include <filesystem>
#include <string>

namespace pabd {

struct VideoFacts {
  int width = 0, height = 0;
  long frames = 0;
};

// Reads the whole file as a player would, through the ffmpeg program, without unpacking pictures. Throws
// Error(encoder) that begins with `name` if it holds anything but `expected`, or ffmpeg complains about it or
// says nothing for `patience` seconds.
void check_video(const std::string& name, const std::filesystem::path& file, const VideoFacts& expected,
                 double patience);

}  // namespace pabd
