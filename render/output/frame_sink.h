// Where finished frames go: numbered PNG files, one PNG (the last frame), a video, or raw RGB on a descriptor.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "render/output/image.h"
#include "render/output/png.h"

namespace pabd {

class FrameSink {
 public:
  virtual ~FrameSink() = default;  // without finish(): nothing is left under a final name, but whole PNG frames stay
  virtual void write(const Image& frame) = 0;  // throws Error(file) or Error(encoder)
  virtual void finish() = 0;                   // publishes; throws Error(file) or Error(encoder)
};

struct SinkOptions {
  int width = 1280;
  int height = 720;
  double fps = 60;
  int first_frame = 0;  // number of the first frame written (for --resume)
  bool force = false;   // overwrite what exists
  std::function<PngText(int frame)> png_text;  // may be empty
};

// "-": raw RGB on stdout · .mp4 .webm .gif: video through ffmpeg · "…{frame:04}….png": a PNG a frame · "….png": the last
// frame. Throws Error(bad_input) for another name or an existing output without `force`, Error(encoder) without ffmpeg.
std::unique_ptr<FrameSink> make_sink(const std::string& out, const SinkOptions& options);

// Path of frame `number` for a template with one "{frame}" or "{frame:0W}" field.
bool is_frame_template(const std::string& out);
std::filesystem::path frame_path(const std::string& out, int number);

}  // namespace pabd
