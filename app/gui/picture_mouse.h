// SPDX-License-Identifier: MIT
// The mouse in the picture: moves the camera, pulls bodies, shoots balls, selects.
#pragma once

#include <optional>

#include "app/gui/gui_layout.h"
#include "app/gui/panel.h"
#include "render/context/window.h"
#include "render/visual/camera_control.h"

namespace pabd {

class PictureMouse {
 public:
  // Events of this frame. `in_picture`: the pointer is over the picture and over no panel.
  void handle(const WindowEvent& event, bool in_picture, const GuiLayout& layout, GuiFrame& frame,
              CameraPose& camera);

  // The space bar: true when its event means play or pause, a release without a shot meanwhile.
  bool plays(const KeyChanged& space);

  // Selects what was double-clicked. Once a frame, after ImGui's NewFrame.
  void select(const GuiLayout& layout, GuiFrame& frame) const;

  bool pulling() const { return grip_.has_value(); }
  void let_go(Outbox& out);  // of a body

 private:
  struct Grip {
    std::shared_ptr<const Model> model;
    Index body = 0;
    Vec3 r;            // where it is held; body frame, m
    double depth = 0;  // of the hand in front of the eye; m
    Side side = Side::a;
  };

  void press(const MouseClicked& click, const GuiLayout& layout, GuiFrame& frame, const CameraPose& camera);
  bool grab(const GuiLayout& layout, GuiFrame& frame, const CameraPose& camera);
  void pull(const GuiLayout& layout, GuiFrame& frame, const CameraPose& camera);
  void shoot(const GuiLayout& layout, GuiFrame& frame, const CameraPose& camera);
  void drag(double dx, double dy, const Rect& place, CameraPose& camera) const;

  int held_ = -1;  // button
  bool shift_ = false;
  bool space_ = false, shot_ = false;
  std::optional<Grip> grip_;
  double x_ = 0, y_ = 0;
};

}  // namespace pabd
