// SPDX-License-Identifier: MIT
// The camera that goes along by itself, in a run whose future is not known. It stands while all that moves is in the
// picture and large enough to be seen; from then on it follows, without turning, the middle of what moves.
//
//   g, m, u   the eye from which all is seen (framing.h), the middle of what moves and its velocity      m, m/s
//   s         follows m:       s″ = ω² (m − s) + 2ω (u − s′)        no lag behind what moves evenly
//   x         the eye from s:  x″ = ν² (g − m − x) − 2ν x′          begins at rest where the camera stands
//
// The eyes that have everything in the picture are a convex set with g in it: where s + x leaves it, the eye is moved
// towards g until it is in it again.
#pragma once

#include <memory>
#include <vector>

#include "app/gui/ui_state.h"
#include "app/workbench/snapshot.h"
#include "render/visual/bounds.h"

namespace pabd {

class GoingAlong {
 public:
  // Once a frame. Nothing where a person moved the camera, or it follows a body or its keys.
  void move(const Snapshot& sim, const Viewport& port, UiState& ui);
  bool active() const { return active_; }

 private:
  void begin(const Snapshot& sim);
  void start(const UiState& ui);
  std::vector<Spot> what_moves(const RunView& run);
  void ease(double seconds, const Camera& goal);
  CameraPose eased(const CameraPose& like, double distance) const;

  std::shared_ptr<const Model> model_;
  std::uint64_t jumps_ = 0;
  std::optional<BoundingSphere> around_;  // at first
  double time_ = 0;                       // s
  bool active_ = false;

  std::vector<Spot> now_, soon_;                                  // of what moves, where it is
  double body_ = 0;                                               // radius of a body, the median; m
  Vec3 middle_ = Vec3::Zero();                                    // m
  Vec3 velocity_ = Vec3::Zero();                                  // u
  Vec3 follower_ = Vec3::Zero(), follower_speed_ = Vec3::Zero();  // s, s′
  Vec3 offset_ = Vec3::Zero(), offset_speed_ = Vec3::Zero();      // x, x′
  double log_distance_ = 0, log_speed_ = 0;                       // of the eye from the target, eased as x is
};

}  // namespace pabd
