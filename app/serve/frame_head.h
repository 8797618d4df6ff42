// SPDX-License-Identifier: MIT
// The 32 bytes before every rectangle of a frame.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace pabd {

struct FrameHead {
  enum Kind : std::uint8_t { jpeg = 1, png = 2 };
  static constexpr std::uint8_t kLast = 1, kLossless = 2;  // flags
  static constexpr std::size_t kBytes = 32;

  std::uint8_t kind = jpeg, flags = 0;
  std::uint16_t left = 0;  // rectangles of this frame that follow
  std::uint32_t frame = 0;
  std::uint16_t x = 0, y = 0, w = 0, h = 0;  // of the rectangle, pixels
  std::uint16_t width = 0, height = 0;       // of the whole frame
  std::uint32_t stamp = 0;                   // newest input that it shows
  std::uint32_t draw_us = 0, encode_us = 0;  // microseconds
  bool operator==(const FrameHead&) const = default;
};

std::string to_bytes(const FrameHead& head);  // little endian
// Precondition: kBytes at least.
FrameHead read_frame_head(std::string_view bytes);

}  // namespace pabd
