// SPDX-License-Identifier: MIT
// See scene_framing.h.
#include "app/frames/scene_framing.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/overlay/overlay_panels.h"
#include "app/session/session.h"
#include "render/visual/body_parts.h"
#include "render/visual/bounds.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr double kLongestStep = 1.0 / 120;  // s: where bodies go by and large does not need more
constexpr double kMostWork = 30'000;        // bodies × steps
constexpr double kMadeEnergy = 0.02;        // of the energy there is, above what drives brought
constexpr int kMoments = 60;                // that are kept of it
constexpr double kLeastPart = 0.15;         // of the frame's sides: less is no room for a picture
constexpr double kAround = 7;  // radii of a body that is followed: so much of what is around it is seen
// Radii of the start, from its middle: who ends farther has left the picture. Where most come to rest belongs to it, 1.5
// times as far as half of them; where none stays, their ways do, as far, and at most 60 radii or 1.5 times
// as far as they fell onto what they go on.
constexpr double kAway = 6, kFarther = 1.5, kFarthest = 60;

// A body's spots at each of the moments.
using Traces = std::vector<std::vector<Spot>>;

void add_moment(const Model& model, const State& state, const std::vector<std::uint8_t>& seen, Traces& out) {
  for (Index i = 0; i < model.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (seen[at] && !model.fixed[at]) add_spots(model.shape[at], {state.c[at], state.R[at]}, out[at]);
  }
}

// Runs ahead. False for what has no way to be told.
bool run_ahead(const std::shared_ptr<const Scene>& scene, const FrameView& start, double seconds,
               const std::vector<std::uint8_t>& seen, Traces& traces, State& end) {
  Session ahead(scene);
  Params params = start.params;
  const double movable =
      static_cast<double>(std::count(start.model->fixed.begin(), start.model->fixed.end(), 0));
  // Its own steps lead where it will go; longer ones nearly there.
  if (seconds / params.h * movable > kMostWork) params.h = std::max(params.h, kLongestStep);
  const double steps = std::min(seconds / params.h, kMostWork / std::max(1.0, movable));
  const int count = static_cast<int>(steps), every = std::max(1, count / kMoments);
  try {
    ahead.restore(start.model, *start.state);
    ahead.set_params(params);
    double allowed = 0;  // energy that there may be; J
    for (int step = 1; step <= count; ++step) {
      const StepReport& report = ahead.step();
      if (report.status == StepStatus::non_finite) break;
      // Steps that are too long for the scene make energy: what follows is no way that bodies go.
      const double energy = report.kinetic + report.potential + report.elastic;
      allowed = step == 1 ? energy : allowed + report.drive_work;
      if (energy - allowed > kMadeEnergy * (report.kinetic + std::abs(report.potential))) break;
      if (step % every == 0 || step == count) add_moment(*start.model, ahead.state(), seen, traces);
    }
  } catch (const Error&) {
    return false;
  }
  end = ahead.state();
  return true;
}

double median_of(std::vector<double>& list) {
  const auto middle = list.begin() + static_cast<std::ptrdiff_t>(list.size() / 2);
  std::nth_element(list.begin(), middle, list.end());
  return *middle;
}

double way_from(const BoundingSphere& start, const Vec3& c) { return (c - start.centre).norm(); }

// How far from the middle of the start is still in the picture, and whether any body ends there; m.
struct Reach {
  double far;
  bool any;
};
Reach reach_of(const Model& model, const BoundingSphere& start, const State& end,
               const std::vector<std::uint8_t>& seen, const Vec3& gravity) {
  const Vec3 down = gravity.normalized();
  std::vector<double> all, at_rest, landed;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!seen[i] || model.fixed[i]) continue;
    all.push_back(way_from(start, end.c[i]));
    // It would take more than a second to leave its place, or its height.
    const double slow = bounding_radius(model.shape[i]);
    if (end.v[i].norm() < slow) at_rest.push_back(all.back());
    if (std::abs(end.v[i].dot(down)) < slow) landed.push_back((end.c[i] - start.centre).dot(down));
  }
  double far = kAway * start.radius;
  if (!at_rest.empty() && 2 * at_rest.size() >= all.size())
    far = std::max(far, kFarther * median_of(at_rest));
  const auto none = [&] {
    return std::none_of(all.begin(), all.end(), [&](double way) { return way <= far; });
  };
  if (all.empty() || !none()) return {far, true};
  const double fell = landed.empty() ? 0 : median_of(landed);
  return {
      std::max(far, std::min(kFarther * median_of(all), std::max(kFarthest * start.radius, kFarther * fell))),
      false};
}

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

std::vector<Spot> spots_ahead(const std::shared_ptr<const Scene>& scene, const FrameView& start,
                              double seconds) {
  const Model& model = *start.model;
  std::vector<Spot> out = spots_of(model, *start.state);
  const auto around = bounding_sphere(model, *start.state);
  if (!(seconds > 0) || !around) return out;
  const std::vector<std::uint8_t> seen = bodies_in_picture(model, *start.state);
  Traces traces(model.shape.size());
  State end;
  if (!run_ahead(scene, start, seconds, seen, traces, end)) return out;
  const Reach reach = reach_of(model, *around, end, seen, start.params.gravity);
  for (std::size_t i = 0; i < traces.size(); ++i) {
    if (reach.any && way_from(*around, end.c[i]) > reach.far) continue;
    // Where all are gone in the end, as long as they are near.
    std::copy_if(traces[i].begin(), traces[i].end(), std::back_inserter(out),
                 [&](const Spot& spot) { return reach.any || way_from(*around, spot.centre) <= reach.far; });
  }
  return out;
}

std::vector<Spot> scene_spots(const std::shared_ptr<const Scene>& scene, double seconds) {
  FrameView start;
  start.model = {scene, &scene->model};
  start.params = scene->params;
  start.state = {scene, &scene->initial};
  return spots_ahead(scene, start, seconds);
}

PicturePart free_part(const PanelLayout& layout, std::size_t caption_lines, int width, int height) {
  const double w = width, h = height;
  Rect free = layout.panels.empty() ? Rect{0, 0, w, h} : layout.free;
  if (caption_lines > 0) {
    const double caption = std::min(caption_height(layout.scale, caption_lines), 0.5 * free.h);
    free.y += caption;
    free.h -= caption;
  }
  if (free.w < kLeastPart * w || free.h < kLeastPart * h) return {};
  return {free.x / w, free.y / h, free.w / w, free.h / h};
}

Camera frame_view(const CameraOption& option, const Camera& side, std::span<const Spot> spots, double aspect,
                  const PicturePart& part) {
  CameraOption view = option;
  view.eye = view.target = std::nullopt;
  const Camera like = view.keys.empty() ? apply_camera(view, side, 0) : side;
  // A camera that says where it is says what is in the middle of the frame.
  const PicturePart where = option.frames() ? part : PicturePart{};
  return option.view == CameraOption::View::orbit ? fit_orbit(spots, like, aspect, where)
                                                  : fit_camera(spots, like, aspect, where);
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
  std::vector<Spot> spots = spots_of(scene.model, scene.initial);
  const auto around = bounding_sphere(scene.model, scene.initial);
  const std::vector<std::uint8_t> seen = bodies_in_picture(scene.model, end);
  const double far = around ? reach_of(scene.model, *around, end, seen, scene.params.gravity).far : 0;
  for (Index i = 0; around && i < scene.model.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (seen[at] && way_from(*around, end.c[at]) <= far)
      add_spots(scene.model.shape[at], {end.c[at], end.R[at]}, spots);
  }
  return fit_camera(spots, side_of(scene), aspect);
}

}  // namespace pabd
