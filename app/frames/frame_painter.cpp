// SPDX-License-Identifier: MIT
// See frame_painter.h.
#include "app/frames/frame_painter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/frames/linear_light.h"
#include "app/frames/scene_framing.h"
#include "app/overlay/overlay_panels.h"
#include "render/visual/body_marks.h"
#include "render/visual/body_parts.h"
#include "render/visual/bounds.h"
#include "render/visual/force_chains.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

std::string mark_names() {
  std::string out;
  for (const PictureMark& mark : picture_marks()) out += (out.empty() ? "" : ", ") + std::string(mark.name);
  return out;
}

// With the numbers of the picture for their names in braces.
std::string with_numbers(std::string text, const State& state) {
  const auto put = [&](std::string_view name, const std::string& value) {
    for (auto at = text.find(name); at != text.npos; at = text.find(name, at + value.size()))
      text.replace(at, name.size(), value);
  };
  put("{time}", fmt::format("{:.3f} s", state.time));
  put("{step}", fmt::format("{}", state.step));
  return text;
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
    const auto marks = picture_marks();
    const auto mark =
        std::find_if(marks.begin(), marks.end(), [&](const PictureMark& m) { return m.name == word; });
    if (mark != marks.end()) choice.marks.*(mark->on) = true;
    if (!enable_panel(choice.panels, word) && !bonds && !contacts && mark == marks.end()) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("--overlay {}: '{}' is unknown; expected none, all, bonds, contacts, {}, {}",
                              text, word, mark_names(), panel_names()));
    }
  }
  return choice;
}

void OverlayChoice::color_by(ColorQuantity quantity) {
  color = quantity;
  if (quantity != ColorQuantity::body) panels.show_with(PictureLayer::body_colors);
}

void OverlayChoice::show_contacts_by(ContactQuantity quantity) {
  contacts_by = quantity;
  if (quantity == ContactQuantity::gap) return;
  contacts = true;
  panels.show_with(PictureLayer::contacts);
}

std::string overlay_help() {
  std::string out =
      panel_help() +
      "; contacts, bonds with the joints: in the picture, with their legends; all; none; and not in all";
  for (const PictureMark& mark : picture_marks()) out += fmt::format(", {} ({})", mark.name, mark.help);
  return out;
}

const PictureTheme& find_theme(const std::string& name) {
  for (const PictureTheme* theme : picture_themes()) {
    if (name == theme->name) return *theme;
  }
  throw Error(ErrorKind::bad_input, fmt::format("theme '{}': expected one of {}", name, theme_help()));
}

std::string theme_help() {
  std::string out;
  for (const PictureTheme* theme : picture_themes())
    out += fmt::format("{}{} ({})", out.empty() ? "" : ", ", theme->name, theme->help);
  return out;
}

FramePainter::FramePainter(GlContext& context, std::shared_ptr<const Scene> scene, const Frame& first,
                           std::size_t run, const Outlook& outlook, int width, int height,
                           const OverlayChoice& overlay, const CameraOption& camera, double seconds,
                           const Comparison& comparison)
    : scene_(std::move(scene)),
      run_(run),
      width_(width),
      height_(height),
      renderer_(context, width, height),
      overlay_([this](const unsigned char* rgba, int w, int h) {
        return renderer_.upload_font_atlas(rgba, w, h);
      }),
      choice_(overlay),
      camera_option_(camera),
      far_(outlook.far),
      start_time_(first.runs[run].state->time),
      ghost_(comparison.ghost),
      caption_(comparison.caption) {
  data_.scene_name = scene_->name;
  data_.axes = choice_.marks.axes;
  data_.scale = choice_.marks.scale;
  data_.joint_law = &scene_->joint_law;
  data_.caption = caption_;
  data_.details = comparison.details;
  const bool below = !caption_.empty() && !choice_.caption.empty();  // a line below the comparison's
  if (below) data_.details.emplace_back();
  data_.view = &first.runs[run];
  data_.from = start_time_;
  data_.to = start_time_ + seconds;
  data_.colors = &colors_;
  data_.contacts_by = choice_.contacts_by;
  // Where the bodies are on a GPU nothing is known of them.
  if (!first.runs[run].poses) at_start_ = bodies_in_picture(*first.runs[run].model, *first.runs[run].state);
  look_at(first);  // for the legend's place
  std::optional<std::size_t> caption;
  if (!caption_.empty() || !choice_.caption.empty())
    caption = std::max(comparison.lines, comparison.details.size()) + (below ? 1 : 0);
  set_camera(first.runs[run], outlook, caption);
  colors_.largest = 0;  // a still shows another moment
}

void FramePainter::set_camera(const FrameView& first, const Outlook& outlook,
                              std::optional<std::size_t> caption) {
  followed_ = followed_body(camera_option_, *first.model);
  if (followed_) follow_from_ = first.state->c[static_cast<std::size_t>(*followed_)];
  const PicturePart part =
      free_part(layout_panels(choice_.panels, data_, width_, height_), caption, width_, height_);
  const double aspect = static_cast<double>(width_) / height_;
  base_camera_ = frame_view(camera_option_, side_of(*scene_), outlook, aspect, part);
  if (!followed_) return;
  const double radius = bounding_radius(first.model->shape[static_cast<std::size_t>(*followed_)]);
  const Camera all = base_camera_.at(first.state->time);
  base_camera_ = EasedCamera(come_near(camera_option_, all, {follow_from_, radius}, aspect, part));
}

void FramePainter::look_at(const Frame& frame) {
  double largest = colors_.largest;
  for (const FrameView& run : frame.runs) largest = std::max(largest, largest_value(run, choice_.color));
  colors_ = body_colors(frame.runs[run_], choice_.color, largest);
  if (choice_.contacts_by != ContactQuantity::force) return;
  for (const FrameView& run : frame.runs)
    largest_force_ = std::max(largest_force_, largest_force(*run.model, run.report));
  data_.force_range = force_range(largest_force_);
}

void FramePainter::draw(const Frame& frame, const BodiesOnDevice* on_device) {
  const FrameView& view = frame.runs[run_];
  const FrameView* other = frame.beside(run_);
  double time = 0;  // of the camera: a run of a grid may have ended
  for (const FrameView& run : frame.runs) time = std::max(time, run.state->time);
  VisualOptions options;
  options.bonds = choice_.bonds;
  options.contacts = choice_.contacts;
  options.d_hat = view.params.contact.d_hat;
  options.velocities = choice_.marks.velocities;
  options.boxes = choice_.marks.boxes;
  options.looks = looks_of(*scene_, *view.model);
  look_at(frame);
  options.contacts_by = choice_.contacts_by;
  options.force_range = data_.force_range;
  options.values = colors_.values;
  options.value_range = colors_.range;
  Vec3 way = Vec3::Zero();
  if (followed_ && *followed_ < view.state->size() && has_finite_pose(*view.state, *followed_))
    way = view.state->c[static_cast<std::size_t>(*followed_)] - follow_from_;
  visual_.camera = apply_camera(camera_option_, base_camera_.at(time),
                                camera_option_.keys.empty() ? time - start_time_ : time, way);
  if (on_device) {
    show_on_device(*view.model, on_device->around, visual_);
  } else {
    build_visual(*view.model, *view.state, view.report, options, visual_);
    set_extent(view);
  }
  if (other && ghost_) add_ghost(*view.model, *other->state, ghost_color(), visual_);
  for (std::size_t k = 0; k < view.trails.size(); ++k)
    add_trail(view.trails[k].path, trail_color(k), visual_);
  data_.view = &view;
  data_.to = std::max(data_.to, view.state->time);
  if (!choice_.caption.empty())
    (caption_.empty() ? data_.caption : data_.details.back()) = with_numbers(choice_.caption, *view.state);
  if (!caption_.empty() && view.report.status == StepStatus::non_finite)
    data_.caption = caption_ + ", diverged";
  data_.other = other;
  data_.distances = frame.apart;
  data_.span = &frame.span;
  const auto draw_on = [&](const PictureTheme& theme) {
    visual_.theme = data_.theme = &theme;
    renderer_.draw(visual_, overlay_.frame(choice_.panels, data_, &visual_, width_, height_), quality_,
                   on_device ? on_device->bodies : nullptr);
    renderer_.queue_read();
  };
  if (!choice_.theme->transparent) return draw_on(*choice_.theme);
  visual_.grounds.clear();
  Image black, white;
  draw_on(kOnBlackTheme);
  renderer_.fetch(black);
  draw_on(kOnWhiteTheme);
  renderer_.fetch(white);
  mattes_.push_back(matte(black, white));
}

// What is far away takes no part in the light, nor in how wide the floor's grid is. What a camera that stands still shows of
// the surroundings at the start does so to the end.
void FramePainter::set_extent(const FrameView& view) {
  std::vector<std::uint8_t> in = bodies_in_picture(*view.model, *view.state);
  // Of bodies that were added nothing is known.
  const auto marked = [&](const std::vector<std::uint8_t>& of, std::size_t i) {
    return of.size() == in.size() && of[i];
  };
  for (std::size_t i = 0; i < in.size(); ++i) {
    if (view.model->fixed[i] && base_camera_.is_still() && marked(at_start_, i)) in[i] = 1;
    if (marked(far_, i)) in[i] = 0;
  }
  if (const auto around = bounding_sphere(*view.model, *view.state, in)) set_sphere(*around, visual_);
}

void FramePainter::fetch(Image& out) {
  if (mattes_.empty()) {
    renderer_.fetch(out);
    return;
  }
  out = std::move(mattes_.front());
  mattes_.pop_front();
}

}  // namespace pabd
