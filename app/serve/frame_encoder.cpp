// SPDX-License-Identifier: MIT
// See frame_encoder.h.
#include "app/serve/frame_encoder.h"

#include <turbojpeg.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <type_traits>

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

const PixelRect& rect_of(const PixelRect& rect) { return rect; }
const PixelRect& rect_of(const JpegPart& part) { return part.rect; }

struct JpegBytes {
  unsigned char* data = nullptr;
  unsigned long size = 0;
  ~JpegBytes() { tjFree(data); }
};

// Calls f(member) in the order of the bytes.
void each(auto& head, auto&& f) {
  f(head.kind);
  f(head.flags);
  f(head.left);
  f(head.frame);
  f(head.x);
  f(head.y);
  f(head.w);
  f(head.h);
  f(head.width);
  f(head.height);
  f(head.stamp);
  f(head.draw_us);
  f(head.encode_us);
}

}  // namespace

std::string to_bytes(const FrameHead& head) {
  std::string out;
  out.reserve(FrameHead::kBytes);
  each(head, [&](auto value) {
    for (std::size_t i = 0; i < sizeof value; ++i) out += static_cast<char>((value >> (8 * i)) & 0xff);
  });
  return out;
}

FrameHead read_frame_head(std::string_view bytes) {
  FrameHead out;
  std::size_t at = 0;
  each(out, [&](auto& value) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < sizeof value; ++i)
      word |= std::uint32_t{static_cast<unsigned char>(bytes[at++])} << (8 * i);
    value = static_cast<std::remove_reference_t<decltype(value)>>(word);
  });
  return out;
}

FrameEncoder::FrameEncoder() : handle_(tjInitCompress()) {
  if (!handle_) throw Error(ErrorKind::encoder, std::string("libjpeg-turbo: ") + tjGetErrorStr());
}

FrameEncoder::~FrameEncoder() { tjDestroy(handle_); }

template <class Part, class Encode>
EncodedFrame FrameEncoder::encode(const Image& image, const std::vector<Part>& parts, FrameHead head,
                                  const Encode& encode) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  std::vector<std::string> payloads;
  for (const Part& part : parts) payloads.push_back(encode(part));
  last_ms_ = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
  head.width = static_cast<std::uint16_t>(image.width);
  head.height = static_cast<std::uint16_t>(image.height);
  head.encode_us = static_cast<std::uint32_t>(std::lround(1000 * last_ms_));
  EncodedFrame out;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const PixelRect& rect = rect_of(parts[i]);
    head.left = static_cast<std::uint16_t>(parts.size() - 1 - i);
    if (head.left == 0) head.flags |= FrameHead::kLast;
    head.x = static_cast<std::uint16_t>(rect.x);
    head.y = static_cast<std::uint16_t>(rect.y);
    head.w = static_cast<std::uint16_t>(rect.w);
    head.h = static_cast<std::uint16_t>(rect.h);
    out.parts.push_back(std::make_shared<const std::string>(to_bytes(head) + payloads[i]));
    out.bytes += out.parts.back()->size();
  }
  return out;
}

EncodedFrame FrameEncoder::jpeg(const Image& image, const std::vector<JpegPart>& parts, FrameHead head) {
  head.kind = FrameHead::jpeg;
  return encode(image, parts, head, [&](const JpegPart& part) {
    const PixelRect& rect = part.rect;
    Image small;
    if (part.look.scale < 1) small = reduced(cut(image, rect), part.look.scale);
    const bool whole = small.rgb.empty();
    const int pitch = 3 * (whole ? image.width : small.width);
    const std::size_t at = whole ? static_cast<std::size_t>(rect.y) * static_cast<std::size_t>(pitch) +
                                       3 * static_cast<std::size_t>(rect.x)
                                 : 0;
    const int quality = part.look.quality;
    JpegBytes jpeg;
    if (tjCompress2(handle_, &(whole ? image : small).rgb[at], whole ? rect.w : small.width, pitch,
                    whole ? rect.h : small.height, TJPF_RGB, &jpeg.data, &jpeg.size,
                    quality >= kFineColour ? TJSAMP_444 : TJSAMP_420, quality, 0) != 0)
      throw Error(ErrorKind::encoder, std::string("libjpeg-turbo: ") + tjGetErrorStr2(handle_));
    return std::string(reinterpret_cast<const char*>(jpeg.data), jpeg.size);
  });
}

EncodedFrame FrameEncoder::png(const Image& image, const std::vector<PixelRect>& rects, FrameHead head) {
  head.kind = FrameHead::png;
  head.flags |= FrameHead::kLossless;
  return encode(image, rects, head, [&](const PixelRect& rect) {
    const std::vector<std::uint8_t> png = encode_png(cut(image, rect));
    return std::string(png.begin(), png.end());
  });
}

}  // namespace pabd
