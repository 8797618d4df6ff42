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

// Boxes, balls, capsules and hulls, `each` of every kind, that fall on a plane in rows; `at`: where all of it is, m.
Scene mixed_heap(int each, const Vec3& at = Vec3::Zero());

// The first context of this machine, current.
std::unique_ptr<GlContext> any_context();

// Largest distance of a centre, and of the nine entries of an orientation.
double pose_difference(const State& a, const State& b);

}  // namespace pabd::testing
