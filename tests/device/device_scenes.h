// SPDX-License-Identifier: MIT
// Scenes and contexts for tests of the solver on the GPU.
#pragma once

#include <memory>

#include "render/context/context.h"
#include "render/device/device_solver.h"
#include "sim/scene/scene.h"

namespace pabd::testing {

// A shipped scene, solved by `descent` until bodies move by less than 1e-9 d̂.
Scene exact_scene(const char* name);

// The same for any scene.
void solve_exactly(Params& params);

// Two blocks with a board between, 1 by 0.5 by 1 in all: a body of three parts that stands on eight corners.
Shape bench();

// Boxes, balls, capsules, hulls, cylinders and cones, and angles of two parts if asked for, `each` of every kind, that fall
// on a plane in rows; `at`: where all of it is, m.
Scene mixed_heap(int each, const Vec3& at = Vec3::Zero(), bool compounds = false);

// A board on side × side posts of 3 m that stand still, four contacts with each, and two boxes on it.
Scene board_on_posts(int side);

// The first context of this machine, current.
std::unique_ptr<GlContext> any_context();

// Whether private arrays of doubles are arrays of doubles there. One driver keeps them as floats: what is computed in
// double with them has the digits of a float.
bool keeps_doubles(GlContext& context);

// State after so many steps on the GPU, none of which was waited for; how many were made again.
State run(const Scene& scene, const DeviceOptions& options, int steps, int* repeated = nullptr);

// Largest distance of a centre, and of the nine entries of an orientation.
double pose_difference(const State& a, const State& b);

// Boxes of different friction on a slope of 24°, each below one of another group, solved to the end.
Scene slope_of_own_friction(FrictionRule rule);

}  // namespace pabd::testing
