// The mouse in the picture: turning, moving and coming nearer.
#pragma once

#include "app/gui/panel.h"
#include "render/context/window.h"
#include "render/visual/camera_control.h"

namespace pabd {

class Hands {
 public:
  // Events of this frame, those that no panel wants. `port` is the picture's place in the window, of A.
  void handle(const WindowEvent& event, bool in_picture, const Rect& place, const GuiFrame& frame,
              CameraPose& camera);

  bool busy() const { return held_ >= 0; }  // a drag goes on, wherever the pointer is

 private:
  void drag(double dx, double dy, const Rect& place, CameraPose& camera) const;

  int held_ = -1;  // button
  bool shift_ = false;
  double x_ = 0, y_ = 0;
};

}  // namespace pabd
