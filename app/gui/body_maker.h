// SPDX-License-Identifier: MIT
// The form that makes a body where the view looks. Part of the inspector.
#pragma once

#include "app/gui/panel.h"
#include "app/session/model_edit.h"
#include "sim/body/shape_kind.h"

namespace pabd {

class BodyMaker {
 public:
  void draw(GuiFrame& frame);

 private:
  const ShapeKind* kind_ = shape_kinds().front();  // of those with sizes
  Sizes size_{0.4, 0.4, 0.4};                      // m
  double density_ = 1000;                          // kg/m³
};

// The body of that shape at `place`, lifted on top of what is there.
AddBody body_at(const RunView& run, const Shape& shape, double density, const Vec3& place);

}  // namespace pabd
