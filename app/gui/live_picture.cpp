// SPDX-License-Identifier: MIT
// See live_picture.h.
#include "app/gui/live_picture.h"

#include <algorithm>

namespace pabd {
namespace {

constexpr double kRest = 0.3;    // s without motion, then it is drawn as well as it can be
constexpr double kLeisure = 12;  // ms; a quicker picture is drawn in every frame
constexpr double kShare = 0.3;   // of the time at most goes into slower ones
// A picture that takes much longer than the last one is an accident, as while a driver compiles; ms, times.
constexpr double kUsual = 100, kAccident = 3;
// Smaller pictures look bad, and are hardly faster with many bodies.
constexpr double kSmallest = 0.5;

// The moment of one, what a person sets of the other.
RunView mixed(const RunView& moment, const RunView& latest) {
  RunView out = moment;
  out.params = latest.params;
  out.kappa = latest.kappa;
  out.changed = latest.changed;
  return out;
}

}  // namespace

LivePicture::Drawn LivePicture::moment(const Snapshot& sim) {
  return {sim.scene_serial,  sim.a.model.get(), sim.a.state->step,
          sim.a.state->time, sim.a.cursor,      sim.b ? sim.b->state->step : -1};
}

bool LivePicture::has_turn(double now) const {
  return last_ms_ < kLeisure || 1000 * (now - drawn_) >= last_ms_ / kShare;
}

std::shared_ptr<const Snapshot> LivePicture::choose(std::shared_ptr<const Snapshot> latest, double now) {
  const bool waits = chosen_ && latest->playing && !has_turn(now) &&
                     latest->scene_serial == chosen_->scene_serial && latest->a.model == chosen_->a.model &&
                     latest->b.has_value() == chosen_->b.has_value();
  if (waits) {
    auto out = std::make_shared<Snapshot>(*latest);
    out->a = mixed(chosen_->a, latest->a);
    if (latest->b) out->b = mixed(*chosen_->b, *latest->b);
    out->distances = chosen_->distances;
    return out;
  }
  chosen_ = std::move(latest);
  return chosen_;
}

LivePicture::Plan LivePicture::plan(const Snapshot& sim, const UiState& ui, double now) {
  const Camera camera = rounded(ui.camera);
  // A single step is drawn at full quality.
  const bool moving = sim.playing || camera != camera_;
  camera_ = camera;
  if (moving) moved_ = now;
  const bool owed = moment(sim) != shown_;
  if (now - moved_ > kRest) {
    shown_ = moment(sim);
    return {};
  }
  const bool turn = !moving || owed || has_turn(now);
  if (turn) {
    drawn_ = now;
    shown_ = moment(sim);
  }
  return {turn, RenderQuality::live(), std::max(kSmallest, scale_.scale())};
}

void LivePicture::took(const Plan& plan, double ms) {
  last_ms_ = std::min(ms, std::max(kUsual, kAccident * last_ms_));
  if (plan.quality.level == Quality::draft) scale_.took(ms);
}

}  // namespace pabd
