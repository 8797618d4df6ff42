// SPDX-License-Identifier: MIT
// Where finished frames go: numbered PNG files, one PNG (the last frame), a video, or raw RGB on a
// descriptor.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "render/output/image.h"
#include "render/output/png.h"
#include "render/output/video_options.h"
#include "sim/base/output_path.h"

namespace pabd {

// Takes the frames of one output, in order.
class FrameSink {
 public:
  virtual ~FrameSink() =
      default;  // without finish(): nothing is left under a final name, but whole PNG frames stay
  // `frame` has the size of SinkOptions. Throws Error(file), Error(encoder), or Error(defect) for another
  // size.
  virtual void write(const Image& frame) = 0;
  virtual void finish() = 0;  // publishes; once; throws Error(file) or Error(encoder)
};

// What all kinds of output need to know.
struct SinkOptions {
  int width = 1280;  // pixels, 1 to 16384
  int height = 720;
  double fps = 60;                             // frames a second of a video, 0.01 to 1000
  int first_frame = 0;                         // number of the first frame written (for --resume)
  bool force = false;                          // overwrite what exists
  InputFiles inputs;                           // that are never overwritten
  double encoder_timeout = 60;                 // seconds that ffmpeg may make no progress
  std::function<PngText(int frame)> png_text;  // may be empty
  PngText about;                               // where a video came from, for its metadata; may be empty
  VideoOptions video;                          // how it is encoded
};

// "-": raw RGB on stdout · .mp4 .webm .gif: video through ffmpeg · "…{frame:04}….png": a PNG a frame ·
// "….png": the last frame. Throws Error(bad_input) for another name or an existing output without `force`,
// Error(file) for a folder that is missing or cannot be written, Error(encoder) without ffmpeg: all of it
// before the first frame.
//
// A video of odd size in .mp4 gets its last column or row twice, because its colours are stored at half
// resolution. A .gif holds at most 50 frames a second (viewers slow down faster ones): of 60 every second
// frame is kept. Metadata of a video: tags of the file with the keywords of `about`, and "title", its "Scene"; of a
// .gif a comment with a line each.
std::unique_ptr<FrameSink> make_sink(const std::string& out, const SinkOptions& options);
// The side of the file `out` whose frames have such a side; pixels.
int side_in_file(const std::string& out, int side);

// Path of frame `number` (>= 0) for a template with one "{frame}" or "{frame:0W}" field (W = 1 to 9) in the
// file name. is_frame_template: whether there is such a field, right or wrong. The others throw
// Error(bad_input) for a wrong one.
bool is_frame_template(const std::string& out);
std::filesystem::path frame_path(const std::string& out, int number);

// The frame to go on with (--resume): the smallest number without a file.
int first_missing_frame(const std::string& out);

// The smallest number >= `from` with a file, or -1.
int first_existing_frame(const std::string& out, int from);

}  // namespace pabd
