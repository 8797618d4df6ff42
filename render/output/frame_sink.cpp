// SPDX-License-Identifier: MIT
// Chooses and checks where frames go, before the first one is made.
#include "render/output/frame_sink.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstddef>

#include "render/output/sinks.h"
#include "sim/base/error.h"

namespace pabd {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void refuse(const std::string& message) { throw Error(ErrorKind::bad_input, message); }

void check_options(const std::string& out, const SinkOptions& options) {
  const auto fits = [](int side) { return side >= 1 && side <= png_largest_side; };
  if (!fits(options.width) || !fits(options.height)) {
    refuse(fmt::format("{}: frames of {}x{} pixels; expected 1 to {} a side", out, options.width,
                       options.height, png_largest_side));
  }
  if (!std::isfinite(options.fps) || options.fps < 0.01 || options.fps > 1000) {
    refuse(fmt::format("{}: {} frames a second; expected 0.01 to 1000", out, options.fps));
  }
  if (options.first_frame < 0)
    refuse(fmt::format("{}: first frame {}; numbers start at 0", out, options.first_frame));
  if (options.first_frame > 0 && !is_frame_template(out)) {
    refuse(fmt::format("{}: only numbered PNG files can be resumed; use a name like frames/{{frame:04}}.png",
                       out));
  }
}

// "%d", "%04d": the way other programs number files.
bool has_percent_number(const std::string& name) {
  for (std::size_t at = name.find('%'); at != std::string::npos; at = name.find('%', at + 1)) {
    const std::size_t end = name.find_first_not_of("0123456789", at + 1);
    if (end != std::string::npos && (name[end] == 'd' || name[end] == 'i')) return true;
  }
  return false;
}

void check_sequence(const std::string& out, const SinkOptions& options) {
  const int existing = options.force ? -1 : first_existing_frame(out, options.first_frame);
  if (existing < 0) return;
  const char* remedy = options.first_frame == 0
                           ? "continue after the last frame with --resume, or replace the frames with --force"
                           : "remove the frames after the gap, or replace them with --force";
  refuse_existing(frame_path(out, existing).string(), remedy);
}

}  // namespace

void check_frame_size(const Image& frame, const SinkOptions& options) {
  const std::size_t bytes =
      static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height) * 3;
  if (frame.width == options.width && frame.height == options.height && frame.rgb.size() == bytes) return;
  throw Error(ErrorKind::defect,
              fmt::format("a frame of {}x{} pixels with {} bytes was written; expected {}x{}", frame.width,
                          frame.height, frame.rgb.size(), options.width, options.height));
}

std::unique_ptr<FrameSink> make_sink(const std::string& out, const SinkOptions& options) {
  check_options(out, options);
  check_video_options(fs::path(out).extension().string(), options.video);
  if (out == "-") return make_raw_sink(STDOUT_FILENO, "stdout", options);

  const fs::path path(out);
  const std::string extension = path.extension().string();
  const std::string name = path.filename().string();
  if (extension == ".png") {
    if (has_percent_number(name)) {
      refuse(
          fmt::format("{}: %d is not the way to number frames here; write {{frame}} or {{frame:04}}", out));
    }
    if (is_frame_template(out) || name.find_first_of("{}") != std::string::npos) {
      check_sequence(out, options);
      return make_png_sequence_sink(out, options);
    }
    check_overwrite(out, path, {options.force, &options.inputs});
    return make_last_png_sink(out, options);
  }
  if (is_frame_template(out)) {
    refuse(fmt::format("{}: numbered frames are PNG files; end the name with .png", out));
  }
  if (extension == ".mp4" || extension == ".webm" || extension == ".gif") {
    check_overwrite(out, path, {options.force, &options.inputs});
    return extension == ".gif" ? make_gif_sink(out, options) : make_video_sink(out, options);
  }
  refuse(fmt::format(
      "{}: unknown kind of output; expected a name that ends in .mp4, .webm, .gif or .png, or -", out));
}

}  // namespace pabd
