// SPDX-License-Identifier: MIT
// Glyphs of joints: the two points of every bond, axes, angles, offsets, springs.
#pragma once

#include "render/visual/visual_scene.h"
#include "sim/body/model.h"
#include "sim/body/state.h"

namespace pabd {

struct GlyphSize {
  double dot = 0.02;   // radius of the dot of y_i, m, as long as that is readable
  double pull = 0;     // how far points are moved towards the eye, out of the bodies that they lie in; m
  bool plain = false;  // one dot where the two points of a bond meet: for thousands of joints
};

// Adds what is to be seen of `joint` between bodies at poses i and j (identity for the world) at `time` (s).
//   bond     y_i a dark dot, y_j a light disc with a rim in the colour of the joint's type: a bullseye where
//            the two meet, a line between them where they do not
//   angle    its axis, the present angle as a pointer, limits as an arc
//   offset   its line, the present offset as a bar from the anchor of i to that of j, limits as stops
//   nothing  free: the three axes along which it holds; one point where that would be small
//   length   between two points: a coil if soft, else a rod
// The traits of a joint type say what it leaves free (sim/joint/joint_traits.h).
// `out.camera` must be set before: dots are kept within a few pixels as it sees them, and what would be too
// small to read is left out. A joint with a non-finite number is left out.
void add_joint_glyphs(const Joint& joint, const Pose& i, const Pose& j, double time, const GlyphSize& size,
                      VisualScene& out);

// One joint of a model, with sizes that suit its bodies.
void add_joint_glyphs(const Model& model, const State& state, const Joint& joint, VisualScene& out);

// All joints of a model, with sizes that suit their bodies; thousands as plain dots.
void add_joint_glyphs(const Model& model, const State& state, VisualScene& out);

// Identity for the world.
Pose pose_of(const State& state, Index body);

// The types of joints in a model as bits 1 << type, for the legend.
unsigned joint_types(const Model& model);

}  // namespace pabd
