// See live_picture.h.
#include "app/gui/live_picture.h"

namespace pabd {
namespace {

constexpr double kRest = 0.3;    // s without motion, then it is drawn as well as it can be
constexpr double kLeisure = 12;  // ms; a slower picture is drawn in every second frame only

bool same_camera(const Camera& a, const Camera& b) {
  return a.eye == b.eye && a.target == b.target && a.up == b.up && a.fov == b.fov;
}

}  // namespace

LivePicture::Plan LivePicture::plan(const Snapshot& sim, const UiState& ui, double seconds) {
  const Camera camera = rounded(ui.camera);
  // A single step is no motion: it is worth a good picture.
  const bool moving = sim.playing || !same_camera(camera, camera_);
  camera_ = camera;
  rest_ = moving ? 0 : rest_ + seconds;
  if (rest_ > kRest) return {};
  const bool turn = !moving || skipped_ || last_ms_ < kLeisure;
  skipped_ = !turn;
  return {turn, RenderQuality::live(), scale_.scale()};
}

void LivePicture::took(const Plan& plan, double ms) {
  last_ms_ = ms;
  if (plan.quality.samples == RenderQuality::live().samples) scale_.took(ms);
}

}  // namespace pabd
