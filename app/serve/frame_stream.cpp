// SPDX-License-Identifier: MIT
// See frame_stream.h.
#include "app/serve/frame_stream.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pabd {

void FrameStream::refresh(VisitorId visitor) {
  const auto found = visitors_.find(visitor);
  if (found != visitors_.end()) found->second.stale = true;
}

VisitorId FrameStream::leader() const {
  if (leader_ && visitors_.contains(*leader_)) return *leader_;
  return visitors_.empty() ? 0 : visitors_.begin()->first;
}

void FrameStream::acknowledge(VisitorId id, std::uint32_t frame, double shown_ms, double now) {
  const auto found = visitors_.find(id);
  if (found == visitors_.end() || found->second.ready || found->second.frame != frame) return;
  found->second.ready = true;
  if (id != leader()) return;
  adaptation_.took(encoder_.last_ms(), std::max(0.0, 1000 * (now - found->second.sent) - shown_ms),
                   found->second.bytes, now);
}

bool FrameStream::show(Image image, std::uint32_t stamp, double draw_ms, double now) {
  draw_ms_ = draw_ms;
  stamp_ = stamp;
  const bool same = image.width == image_.width && image.height == image_.height && image.rgb == image_.rgb;
  if (same) return false;
  image_ = std::move(image);
  if (++number_ == 0) number_ = 1;
  changed_ = now;
  return true;
}

bool FrameStream::wants_frame() const {
  return std::any_of(visitors_.begin(), visitors_.end(),
                     [&](const auto& v) { return v.second.ready || v.second.frame == number_; });
}

FrameHead FrameStream::head() const {
  FrameHead out;
  out.frame = number_;
  out.stamp = stamp_;
  out.draw_us = static_cast<std::uint32_t>(std::lround(1000 * std::clamp(draw_ms_, 0.0, 4e6)));
  return out;
}

// Prepares the newest frame: reduced if necessary, with the rectangles that differ from the last one sent.
void FrameStream::begin_moving() {
  sent_look_ = adaptation_.look();
  Image next = sent_look_.scale < 1 ? reduced(image_, sent_look_.scale) : image_;
  const bool same_size = next.width == sent_.width && next.height == sent_.height;
  base_ = same_size ? sent_number_ : 0;
  rects_ = same_size ? Tiles::changed(sent_, next).cover() : std::vector<PixelRect>{};
  // A reduced picture may be the same although the window is not.
  if (rects_.empty()) rects_ = {{0, 0, next.width, next.height}};
  sent_ = std::move(next);
  sent_number_ = number_;
  part_.reset();
  whole_.reset();
}

void FrameStream::send_moving(VisitorId id, Visitor& visitor, double now) {
  if (sent_number_ != number_) begin_moving();
  const bool has_base = base_ != 0 && visitor.frame == base_ && !visitor.stale;
  const std::vector<PixelRect> all{{0, 0, sent_.width, sent_.height}};
  const std::vector<PixelRect>& rects = has_base ? rects_ : all;
  std::optional<EncodedFrame>& frame = has_base ? part_ : whole_;
  if (!frame) frame = encoder_.jpeg(sent_, rects, sent_look_.quality, head());
  const bool reduced_size = sent_.width != image_.width || sent_.height != image_.height;
  if (!visitor.lossy.fits(image_.width, image_.height)) visitor.lossy = Tiles(image_.width, image_.height);
  if (!has_base || reduced_size) {
    visitor.lossy.mark_all();
  } else {
    for (const PixelRect& rect : rects_) visitor.lossy.mark(rect);
  }
  send(id, visitor, *frame, now);
}

void FrameStream::send_lossless(VisitorId id, Visitor& visitor, double now) {
  const std::vector<PixelRect> rects = visitor.lossy.first(kLosslessTiles).cover(false);
  const EncodedFrame frame = encoder_.png(image_, rects, head());
  for (const PixelRect& rect : rects) visitor.lossy.clear(rect);
  send(id, visitor, frame, now);
}

void FrameStream::send(VisitorId id, Visitor& visitor, const EncodedFrame& frame, double now) {
  visitor.ready = visitor.stale = false;
  visitor.frame = number_;
  visitor.bytes = frame.bytes;
  visitor.sent = now + encoder_.last_ms() / 1000;
  if (id == leader()) {
    ++frames_;
    bytes_ += frame.bytes;
  }
  send_(id, frame);
}

void FrameStream::deliver(double now) {
  if (number_ == 0) return;
  for (auto& [id, visitor] : visitors_) {
    if (!visitor.ready) continue;
    if (visitor.frame != number_ || visitor.stale) {
      send_moving(id, visitor, now);
    } else if (now - changed_ >= kStill && visitor.lossy.any()) {
      send_lossless(id, visitor, now);
    }
  }
}

std::optional<double> FrameStream::due() const {
  std::optional<double> out;
  for (const auto& [id, visitor] : visitors_) {
    if (!visitor.ready || number_ == 0) continue;
    if (visitor.frame != number_ || visitor.stale) return changed_;
    if (visitor.lossy.any()) out = changed_ + kStill;
  }
  return out;
}

std::optional<StreamStats> FrameStream::stats(double now) {
  const double passed = now - counted_from_;
  const std::size_t frames = std::exchange(frames_, 0), bytes = std::exchange(bytes_, 0);
  counted_from_ = now;
  if (frames == 0 || !(passed > 0)) return std::nullopt;
  StreamStats out;
  out.fps = static_cast<double>(frames) / passed;
  out.kbps = 8e-3 * static_cast<double>(bytes) / passed;
  out.encode_ms = adaptation_.encode_ms();
  out.link_ms = adaptation_.link_ms();
  out.draw_ms = draw_ms_;
  out.look = sent_look_;
  return out;
}

}  // namespace pabd
