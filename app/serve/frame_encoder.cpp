// SPDX-License-Identifier: MIT
// See frame_encoder.h.
#include "app/serve/frame_encoder.h"

#include <turbojpeg.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "render/output/png.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr int kFineColour = 90;

Image cut(const Image& image, const PixelRect& rect) {
  Image out;
  out.resize(rect.w, rect.h);
  const std::size_t row = static_cast<std::size_t>(rect.w) * 3;
  for (int y = 0; y < rect.h; ++y) {
    const std::size_t from = (static_cast<std::size_t>(rect.y + y) * static_cast<std::size_t>(image.width) +
                              static_cast<std::size_t>(rect.x)) *
                             3;
    std::copy_n(&image.rgb[from], row, &out.rgb[static_cast<std::size_t>(y) * row]);
  }
  return out;
}

struct JpegBytes {
  unsigned char* data = nullptr;
  unsigned long size = 0;
  ~JpegBytes() { tjFree(data); }
};

// Of one message.
struct Payload {
  std::string bytes;
  std::uint8_t flags = 0;
};

// A message for each rectangle.
EncodedFrame packed(const Image& image, const std::vector<PixelRect>& rects,
                    const std::vector<Payload>& payloads, FrameHead head, double ms) {
  head.width = static_cast<std::uint16_t>(image.width);
  head.height = static_cast<std::uint16_t>(image.height);
  head.encode_us = static_cast<std::uint32_t>(std::lround(1000 * ms));
  EncodedFrame out;
  const std::uint8_t flags = head.flags;
  for (std::size_t i = 0; i < rects.size(); ++i) {
    head.left = static_cast<std::uint16_t>(rects.size() - 1 - i);
    head.flags =
        static_cast<std::uint8_t>(flags | payloads[i].flags | (head.left == 0 ? FrameHead::kLast : 0));
    head.x = static_cast<std::uint16_t>(rects[i].x);
    head.y = static_cast<std::uint16_t>(rects[i].y);
    head.w = static_cast<std::uint16_t>(rects[i].w);
    head.h = static_cast<std::uint16_t>(rects[i].h);
    out.parts.push_back(std::make_shared<const std::string>(to_bytes(head) + payloads[i].bytes));
    out.bytes += out.parts.back()->size();
  }
  return out;
}

}  // namespace

FrameEncoder::FrameEncoder() : handle_(tjInitCompress()) {
  if (!handle_) throw Error(ErrorKind::encoder, std::string("libjpeg-turbo: ") + tjGetErrorStr());
}

FrameEncoder::~FrameEncoder() { tjDestroy(handle_); }

template <class Encode>
EncodedFrame FrameEncoder::encode(const Image& image, const std::vector<PixelRect>& rects, FrameHead head,
                                  const Encode& append) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  std::vector<Payload> payloads;
  for (const PixelRect& rect : rects) append(rect, payloads.emplace_back().bytes);
  last_ms_ = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
  return packed(image, rects, payloads, head, last_ms_);
}

EncodedFrame FrameEncoder::jpeg(const Image& image, const std::vector<PixelRect>& rects, int quality,
                                FrameHead head) {
  head.kind = FrameHead::jpeg;
  const int pitch = image.width * 3;
  return encode(image, rects, head, [&](const PixelRect& rect, std::string& bytes) {
    JpegBytes jpeg;
    const std::size_t at = static_cast<std::size_t>(rect.y) * static_cast<std::size_t>(pitch) +
                           3 * static_cast<std::size_t>(rect.x);
    if (tjCompress2(handle_, &image.rgb[at], rect.w, pitch, rect.h, TJPF_RGB, &jpeg.data, &jpeg.size,
                    quality >= kFineColour ? TJSAMP_444 : TJSAMP_420, quality, 0) != 0)
      throw Error(ErrorKind::encoder, std::string("libjpeg-turbo: ") + tjGetErrorStr2(handle_));
    bytes.assign(reinterpret_cast<const char*>(jpeg.data), jpeg.size);
  });
}

EncodedFrame FrameEncoder::png(const Image& image, const std::vector<PixelRect>& rects, FrameHead head) {
  head.kind = FrameHead::png;
  head.flags |= FrameHead::kLossless;
  return encode(image, rects, head, [&](const PixelRect& rect, std::string& bytes) {
    const std::vector<std::uint8_t> png = encode_png(cut(image, rect));
    bytes.assign(png.begin(), png.end());
  });
}

EncodedFrame FrameEncoder::h264(const Image& image, const std::vector<VideoUnit>& units,
                                const std::vector<PixelRect>& rects, FrameHead head, double ms) {
  last_ms_ = ms;
  head.kind = FrameHead::h264;
  std::vector<PixelRect> places(units.size() - 1, rects.front());  // drawn over by what follows
  places.insert(places.end(), rects.begin(), rects.end());
  std::vector<Payload> payloads(places.size());
  for (std::size_t i = 0; i < units.size(); ++i)
    payloads[i] = {units[i].bytes, units[i].key ? FrameHead::kKey : std::uint8_t{0}};
  return packed(image, places, payloads, head, ms);
}

}  // namespace pabd
