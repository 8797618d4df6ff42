// SPDX-License-Identifier: MIT
// See frame_painter.h.
#include "app/frames/frame_painter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/overlay/overlay_panels.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

// Moves the camera so that its target appears in the middle of `free` (px, in a frame of width × height), and
// as far away as that rectangle is smaller than the frame.
Camera make_room(const Camera& camera, const Rect& free, int width, int height) {
  const double share = std::min(free.w / width, free.h / height);
  if (!(share > 0.2)) return camera;
  Camera moved = camera;
  const Vec3f offset = (camera.eye - camera.target) * static_cast<float>(std::pow(share, -0.65));
  const Mat4f view = view_matrix(camera);
  const Vec3f right = view.row(0).head<3>();
  const Vec3f up = view.row(1).head<3>();
  // Half the height of the frame at the target's distance, in metres.
  const auto half = static_cast<float>(offset.norm() * std::tan(camera.fov * kPi / 360));
  const auto x = static_cast<float>((2 * (free.x + free.w / 2) - width) / height);
  const auto y = static_cast<float>(1 - 2 * (free.y + free.h / 2) / height);
  const Vec3f shift = -half * (x * right + y * up);
  moved.target = camera.target + shift;
  moved.eye = moved.target + offset;
  return moved;
}

Camera choose_base_camera(const Scene& scene, const FrameView& first, double aspect) {
  if (!scene.camera) return frame_camera(*first.model, first.state, aspect);
  const CameraDesc& desc = *scene.camera;
  Camera camera;
  camera.eye = desc.eye.cast<float>();
  camera.target = desc.target.cast<float>();
  camera.fov = static_cast<float>(desc.fov);
  return camera;
}

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
                           int width, int height, const OverlayChoice& overlay, const CameraOption& camera,
                           const Comparison& comparison)
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
  set_camera(first, std::max(comparison.lines, comparison.details.size()), comparison.back);
}

// So that panels, and a caption of so many lines, leave the bodies to be seen.
void FramePainter::set_camera(const FrameView& first, std::size_t caption_lines, float back) {
  base_camera_ = choose_base_camera(*scene_, first, static_cast<double>(width_) / height_);
  if (camera_option_.eye || camera_option_.target || !camera_option_.keys.empty()) return;
  if (back != 1 && scene_->camera) base_camera_.eye += (back - 1) * (base_camera_.eye - base_camera_.target);
  const PanelLayout layout = layout_panels(choice_.panels, data_, width_, height_);
  if (layout.panels.empty() && caption_lines == 0) return;
  Rect free = layout.free;
  if (caption_lines > 0) {
    const double caption = std::min(caption_height(layout.scale, caption_lines), 0.5 * free.h);
    free.y += caption;
    free.h -= caption;
  }
  base_camera_ = make_room(base_camera_, free, width_, height_);
}

void FramePainter::draw(const FrameView& view, const FrameView* other, std::span<const DistancePoint> apart,
                        double time) {
  VisualOptions options;
  options.bonds = choice_.bonds;
  options.contacts = choice_.contacts;
  options.d_hat = view.params.contact.d_hat;
  visual_.camera =
      apply_camera(camera_option_, base_camera_, camera_option_.keys.empty() ? time - start_time_ : time);
  build_visual(*view.model, view.state, view.report, options, visual_);
  if (other && ghost_) add_ghost(*view.model, other->state, ghost_color(), visual_);
  data_.view = &view;
  data_.other = other;
  data_.distances = apart;
  renderer_.draw(visual_, overlay_.frame(choice_.panels, data_, &visual_, width_, height_));
  renderer_.queue_read();
}

void FramePainter::fetch(Image& out) { renderer_.fetch(out); }

}  // namespace pabd
