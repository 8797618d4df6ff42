// SPDX-License-Identifier: MIT
// See scene_framing.h.
#include "app/frames/scene_framing.h"

#include <algorithm>
#include <cmath>

#include "app/session/session.h"
#include "render/visual/bounds.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr double kLongestStep = 1.0 / 120;  // s: where bodies go by and large does not need more
constexpr double kMostWork = 30'000;        // bodies × steps
constexpr int kMoments = 60;                // that are kept of it
constexpr double kAway =
    2.5;  // × the radius of the start: who ends farther from its middle has left the picture

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
  params.h = std::max(params.h, kLongestStep);
  const double movable =
      static_cast<double>(std::count(start.model->fixed.begin(), start.model->fixed.end(), 0));
  const double steps = std::min(seconds / params.h, kMostWork / std::max(1.0, movable));
  const int count = static_cast<int>(steps), every = std::max(1, count / kMoments);
  try {
    ahead.restore(start.model, start.state);
    ahead.set_params(params);
    for (int step = 1; step <= count; ++step) {
      if (ahead.step().status == StepStatus::non_finite) break;
      if (step % every == 0 || step == count) add_moment(*start.model, ahead.state(), seen, traces);
    }
  } catch (const Error&) {
    return false;
  }
  end = ahead.state();
  return true;
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
  std::vector<Spot> out = spots_of(model, start.state);
  const auto around = bounding_sphere(model, start.state);
  if (!(seconds > 0) || !around) return out;
  const std::vector<std::uint8_t> seen = bodies_in_picture(model, start.state);
  Traces traces(model.shape.size());
  State end;
  if (!run_ahead(scene, start, seconds, seen, traces, end)) return out;
  for (std::size_t i = 0; i < traces.size(); ++i) {
    const bool stays = (end.c[i] - around->centre).norm() <= kAway * around->radius;
    if (stays) out.insert(out.end(), traces[i].begin(), traces[i].end());
  }
  return out;
}

Camera scene_camera(const Scene& scene, double aspect) {
  return fit_camera(spots_of(scene.model, scene.initial), side_of(scene), aspect);
}

}  // namespace pabd
