// SPDX-License-Identifier: MIT
// How well moving frames are drawn and encoded, so that encoding and link bear 25 of them a second.
#pragma once

#include <array>
#include <cstddef>

namespace pabd {

struct FrameLook {
  double scale = 1;  // of the sides
  int quality = 85;  // of JPEG
  bool operator==(const FrameLook&) const = default;
};

class Adaptation {
 public:
  enum class Mode { automatic, fast, fine };
  static constexpr double kFrameMs = 40;  // that a frame may take: 25 a second

  void choose(Mode mode);

  // A frame of so many bytes was acknowledged: what encoding took, and the way there and back without the
  // page's own time; at `now`, in seconds.
  void took(double encode_ms, double link_ms, std::size_t bytes, double now);

  FrameLook look() const;
  double link_ms() const { return link_ms_; }
  double encode_ms() const { return encode_ms_; }

 private:
  Mode mode_ = Mode::automatic;
  std::size_t level_ = 0;
  // What the size of frames costs on the way: the middle one of late, without what the smallest ones take, too.
  double transfer_ms() const;

  double encode_ms_ = 0, link_ms_ = 0;  // smoothed
  double empty_ms_ = 0;                 // that frames of next to nothing took; 0: there was none
  std::array<double, 15> late_{};       // links, ms
  std::size_t count_ = 0;
  double changed_ = -1e9, good_since_ = -1;
  bool known_ = false;
};

}  // namespace pabd
