// SPDX-License-Identifier: MIT
// See camera_motion.h.
#include "app/gui/camera_motion.h"

#include "render/visual/bounds.h"

namespace pabd {

void CameraMotion::follow(const State& state, UiState& ui) {
  const bool there = ui.follow && *ui.follow < state.size() && has_finite_pose(state, *ui.follow);
  if (!there) ui.follow.reset();
  const Vec3 at = there ? state.c[static_cast<std::size_t>(*ui.follow)] : Vec3(Vec3::Zero());
  if (there && ui.follow == followed_) {
    ui.camera.eye += at - followed_at_;
    ui.camera.target += at - followed_at_;
  }
  followed_ = ui.follow;
  followed_at_ = at;
}

void CameraMotion::move(const Snapshot& sim, UiState& ui) {
  follow(sim.a.state, ui);
  if (trails_.points() != ui.trails || scene_ != sim.scene_serial)
    trails_ = TrailRecorder(ui.trails, kTrailTime);
  scene_ = sim.scene_serial;
  trails_.add(*sim.a.model, sim.a.state);
  const double time = sim.a.state.time;
  if (ui.fly && !ui.camera_keys.empty() && time != flown_to_) ui.camera = camera_at(ui.camera_keys, time);
  flown_to_ = ui.fly ? time : -1;
}

}  // namespace pabd
