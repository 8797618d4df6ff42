// SPDX-License-Identifier: MIT
// Rectangles of a frame as binary messages: head and JPEG or PNG.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/serve/adaptation.h"
#include "app/serve/tiles.h"

namespace pabd {

// The 32 bytes before every rectangle of a frame.
struct FrameHead {
  enum Kind : std::uint8_t { jpeg = 1, png = 2 };
  static constexpr std::uint8_t kLast = 1, kLossless = 2;  // flags
  static constexpr std::size_t kBytes = 32;

  std::uint8_t kind = jpeg, flags = 0;
  std::uint16_t left = 0;  // rectangles of this frame that follow
  std::uint32_t frame = 0;
  std::uint16_t x = 0, y = 0, w = 0, h = 0;  // of the rectangle, pixels
  std::uint16_t width = 0, height = 0;       // of the whole frame
  std::uint32_t stamp = 0;                   // of the newest input that the frame shows
  std::uint32_t draw_us = 0, encode_us = 0;  // microseconds
  bool operator==(const FrameHead&) const = default;
};

std::string to_bytes(const FrameHead& head);  // little endian
// Precondition: at least kBytes.
FrameHead read_frame_head(std::string_view bytes);

// A message that is sent to several visitors.
using SharedBytes = std::shared_ptr<const std::string>;

struct EncodedFrame {
  std::vector<SharedBytes> parts;
  std::size_t bytes = 0;
};

// A rectangle as a JPEG, of fewer pixels where `look` is reduced.
struct JpegPart {
  PixelRect rect;
  FrameLook look;
};

class FrameEncoder {
 public:
  FrameEncoder();
  ~FrameEncoder();
  FrameEncoder(const FrameEncoder&) = delete;
  FrameEncoder& operator=(const FrameEncoder&) = delete;

  // One message per rectangle. `head` gives frame, stamp and drawing time; the rest is filled in. Quality: 1 … 100;
  // from 90 on without chroma subsampling. Throws Error(encoder).
  EncodedFrame jpeg(const Image& image, const std::vector<JpegPart>& parts, FrameHead head);
  EncodedFrame png(const Image& image, const std::vector<PixelRect>& rects, FrameHead head);

  double last_ms() const { return last_ms_; }  // time of the last frame

 private:
  template <class Part, class Encode>
  EncodedFrame encode(const Image& image, const std::vector<Part>& parts, FrameHead head,
                      const Encode& encode);

  void* handle_;  // of libjpeg-turbo
  double last_ms_ = 0;
};

}  // namespace pabd
