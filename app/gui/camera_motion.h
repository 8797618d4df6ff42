// SPDX-License-Identifier: MIT
// What moves with time in the view: a camera that follows a body or its keys, and trails.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/gui/ui_state.h"
#include "app/workbench/snapshot.h"

namespace pabd {

// The view, and the body that it goes along with: its name, and where it is as the view is that.
struct FollowedView {
  CameraPose camera;
  std::string body;  // empty: none
  Vec3 at = Vec3::Zero();
};
FollowedView followed_view(const Snapshot& sim, const UiState& ui);
// As for --camera, of a run that begins with that state: there the view is as far from the body as here. A body that
// is not there is not followed.
std::string camera_words(const FollowedView& view, const Model& model, const State& start);

class CameraMotion {
 public:
  // Once a frame. The camera goes as far as the body that it follows; while time goes on it follows its keys, at rest
  // it may be moved by hand.
  void move(const Snapshot& sim, UiState& ui);
  // Of what ui.trails asks for, as far as it was seen: broken where the run was wound on.
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
};

}  // namespace pabd
