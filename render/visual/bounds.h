// SPDX-License-Identifier: MIT
// The sphere around what is to be seen: for the camera, the shadow map and the depth range.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "render/visual/visual_scene.h"
#include "sim/body/model.h"
#include "sim/body/state.h"

namespace pabd {

// Holds what is to be seen.
struct BoundingSphere {
  Vec3 centre;    // m, world
  double radius;  // m, > 0
};

// As the scene has it.
void set_sphere(const BoundingSphere& around, VisualScene& out);

// True when every number of the body's pose is finite: others cannot be drawn.
bool has_finite_pose(const State& state, Index body);

// Whether a fixed body is much larger than `movable`, the sphere around what moves. `radius`: bounding; m.
bool is_scenery(const BoundingSphere& movable, const Vec3& c, double radius);

// 1: the body belongs to the picture, that is, it is movable, or fixed and not much larger than what moves. Without a
// movable body every fixed one does. Planes and bodies without a finite pose never do.
std::vector<std::uint8_t> bodies_in_picture(const Model& model, const State& state);

// Sphere around the movable bodies (centre: of their common axis-aligned box), and around those fixed ones
// that are not much larger than the rest. Without a movable body: around the fixed ones. Planes never count.
// Empty when nothing is left.
std::optional<BoundingSphere> bounding_sphere(const Model& model, const State& state);
// Around those bodies alone that are marked by 1, planes not.
std::optional<BoundingSphere> bounding_sphere(const Model& model, const State& state,
                                              const std::vector<std::uint8_t>& marked);

}  // namespace pabd
