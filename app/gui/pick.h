// SPDX-License-Identifier: MIT
// What is under the pointer in the picture, and the selection when bodies are added or removed.
#pragma once

#include <optional>

#include "app/gui/ui_state.h"
#include "app/workbench/snapshot.h"
#include "render/visual/camera_control.h"

namespace pabd {

// The surface of a body under a pixel (from the top left corner of the picture).
struct PickedBody {
  Index body = 0;
  Vec3 point;        // world; m
  Vec3 normal;       // outward, world
  double depth = 0;  // of the point in front of the eye, along the line of sight; m
};
std::optional<PickedBody> pick_body(const RunView& run, const CameraPose& camera, const Viewport& port,
                                    double x, double y);

// The contact or joint whose glyph is shown within `reach` pixels and not far behind the nearest body, else
// the body; Selection::Kind::none for nothing.
Selection pick(const RunView& run, const UiState& ui, const Viewport& port, double x, double y, double reach);

// What `selection`, made in `before`, is in `after`: bodies and joints by name, contacts by the two bodies
// and the place. A contact that has opened keeps its two bodies and has no number (−1). None when it is gone.
Selection follow(const Selection& selection, const RunView& before, const RunView& after);

// Where the two frames of a joint are; world, m.
struct JointPoints {
  Vec3 on_i, on_j;
};
JointPoints joint_points(const State& state, const Joint& joint);

// A ball from the eye that meets what pixel (x, y) shows: as heavy as a typical body, half its size.
command::Shoot aim(const RunView& run, const CameraPose& camera, const Viewport& port, double x, double y);

}  // namespace pabd
