// The form that makes a body where the view looks. Part of the inspector.
#pragma once

#include <array>

#include "app/gui/panel.h"
#include "app/session/model_edit.h"

namespace pabd {

class BodyMaker {
 public:
  void draw(GuiFrame& frame);

 private:
  int shape_ = 0;                              // box, sphere, capsule
  std::array<double, 3> size_{0.4, 0.4, 0.4};  // box: edges; else radius and length; m
  double density_ = 1000;                      // kg/m³
};

// The body of that shape at `place`, lifted on top of what is there.
AddBody body_at(const RunView& run, const Shape& shape, double density, const Vec3& place);

}  // namespace pabd
