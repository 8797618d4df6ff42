// SPDX-License-Identifier: MIT
// See frame_painter.h.
#include "app/frames/frame_painter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/frames/scene_framing.h"
#include "app/overlay/overlay_panels.h"
#include "render/visual/bounds.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr double kLeastPart = 0.15;  // of the frame's sides: less is no room for a picture
constexpr double kAround = 7;        // radii of a body that is followed: so much of what is around it is seen

}  // namespace

OverlayChoice parse_overlay(const std::string& text) {
  OverlayChoice choice;
  if (text.empty() || text == "none") return choice;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    const bool all = word == "all";
    const bool bonds = all || word == "bonds", contacts = all || word == "contacts";
    if (bonds) choice.panels.show_with(PictureLayer::bonds);
    if (contacts) choice.panels.show_with(PictureLayer::contacts);
    choice.bonds = choice.bonds || bonds;
    choice.contacts = choice.contacts || contacts;
    if (!enable_panel(choice.panels, word) && !bonds && !contacts) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("--overlay {}: '{}' is unknown; expected none, all, bonds, contacts, {}", text,
                              word, panel_names()));
    }
  }
  return choice;
}

std::string overlay_help() {
  return panel_help() + "; contacts, bonds with the joints: in the picture, with their legends; all; none";
}

FramePainter::FramePainter(GlContext& context, std::shared_ptr<const Scene> scene, const FrameView& first,
                           std::span<const Spot> spots, int width, int height, const OverlayChoice& overlay,
                           const CameraOption& camera, const Comparison& comparison)
    : scene_(std::move(scene)),
      width_(width),
      height_(height),
      renderer_(context, width, height),
      overlay_([this](const unsigned char* rgba, int w, int h) {
        return renderer_.upload_font_atlas(rgba, w, h);
      }),
      choice_(overlay),
      camera_option_(camera),
      start_time_(first.state.time),
      ghost_(comparison.ghost) {
  data_.scene_name = scene_->name;
  data_.joint_law = &scene_->joint_law;
  data_.caption = comparison.caption;
  data_.details = comparison.details;
  data_.view = &first;
  set_camera(first, spots, std::max(comparison.lines, comparison.details.size()));
}

// What panels, and a caption of so many lines, leave free.
PicturePart FramePainter::free_part(std::size_t caption_lines) const {
  const PanelLayout layout = layout_panels(choice_.panels, data_, width_, height_);
  Rect free = layout.panels.empty() ? Rect{0, 0, double(width_), double(height_)} : layout.free;
  if (caption_lines > 0) {
    const double caption = std::min(caption_height(layout.scale, caption_lines), 0.5 * free.h);
    free.y += caption;
    free.h -= caption;
  }
  if (free.w < kLeastPart * width_ || free.h < kLeastPart * height_) return {};  // behind the panels, then
  return {free.x / width_, free.y / height_, free.w / width_, free.h / height_};
}

void FramePainter::set_camera(const FrameView& first, std::span<const Spot> spots,
                              std::size_t caption_lines) {
  followed_ = followed_body(camera_option_, *first.model);
  std::vector<Spot> around;
  if (followed_) {
    const auto body = static_cast<std::size_t>(*followed_);
    follow_from_ = first.state.c[body];
    around.push_back({follow_from_, kAround * bounding_radius(first.model->shape[body])});
  }
  // Of a camera that says where it is only the rest is looked for.
  const PicturePart part = camera_option_.frames() ? free_part(caption_lines) : PicturePart{};
  const double aspect = static_cast<double>(width_) / height_;
  CameraOption side = camera_option_;
  side.eye = side.target = std::nullopt;
  const Camera like = side.keys.empty() ? apply_camera(side, side_of(*scene_), 0) : side_of(*scene_);
  const bool orbits = camera_option_.view == CameraOption::View::orbit;
  const auto fit = [&](std::span<const Spot> what) {
    return orbits ? fit_orbit(what, like, aspect, part) : fit_camera(what, like, aspect, part);
  };
  base_camera_ = fit(spots);
  if (!followed_) return;
  // A body that is nearly all there is need not have as much around it.
  const Camera close = fit(around);
  const float all = (base_camera_.eye - base_camera_.target).norm(), near = (close.eye - close.target).norm();
  base_camera_ = close;
  if (near > all) base_camera_.eye = close.target + all / near * (close.eye - close.target);
}

void FramePainter::draw(const FrameView& view, const FrameView* other, std::span<const DistancePoint> apart,
                        double time) {
  VisualOptions options;
  options.bonds = choice_.bonds;
  options.contacts = choice_.contacts;
  options.d_hat = view.params.contact.d_hat;
  Vec3 way = Vec3::Zero();
  if (followed_ && *followed_ < view.state.size() && has_finite_pose(view.state, *followed_))
    way = view.state.c[static_cast<std::size_t>(*followed_)] - follow_from_;
  visual_.camera = apply_camera(camera_option_, base_camera_,
                                camera_option_.keys.empty() ? time - start_time_ : time, way);
  build_visual(*view.model, view.state, view.report, options, visual_);
  if (other && ghost_) add_ghost(*view.model, other->state, ghost_color(), visual_);
  data_.view = &view;
  data_.other = other;
  data_.distances = apart;
  renderer_.draw(visual_, overlay_.frame(choice_.panels, data_, &visual_, width_, height_), quality_);
  renderer_.queue_read();
}

void FramePainter::fetch(Image& out) { renderer_.fetch(out); }

}  // namespace pabd
