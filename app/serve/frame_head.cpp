// SPDX-License-Identifier: MIT
// See frame_head.h.
#include "app/serve/frame_head.h"

#include <type_traits>

namespace pabd {
namespace {

// The members in the order of the bytes; `f` gets each.
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

}  // namespace pabd
