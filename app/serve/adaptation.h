// SPDX-License-Identifier: MIT
// Resolution and quality of moving frames, chosen so that encoding and link sustain 25 frames a second.
#pragma once

#include <array>
#include <cstddef>

namespace pabd {

struct FrameLook {
  double scale = 1;  // of width and height
  int quality = 85;  // of JPEG
  bool operator==(const FrameLook&) const = default;
};

class Adaptation {
 public:
  enum class Mode { automatic, fast, fine };
  static constexpr double kFrameMs = 40;  // time for a frame: 25 a second

  void choose(Mode mode);

  // A frame of `bytes` was acknowledged at `now` (s). `link_ms`: from sending to the acknowledgement, without the time
  // that the page took to show it.
  void took(double encode_ms, double link_ms, std::size_t bytes, double now);

  FrameLook look() const;
  double link_ms() const { return link_ms_; }
  double encode_ms() const { return encode_ms_; }

 private:
  Mode mode_ = Mode::automatic;
  std::size_t level_ = 0;
  // Median of the latest link times, less that of frames of almost no size: what the size of frames costs.
  double transfer_ms() const;

  double encode_ms_ = 0, link_ms_ = 0;  // smoothed
  double empty_ms_ = 0;                 // link time of the smallest frames; 0: there was none
  std::array<double, 15> late_{};       // latest link times, ms
  std::size_t count_ = 0;
  double changed_ = -1e9, good_since_ = -1;
  bool known_ = false;
};

}  // namespace pabd
