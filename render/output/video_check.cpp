// SPDX-License-Identifier: MIT
// See video_check.h. The format "framecrc" prints the size of the picture, then a line a frame.
#include "render/output/video_check.h"

#include <fmt/format.h>

#include <cstdio>

#include "sim/base/child_process.h"
#include "sim/base/counted.h"
#include "sim/base/error.h"

namespace pabd {

void check_video(const std::string& name, const std::filesystem::path& file, const VideoFacts& expected,
                 double patience) {
  VideoFacts found;
  const ChildOutcome outcome =
      run_child({"ffmpeg", "-nostdin", "-hide_banner", "-nostats", "-loglevel", "error", "-i",
                 "file:" + file.string(), "-map", "0:v:0", "-c", "copy", "-f", "framecrc", "pipe:1"},
                patience, [&](std::string_view line) {
                  if (line.starts_with("#dimensions 0: ")) {
                    std::sscanf(std::string(line.substr(15)).c_str(), "%dx%d", &found.width, &found.height);
                  } else if (!line.empty() && line.front() != '#') {
                    ++found.frames;
                  }
                });
  const auto refuse = [&](const std::string& what) {
    throw Error(
        ErrorKind::encoder,
        fmt::format("{}: ffmpeg ended well, but what it wrote {}; the video was not kept: is the disk "
                    "full?",
                    name, what));
  };
  if (outcome.too_slow) refuse(fmt::format("could not be read back within {:g} s", patience));
  if (outcome.status != 0 || !outcome.errors.empty())
    refuse("cannot be read back (" + one_line(outcome.errors) + ")");
  if (found.frames != expected.frames || found.width != expected.width || found.height != expected.height) {
    refuse(fmt::format("has {} of {}x{} pixels, not {} of {}x{}", counted(found.frames, "frame"), found.width,
                       found.height, expected.frames, expected.width, expected.height));
  }
}

}  // namespace pabd
