// Turns a simulation state into things to see.
#pragma once

#include <optional>

#include "render/visual/visual_scene.h"
#include "sim/body/model.h"
#include "sim/body/state.h"
#include "sim/solver/report.h"

namespace pabd {

struct VisualOptions {
  bool bonds = false;      // points of contact pairs and of joints, axes of joints
  bool contacts = false;   // normal arrows and discs coloured by d/d̂
  double d_hat = 0.01;     // for the colours; m
  double glyph_scale = 0;  // size of glyphs in m; 0: from the size of the bodies
};

// Fills `out` (reusing its memory). Fixed planes become `grounds`. `report` may lack contact reports. The
// camera is left alone; glyphs of joints have sizes that suit it, so set it before.
void build_visual(const Model& model, const State& state, const StepReport& report,
                  const VisualOptions& options, VisualScene& out);

// A camera that frames the movable bodies from a pleasing angle.
Camera frame_camera(const Model& model, const State& state, double aspect);

// Linear colour of a contact at x = d/d̂: below 0 penetrating, 1 untouched. The legend uses the same function.
Vec4f contact_color(double x);

}  // namespace pabd
