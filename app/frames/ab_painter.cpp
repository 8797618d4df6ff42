// SPDX-License-Identifier: MIT
// Two runs in one picture.
#include "app/frames/ab_painter.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/frames/scene_framing.h"
#include "app/overlay/parameter_words.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr int kSeam = 2;                 // px between the halves, white
constexpr std::size_t kMostDetails = 6;  // lines of a caption

std::vector<std::string> details_of(const FrameView& a, const FrameView& b) {
  std::vector<std::string> lines = difference_words(a.params, a.kappa, b.params, b.kappa);
  if (lines.empty()) lines.emplace_back("the same parameters");
  if (lines.size() > kMostDetails) {
    const std::size_t more = lines.size() - (kMostDetails - 1);
    lines.resize(kMostDetails - 1);
    lines.push_back(fmt::format("and {} more", more));
  }
  return lines;
}

void paste(const Image& from, int left, Image& to) {
  const auto row = static_cast<std::ptrdiff_t>(3 * from.width);
  for (int y = 0; y < from.height; ++y) {
    std::copy_n(from.rgb.begin() + y * row, row,
                to.rgb.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * to.width + left));
  }
}

}  // namespace

AbView parse_ab_view(const std::string& text) {
  if (text == "side") return AbView::side;
  if (text == "ghost") return AbView::ghost;
  throw Error(ErrorKind::bad_input, fmt::format("--ab-view {}: expected side or ghost", text));
}

AbPainter::AbPainter(GlContext& context, const std::shared_ptr<const Scene>& scene, const Frame& first,
                     AbView view, int width, int height, const OverlayChoice& overlay,
                     const CameraOption& camera, double seconds) {
  const bool framing = camera.frames() && camera.follow.empty();
  std::vector<Spot> spots = spots_ahead(scene, first.a, framing ? seconds : 0);
  if (first.b) {
    const std::vector<Spot> of_b = spots_ahead(scene, *first.b, framing ? seconds : 0);
    spots.insert(spots.end(), of_b.begin(), of_b.end());
  }
  const auto painter = [&](const FrameView& of, int w, const Comparison& comparison) {
    return std::make_unique<FramePainter>(context, scene, of, spots, w, height, overlay, camera, comparison);
  };
  if (!first.b) {
    left_ = painter(first.a, width, {});
    return;
  }
  const std::vector<std::string> details = details_of(first.a, *first.b);
  if (view == AbView::ghost) {
    left_ = painter(first.a, width, {"A, and B as a ghost", details, true, 0});
    return;
  }
  const int half = (width - kSeam) / 2;
  left_ = painter(first.a, half, {first.a.label, {"as it is"}, false, details.size()});
  right_ = painter(*first.b, width - kSeam - half, {first.b->label, details, false, 0});
}

void AbPainter::draw(const Frame& frame) {
  const double time = frame.a.state.time;
  const FrameView* b = frame.b ? &*frame.b : nullptr;
  left_->draw(frame.a, b, frame.apart, time);
  if (right_) right_->draw(*b, &frame.a, frame.apart, time);
}

void AbPainter::fetch(Image& out) {
  if (!right_) {
    left_->fetch(out);
    return;
  }
  left_->fetch(left_half_);
  right_->fetch(right_half_);
  out.resize(left_half_.width + kSeam + right_half_.width, left_half_.height);
  std::fill(out.rgb.begin(), out.rgb.end(), std::uint8_t{255});
  paste(left_half_, 0, out);
  paste(right_half_, left_half_.width + kSeam, out);
}

}  // namespace pabd
