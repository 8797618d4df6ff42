// SPDX-License-Identifier: MIT
// Two runs in one picture.
#include "app/frames/ab_painter.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/frames/outlook.h"
#include "app/overlay/parameter_words.h"
#include "app/plots/axis_ticks.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr int kSeam = 2;                 // px between the halves, white
constexpr std::size_t kMostDetails = 6;  // lines of a caption

std::string law_words(const BondLaw& law) {
  const bool hard = law.potential == BondPotential::hard;
  return (hard ? fmt::format("hard, *{{N}} {}, *{{d̂}} {} m, ", law.N, format_value(law.d_hat)) : "soft, ") +
         fmt::format("*{{κ}} {} {}", format_value(law.kappa), hard ? "J" : "N/m");
}

std::vector<std::string> details_of(const FrameView& a, const FrameView& b, const BondLaw& joints_a,
                                    const BondLaw& joints_b) {
  std::vector<std::string> lines = difference_words(a.params, a.kappa, b.params, b.kappa);
  const std::string from = law_words(joints_a), to = law_words(joints_b);
  if (from != to) lines.push_back(fmt::format("joints {} → {}", from, to));
  if (lines.empty()) lines.emplace_back("the same parameters");
  if (lines.size() > kMostDetails) {
    const std::size_t more = lines.size() - (kMostDetails - 1);
    lines.resize(kMostDetails - 1);
    lines.push_back(fmt::format("and {} more", more));
  }
  return lines;
}

// `channels`: bytes a pixel.
void paste(const std::vector<std::uint8_t>& from, int width, int left, int channels,
           std::vector<std::uint8_t>& to, int to_width) {
  const auto row = static_cast<std::ptrdiff_t>(channels) * width;
  const auto rows = static_cast<std::ptrdiff_t>(from.size()) / row;
  for (std::ptrdiff_t y = 0; y < rows; ++y) {
    std::copy_n(from.begin() + y * row, row, to.begin() + channels * (y * to_width + left));
  }
}

// From the same place for all runs of a scene, whatever their parameters.
Outlook outlook_of(const std::shared_ptr<const Scene>& scene, const FrameView& first,
                   const CameraOption& camera, double seconds) {
  const bool ahead = camera.frames() && camera.follow.empty();
  FrameView start = first;
  start.params = scene->params;
  if (start.poses) {  // they are on a GPU
    start.model = {scene, &scene->model};
    start.state = {scene, &scene->initial};
  }
  return look_ahead(scene, start, ahead ? std::max(seconds, look_ahead_time(*scene)) : 0,
                    bodies_to_fit(camera, *start.model));
}

}  // namespace

AbView parse_ab_view(const std::string& text) {
  if (text == "side") return AbView::side;
  if (text == "ghost") return AbView::ghost;
  throw Error(ErrorKind::bad_input, fmt::format("--ab-view {}: expected side or ghost", text));
}

AbPainter::AbPainter(GlContext& context, const std::shared_ptr<const Scene>& scene, const Frame& first,
                     AbView view, int width, int height, const OverlayChoice& overlay,
                     const CameraOption& camera, const std::shared_ptr<const Scene>& scene_b,
                     double seconds) {
  const Outlook outlook = outlook_of(scene, first.a, camera, seconds);
  const auto painter = [&](const FrameView& of, int w, const Comparison& comparison, bool is_b = false) {
    return std::make_unique<FramePainter>(context, is_b && scene_b ? scene_b : scene, of, outlook, w, height,
                                          overlay, camera, seconds, comparison);
  };
  if (!first.b) {
    left_ = painter(first.a, width, {});
    return;
  }
  const std::vector<std::string> details =
      details_of(first.a, *first.b, scene->joint_law, (scene_b ? scene_b : scene)->joint_law);
  if (view == AbView::ghost) {
    left_ = painter(first.a, width, {"A, and B as a ghost", details, true, 0});
    return;
  }
  const int half = (width - kSeam) / 2;
  left_ = painter(first.a, half, {first.a.label, {"as it is"}, false, details.size()});
  right_ = painter(*first.b, width - kSeam - half, {first.b->label, details, false, 0}, true);
}

void AbPainter::set_quality(const RenderQuality& quality) {
  left_->set_quality(quality);
  if (right_) right_->set_quality(quality);
}

void AbPainter::draw(const Frame& frame, const BodiesOnDevice* on_device) {
  const double time = frame.a.state->time;
  const FrameView* b = frame.b ? &*frame.b : nullptr;
  left_->draw(frame.a, b, frame.apart, frame.span, time, on_device);
  if (right_) right_->draw(*b, &frame.a, frame.apart, frame.span, time);
}

void AbPainter::look_at(const Frame& frame) {
  left_->look_at(frame.a, frame.b ? &*frame.b : nullptr);
  if (right_) right_->look_at(*frame.b, &frame.a);
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
  const int right = left_half_.width + kSeam;
  paste(left_half_.rgb, left_half_.width, 0, 3, out.rgb, out.width);
  paste(right_half_.rgb, right_half_.width, right, 3, out.rgb, out.width);
  out.alpha.clear();
  if (left_half_.alpha.empty()) return;
  out.alpha.assign(out.rgb.size() / 3, 0);
  paste(left_half_.alpha, left_half_.width, 0, 1, out.alpha, out.width);
  paste(right_half_.alpha, right_half_.width, right, 1, out.alpha, out.width);
}

}  // namespace pabd
