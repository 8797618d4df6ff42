// SPDX-License-Identifier: MIT
// Rectangles of a frame as binary messages: head and JPEG or PNG.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/serve/frame_head.h"
#include "app/serve/tiles.h"

namespace pabd {

// A message that several visitors get.
using SharedBytes = std::shared_ptr<const std::string>;

struct EncodedFrame {
  std::vector<SharedBytes> parts;
  std::size_t bytes = 0;
};

class FrameEncoder {
 public:
  FrameEncoder();
  ~FrameEncoder();
  FrameEncoder(const FrameEncoder&) = delete;
  FrameEncoder& operator=(const FrameEncoder&) = delete;

  // `head` says which frame it is, and what it shows; its kind, places and times are filled in. `quality` of
  // JPEG, 1 … 100; from 90 on colours have the resolution of brightness. Throws Error(encoder).
  EncodedFrame jpeg(const Image& image, const std::vector<PixelRect>& rects, int quality, FrameHead head);
  EncodedFrame png(const Image& image, const std::vector<PixelRect>& rects, FrameHead head);

  double last_ms() const { return last_ms_; }  // that the last frame took

 private:
  template <class Encode>
  EncodedFrame encode(const Image& image, const std::vector<PixelRect>& rects, FrameHead head,
                      const Encode& encode);

  void* handle_;  // of libjpeg-turbo
  double last_ms_ = 0;
};

}  // namespace pabd
