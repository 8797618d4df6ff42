// SPDX-License-Identifier: MIT
// See scene_framing.h.
#include "app/frames/scene_framing.h"

#include <algorithm>
#include <cmath>

#include "app/overlay/overlay_panels.h"
#include "render/visual/body_parts.h"
#include "render/visual/bounds.h"

namespace pabd {
namespace {

constexpr double kLeastPart = 0.15;  // of the frame's sides: less is no room for a picture
constexpr double kAround = 7;        // radii of a body that is followed: so much of what is around it is seen
// A camera stands still where that makes things no smaller than by this factor: than at the start, or than what is seen
// well, a body of this part of the frame's shorter side.
constexpr double kStill = 2, kSeenWell = 0.06;

double distance_of(const Camera& camera) { return static_cast<double>((camera.eye - camera.target).norm()); }

}  // namespace

Camera side_of(const Scene& scene) {
  if (!scene.camera) return pleasing_side();
  const CameraDesc& desc = *scene.camera;
  Camera camera;
  camera.eye = desc.eye.cast<float>();
  camera.target = desc.target.cast<float>();
  camera.fov = static_cast<float>(desc.fov);
  return camera;
}

PicturePart free_part(const PanelLayout& layout, std::optional<std::size_t> caption, int width, int height) {
  const double w = width, h = height;
  Rect free = layout.panels.empty() ? Rect{0, 0, w, h} : layout.free;
  if (caption) {
    const double high = std::min(caption_height(layout.scale, *caption), 0.5 * free.h);
    free.y += high;
    free.h -= high;
  }
  if (free.w < kLeastPart * w || free.h < kLeastPart * h) return {};
  return {free.x / w, free.y / h, free.w / w, free.h / h};
}

namespace {

Camera direction_of(const CameraOption& option, const Camera& side) {
  CameraOption view = option;
  view.eye = view.target = std::nullopt;
  return view.keys.empty() ? apply_camera(view, side, 0) : side;
}

}  // namespace

Camera frame_view(const CameraOption& option, const Camera& side, std::span<const Spot> spots, double aspect,
                  const PicturePart& part) {
  const Camera like = direction_of(option, side);
  // A camera that says where it is says what is in the middle of the frame.
  const PicturePart where = option.frames() ? part : PicturePart{};
  return option.view == CameraOption::View::orbit ? fit_orbit(spots, like, aspect, where)
                                                  : fit_camera(spots, like, aspect, where);
}

EasedCamera frame_view(const CameraOption& option, const Camera& side, const Outlook& outlook, double aspect,
                       const PicturePart& part) {
  const bool turns = option.view == CameraOption::View::orbit;
  if (turns || !option.frames() || !option.follow.empty() || outlook.moments.empty())
    return EasedCamera(frame_view(option, side, outlook.all(), aspect, part));
  const Camera like = direction_of(option, side);
  std::vector<TimedSpots> moments{{outlook.start_time, outlook.start_middle, outlook.start}};
  moments.insert(moments.end(), outlook.moments.begin(), outlook.moments.end());
  std::vector<Spot> whole;
  for (const TimedSpots& moment : moments)
    whole.insert(whole.end(), moment.spots.begin(), moment.spots.end());
  const double slope = std::tan(0.5 * static_cast<double>(like.fov) * kPi / 180) * std::min(1.0, aspect);
  const Camera still = fit_camera(whole, like, aspect, part);
  const double far = distance_of(still);
  const double near = std::max(distance_of(fit_camera(outlook.start, like, aspect, part)),
                               std::min(far, outlook.body / (kSeenWell * slope)));
  if (far <= kStill * near) return EasedCamera(still);
  return EasedCamera(moments, like, aspect, part, near);
}

Camera come_near(const CameraOption& option, const Camera& framed, const Spot& body, double aspect,
                 const PicturePart& part) {
  const std::vector<Spot> around{{body.centre, kAround * body.radius}};
  Camera near = frame_view(option, framed, around, aspect, part);
  // A body that is nearly all there is need not have as much around it.
  const float all = (framed.eye - framed.target).norm(), distance = (near.eye - near.target).norm();
  if (distance > all) near.eye = near.target + all / distance * (near.eye - near.target);
  return near;
}

std::vector<BodyLook> looks_of(const Scene& scene, const Model& model) {
  std::vector<BodyLook> out;
  if (scene.looks.empty()) return out;
  out.resize(model.name.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (const auto look = scene.looks.find(model.name[i]); look != scene.looks.end()) out[i] = look->second;
  }
  return out;
}

bool all_opaque(const std::vector<BodyLook>& looks) {
  return std::all_of(looks.begin(), looks.end(), [](const BodyLook& look) { return look.opacity == 1; });
}

void show_on_device(const Model& model, const std::optional<BoundingSphere>& around, VisualScene& visual) {
  visual.clear();
  add_grounds(model, visual);
  if (around) set_sphere(*around, visual);
}

Camera scene_camera(const Scene& scene, double aspect) {
  return fit_camera(spots_of(scene.model, scene.initial), side_of(scene), aspect);
}

Camera scene_camera(const Scene& scene, const State& end, double aspect) {
  const Model& model = scene.model;
  std::vector<Spot> spots = spots_of(model, scene.initial);
  const auto around = bounding_sphere(model, scene.initial);
  if (!around) return fit_camera(spots, side_of(scene), aspect);
  std::vector<double> way;
  for (const Vec3& c : end.c) way.push_back((c - around->centre).norm());
  const std::vector<std::uint8_t> matters =
      who_matters(model, *around, way, end, bodies_in_picture(model, end), scene.params.gravity);
  for (Index i = 0; i < model.size(); ++i)
    if (matters[static_cast<std::size_t>(i)]) add_spots(model.shape[i], {end.c[i], end.R[i]}, spots);
  return fit_camera(spots, side_of(scene), aspect);
}

}  // namespace pabd
