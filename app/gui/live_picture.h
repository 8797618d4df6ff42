// SPDX-License-Identifier: MIT
// How the picture of the scene is drawn in this frame, if at all: as well as it can be at rest; smaller,
// plainer and not in every frame while it moves, so that the window stays quick on a machine without a GPU.
// Plots and numbers wait for the picture: all of them show one moment.
#pragma once

#include <memory>

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

  // What this frame shows of the latest snapshot: while a picture waits for its turn, the bodies and reports
  // of the moment that was drawn last, with everything else as it is now. `now` in seconds, since whenever.
  std::shared_ptr<const Snapshot> choose(std::shared_ptr<const Snapshot> latest, double now);
  // A moment that is not in the picture is drawn.
  Plan plan(const Snapshot& sim, const UiState& ui, double now);
  // Milliseconds that a picture after `plan` took.
  void took(const Plan& plan, double ms);

 private:
  // Of which the picture is; the model only as its address.
  struct Drawn {
    std::uint64_t scene = 0;
    const Model* model = nullptr;
    std::int64_t step = -1;
    double time = 0;
    std::size_t cursor = 0;
    std::int64_t step_b = -1;
    bool operator==(const Drawn&) const = default;
  };
  static Drawn moment(const Snapshot& sim);
  bool has_turn(double now) const;

  std::shared_ptr<const Snapshot> chosen_;
  Drawn shown_;
  LiveScale scale_;
  Camera camera_;
  double moved_ = -1e9, drawn_ = -1e9;  // when something moved last, and a picture was begun; s
  double last_ms_ = 0;                  // of a picture
};

}  // namespace pabd
