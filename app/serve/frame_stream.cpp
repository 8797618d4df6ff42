// SPDX-License-Identifier: MIT
// See frame_stream.h.
#include "app/serve/frame_stream.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace pabd {
namespace {

constexpr int kSharp = 85;  // quality of what is beside the picture

FrameLook sharp(const FrameLook& look) { return {1, std::max(kSharp, look.quality)}; }

PixelRect common(const PixelRect& a, const PixelRect& b) {
  const int x = std::max(a.x, b.x), y = std::max(a.y, b.y);
  return {x, y, std::max(0, std::min(a.x + a.w, b.x + b.w) - x),
          std::max(0, std::min(a.y + a.h, b.y + b.h) - y)};
}

// What of `rect` is not in `hole`, which is in it or empty.
std::vector<PixelRect> without(const PixelRect& rect, const PixelRect& hole) {
  if (hole.area() == 0) return {rect};
  const int right = hole.x + hole.w, bottom = hole.y + hole.h;
  std::vector<PixelRect> out{{rect.x, rect.y, rect.w, hole.y - rect.y},
                             {rect.x, hole.y, hole.x - rect.x, hole.h},
                             {right, hole.y, rect.x + rect.w - right, hole.h},
                             {rect.x, bottom, rect.w, rect.y + rect.h - bottom}};
  std::erase_if(out, [](const PixelRect& part) { return part.area() == 0; });
  return out;
}

void copy(const Image& from, const PixelRect& rect, Image& to) {
  for (int y = rect.y; y < rect.y + rect.h; ++y) {
    const std::size_t at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(from.width) +
                                static_cast<std::size_t>(rect.x));
    std::copy_n(&from.rgb[at], 3 * static_cast<std::size_t>(rect.w), &to.rgb[at]);
  }
}

}  // namespace

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

bool FrameStream::show(Image image, std::uint32_t stamp, double draw_ms, double now,
                       const PixelRect& picture) {
  draw_ms_ = draw_ms;
  stamp_ = stamp;
  const bool same = image.width == image_.width && image.height == image_.height && image.rgb == image_.rgb;
  if (same) return false;
  image_ = std::move(image);
  const PixelRect all{0, 0, image_.width, image_.height};
  picture_ = picture.area() > 0 ? common(picture, all) : all;
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

// As they are encoded now: in `picture` as the link allows, beside it so that text stays sharp.
std::vector<JpegPart> FrameStream::parts_of(const std::vector<PixelRect>& rects) const {
  std::vector<JpegPart> out;
  for (const PixelRect& rect : rects) {
    const PixelRect in = common(rect, picture_);
    if (in.area() > 0) out.push_back({in, sent_look_});
    for (const PixelRect& beside : without(rect, in)) out.push_back({beside, sharp(sent_look_)});
  }
  return out;
}

// Prepares the newest frame: the rectangles that differ from the last one sent. On a slow link what is beside the
// picture comes less often.
void FrameStream::begin_moving(double now) {
  sent_look_ = adaptation_.look();
  const bool same_size = image_.width == sent_.width && image_.height == sent_.height;
  base_ = same_size ? sent_number_ : 0;
  rects_ = same_size ? Tiles::changed(sent_, image_).cover() : std::vector<PixelRect>{};
  // What changed and changed back.
  if (rects_.empty()) rects_ = {{0, 0, image_.width, image_.height}};
  parts_ = parts_of(rects_);
  const auto beside = [this](const JpegPart& part) { return common(part.rect, picture_).area() == 0; };
  const bool waits = same_size && sent_look_.scale < 1 && now - beside_sent_ < kBeside;
  const auto first = std::stable_partition(parts_.begin(), parts_.end(), std::not_fn(beside));
  if (waits && first != parts_.begin()) {
    parts_.erase(first, parts_.end());
    for (const JpegPart& part : parts_) copy(image_, part.rect, sent_);
  } else {
    if (first != parts_.end()) beside_sent_ = now;
    sent_ = image_;
  }
  sent_number_ = number_;
  part_.reset();
  whole_.reset();
}

void FrameStream::send_moving(VisitorId id, Visitor& visitor, double now) {
  if (sent_number_ != number_) begin_moving(now);
  const bool has_base = base_ != 0 && visitor.frame == base_ && !visitor.stale;
  std::optional<EncodedFrame>& frame = has_base ? part_ : whole_;
  if (!frame)
    frame =
        encoder_.jpeg(image_, has_base ? parts_ : parts_of({{0, 0, image_.width, image_.height}}), head());
  if (!visitor.lossy.fits(image_.width, image_.height)) visitor.lossy = Tiles(image_.width, image_.height);
  if (!has_base) {
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
