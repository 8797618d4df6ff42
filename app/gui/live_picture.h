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

  // `now` in seconds, since whenever.
  Plan plan(const Snapshot& sim, const UiState& ui, double now);
  // Milliseconds that a picture after `plan` took.
  void took(const Plan& plan, double ms);

 private:
  LiveScale scale_;
  Camera camera_;
  double moved_ = -1e9, drawn_ = -1e9;  // when something moved last, and a picture was begun; s
  double last_ms_ = 0;                  // of a picture
};

}  // namespace pabd
