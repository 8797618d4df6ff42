// SPDX-License-Identifier: MIT
// What is shown of bodies beside their surfaces: where they go, where they went, their boxes.
#pragma once

#include <span>

#include "render/visual/visual_scene.h"
#include "sim/body/model.h"
#include "sim/body/state.h"

namespace pabd {

// An arrow says where the centre of mass would be after this time; s.
inline constexpr double kVelocityTime = 0.2;

// From the centres of mass of movable bodies; none where it would be shorter than a few pixels.
void add_velocity_arrows(const Model& model, const State& state, VisualScene& out);

// The axis-aligned boxes that collision detection looks for pairs with (without the distance d̂); of movable bodies.
void add_boxes(const Model& model, const State& state, VisualScene& out);

// The path of a point, oldest first: it fades towards its beginning.
void add_trail(std::span<const Vec3> path, const Vec4f& color, VisualScene& out);
inline constexpr std::size_t kTrailInks = 5;  // colours of trails, again from the first on after them
Vec4f trail_color(std::size_t number);

}  // namespace pabd
