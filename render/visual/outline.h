// SPDX-License-Identifier: MIT
// What is selected: outlines that stand out on every colour, and a spring for the hand that pulls.
#pragma once

#include "render/visual/visual_scene.h"
#include "sim/body/shape.h"
#include "sim/body/state.h"

namespace pabd {

// Adds the outline of a body as `out.camera` sees it: amber between two dark rims, a few pixels wide, in
// front of everything, so that a hidden body is found too. Nothing for planes and for an eye inside the body.
void add_outline(const Shape& shape, const Pose& pose, VisualScene& out);

// A ring of the same kind around a point: at least `radius` m, and large enough to be seen (11 pixels).
void add_ring(const Vec3& centre, double radius, VisualScene& out);

// A spring from the hand (a dot) to where it holds a body (a ring), sized in pixels as `out.camera` sees it;
// its turns do not change while it stretches. Nothing when a number is non-finite.
void add_spring(const Vec3& hand, const Vec3& body, VisualScene& out);

}  // namespace pabd
