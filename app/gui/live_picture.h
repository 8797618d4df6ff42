// How the picture of the scene is drawn in this frame, if at all: as well as it can be at rest; smaller,
// plainer and not in every frame while it moves, so that the window stays quick on a machine without a GPU.
#pragma once

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

  // `seconds` since the last frame.
  Plan plan(const Snapshot& sim, const UiState& ui, double seconds);
  // Milliseconds that a picture after `plan` took.
  void took(const Plan& plan, double ms);

 private:
  LiveScale scale_;
  Camera camera_;
  double rest_ = 1e9;    // s since something moved
  double last_ms_ = 0;   // of a picture
  bool skipped_ = true;  // the frame before drew none
};

}  // namespace pabd
