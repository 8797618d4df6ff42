// SPDX-License-Identifier: MIT
// From a place in the world at the start pose to the frames of a joint on its two bodies.
#pragma once

#include "sim/body/model.h"
#include "sim/body/state.h"

namespace pabd {

// Columns n, e, n × e with n along `axis`, which must not be zero.
Mat3 frame_about(const Vec3& axis);

// Frame of a joint of that type. `second_axis` counts where it has two; what of it lies along `axis` is left
// out, and the rest must not be zero; empty: any direction square to `axis`.
Mat3 joint_frame(JointType type, const Vec3& axis, const std::optional<Vec3>& second_axis);

// The world frame F at `anchor`, seen from `body` at the pose it has in `state` (kWorld: as it is).
JointFrame frame_on(const State& state, Index body, const Vec3& anchor, const Mat3& F);

// Puts both frames of `joint` at `anchor`; joint.i and joint.j say on which bodies.
void attach(const State& state, const Vec3& anchor, const Mat3& F, Joint& joint);

// Default length of the arms: half the bounding radius of the smaller body, planes left out; m.
double default_arm(const Model& model, Index i, Index j);

}  // namespace pabd
