// SPDX-License-Identifier: MIT
// H.264 for whoever looks now: a picture in, its access unit out, by the ffmpeg program.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <string>

#include "render/output/encoder_process.h"
#include "render/output/flv_units.h"
#include "render/output/video_options.h"

namespace pabd {

// NVENC where ffmpeg can use it, else libx264; tried with one frame. Throws Error(encoder) with ffmpeg's words when
// there is neither.
VideoEncoder live_video_encoder();

struct LiveVideoSetup {
  int width = 0, height = 0;  // pixels, even
  int crf = 23;               // 0 … 51, smaller is better
  VideoEncoder encoder = VideoEncoder::software;
  double patience = 5;         // s for a picture
  double start_patience = 60;  // s for the first: ffmpeg's libraries may have to come from a slow disk
};

// The first unit is a key frame, no other one is; each needs only those before it. Every unit begins with a
// delimiter.
class LiveVideo {
 public:
  // Throws Error(encoder) when ffmpeg cannot be started.
  explicit LiveVideo(const LiveVideoSetup& setup);
  ~LiveVideo();

  // Planes Y, U and V, 4:2:0, of BT.601 with 256 steps, 3/2 width × height bytes. Waits for the unit. Throws
  // Error(encoder) with ffmpeg's words; then the stream is over.
  VideoUnit encode(std::span<const std::uint8_t> yuv);

 private:
  LiveVideoSetup setup_;
  std::mutex mutex_;
  std::condition_variable arrived_;
  std::string heard_;
  FlvUnits units_;
  std::unique_ptr<EncoderProcess> ffmpeg_;  // ends before what its listener fills
};

}  // namespace pabd
