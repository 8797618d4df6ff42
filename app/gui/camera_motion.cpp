// SPDX-License-Identifier: MIT
// See camera_motion.h.
#include "app/gui/camera_motion.h"

#include <algorithm>

#include "app/frames/camera_option.h"
#include "render/visual/bounds.h"

namespace pabd {
namespace {

constexpr double kOneStep = 1.5;  // in steps: less is the next one, rounded

}  // namespace

FollowedView followed_view(const Snapshot& sim, const UiState& ui) {
  FollowedView out{ui.camera, {}, Vec3::Zero()};
  if (!ui.follow || *ui.follow >= sim.a.state->size() || !has_finite_pose(*sim.a.state, *ui.follow))
    return out;
  const auto i = static_cast<std::size_t>(*ui.follow);
  out.body = sim.a.model->name[i];
  out.at = sim.a.state->c[i];
  return out;
}

std::string camera_words(const FollowedView& view, const Model& model, const State& start) {
  const auto named = std::find(model.name.begin(), model.name.end(), view.body);
  if (view.body.empty() || named == model.name.end()) return camera_words(rounded(view.camera));
  const auto i = static_cast<std::size_t>(named - model.name.begin());
  CameraPose camera = view.camera;
  camera.eye += start.c[i] - view.at;
  camera.target += start.c[i] - view.at;
  // A comma would end the name.
  const bool plain = view.body.find(',') == std::string::npos;
  return camera_words(rounded(camera)) + ",follow:" + (plain ? view.body : std::to_string(i));
}

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

void CameraMotion::move(const Snapshot& sim, const Viewport& port, UiState& ui) {
  if (!sim.a.poses) follow(*sim.a.state, ui);
  if (trails_.points() != ui.trails || scene_ != sim.scene_serial)
    trails_ = TrailRecorder(ui.trails, kTrailTime);
  scene_ = sim.scene_serial;
  const double time = sim.a.state->time;
  const bool jumped = sim.jumps != jumps_ && time > shown_ + kOneStep * sim.a.made_with.h;
  if (!sim.a.poses) trails_.add(*sim.a.model, *sim.a.state, jumped);
  jumps_ = sim.jumps;
  shown_ = time;
  if (ui.fly && !ui.camera_keys.empty() && time != flown_to_) ui.camera = camera_at(ui.camera_keys, time);
  flown_to_ = ui.fly ? time : -1;
  along_.move(sim, port, ui);
}

}  // namespace pabd
