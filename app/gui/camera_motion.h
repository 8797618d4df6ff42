// SPDX-License-Identifier: MIT
// What moves with time in the view: a camera that follows a body or its keys, and trails.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/gui/going_along.h"
#include "app/gui/ui_state.h"
#include "app/workbench/snapshot.h"

namespace pabd {

// The view, and the body that it follows, with the body's place for that view.
struct FollowedView {
  CameraPose camera;
  std::string body;  // empty: none
  Vec3 at = Vec3::Zero();
};
FollowedView followed_view(const Snapshot& sim, const UiState& ui);
// As for --camera, for a run that begins with that state: the view has the same place relative to the body. A body that
// does not exist there is not followed.
std::string camera_words(const FollowedView& view, const Model& model, const State& start);

class CameraMotion {
 public:
  // Once a frame. The camera moves with the body that it follows; while time goes on it flies along its keys, or goes
  // along by itself.
  void move(const Snapshot& sim, const Viewport& port, UiState& ui);
  // The trails of ui.trails, as far as they were recorded: broken where the run jumped.
  std::vector<Trail> trails() const { return trails_.trails(); }

 private:
  void follow(const State& state, UiState& ui);

  std::optional<Index> followed_;    // in the last frame
  Vec3 followed_at_ = Vec3::Zero();  // where it was then; m
  double flown_to_ = -1;             // time that the camera has followed its keys to; s
  std::uint64_t scene_ = 0;          // of the trails
  std::uint64_t jumps_ = 0;          // that the trails know of
  double shown_ = 0;                 // s: time of the latest state that they have
  TrailRecorder trails_;
  GoingAlong along_;
};

}  // namespace pabd
