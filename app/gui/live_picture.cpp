// See live_picture.h.
#include "app/gui/live_picture.h"

#include <algorithm>

namespace pabd {
namespace {

constexpr double kRest = 0.3;    // s without motion, then it is drawn as well as it can be
constexpr double kLeisure = 12;  // ms; a quicker picture is drawn in every frame
constexpr double kShare = 0.3;   // of the time at most goes into slower ones
// Smaller ones look bad, and are hardly quicker where there are many bodies.
constexpr double kSmallest = 0.5;

bool same_camera(const Camera& a, const Camera& b) {
  return a.eye == b.eye && a.target == b.target && a.up == b.up && a.fov == b.fov;
}

}  // namespace

LivePicture::Plan LivePicture::plan(const Snapshot& sim, const UiState& ui, double now) {
  const Camera camera = rounded(ui.camera);
  // A single step is no motion: it is worth a good picture.
  const bool moving = sim.playing || !same_camera(camera, camera_);
  camera_ = camera;
  if (moving) moved_ = now;
  if (now - moved_ > kRest) return {};
  const bool turn = !moving || last_ms_ < kLeisure || 1000 * (now - drawn_) >= last_ms_ / kShare;
  if (turn) drawn_ = now;
  return {turn, RenderQuality::live(), std::max(kSmallest, scale_.scale())};
}

void LivePicture::took(const Plan& plan, double ms) {
  last_ms_ = ms;
  if (plan.quality.samples == RenderQuality::live().samples) scale_.took(ms);
}

}  // namespace pabd
