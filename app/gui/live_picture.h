// SPDX-License-Identifier: MIT
// How the picture of the scene is drawn in this frame, if at all: at full quality at rest; smaller, plainer and not in
// every frame while it moves, for machines without a GPU. Plots and numbers wait for the picture.
#pragma once

#include <memory>
#include <optional>
#include <tuple>

#include "app/gui/ui_state.h"
#include "app/workbench/snapshot.h"
#include "render/gl/quality.h"

namespace pabd {

class LivePicture {
 public:
  struct Plan {
    bool draw = true;
    RenderQuality quality;
    double scale = 1;  // of the picture's sides
  };

  // What this frame shows: while a picture waits for its turn, the bodies and reports of the moment that was drawn
  // last, with everything else of the latest snapshot. `now` in s.
  std::shared_ptr<const Snapshot> choose(std::shared_ptr<const Snapshot> latest, double now);
  // A moment that is not in the picture is drawn.
  Plan plan(const Snapshot& sim, const UiState& ui, double now);
  // Milliseconds that a picture after `plan` took.
  void took(const Plan& plan, double ms);

 private:
  // Of which the picture is: serial of the scene, model (only its address), step and time of A, cursor, step of B.
  using Drawn = std::tuple<std::uint64_t, const Model*, std::int64_t, double, std::size_t, std::int64_t>;
  static Drawn moment(const Snapshot& sim);
  bool has_turn(double now) const;

  std::shared_ptr<const Snapshot> chosen_;
  std::optional<Drawn> shown_;
  LiveScale scale_;
  Camera camera_;
  double moved_ = -1e9, drawn_ = -1e9;  // when something moved last, and a picture was begun; s
  double last_ms_ = 0;                  // of a picture
};

}  // namespace pabd
