// SPDX-License-Identifier: MIT
// Moving frames as one stream of H.264, for one visitor: when it begins, goes on and ends.
#pragma once

#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/output/image.h"
#include "render/output/live_video.h"

namespace pabd {

// Starting ffmpeg takes longer than a frame may: it happens aside, after a row of frames of one size and
// quality, and until it has happened the frames go another way.
class MovingVideo {
 public:
  static constexpr int kRow = 8;       // frames before it begins
  static constexpr double kBreak = 2;  // s without a frame that end a row

  // None: never.
  explicit MovingVideo(std::optional<VideoEncoder> encoder) : encoder_(encoder) {}

  // The units that end with `image`: one, or two where the stream begins, the first one with an older picture.
  // None: it goes another way. `quality` is that of JPEG, 1 … 100.
  std::vector<VideoUnit> encode(const Image& image, int quality, double now);
  // What was sent is not to be built upon.
  void restart();
  // Why there is none any more; empty: all is well.
  const std::string& failure() const { return failure_; }

  // H.264's crf of about the same looks: 92 → 18, 85 → 20, 40 → 37.
  static int crf_of(int quality);

 private:
  struct Shape {
    int width = 0, height = 0, quality = 0;
    bool operator==(const Shape&) const = default;
  };
  struct Started {
    std::unique_ptr<LiveVideo> video;
    VideoUnit first;
  };
  bool in_row(const Shape& shape, double now);
  void begin(const Image& image);
  std::vector<VideoUnit> go_on(const Image& image);

  std::optional<VideoEncoder> encoder_;
  std::string failure_;
  Shape shape_;  // of the row
  int row_ = 0;
  double last_ = -1e9;
  std::unique_ptr<LiveVideo> video_;
  std::future<Started> starting_;
  bool wanted_ = false;  // what is being started
};

// Planes Y, U and V of BT.601 with 256 steps, 4:2:0; odd sides grow by a pixel that repeats the last one.
std::vector<std::uint8_t> to_yuv420(const Image& image);

}  // namespace pabd
