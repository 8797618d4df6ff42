// SPDX-License-Identifier: MIT
// The stiffness "auto" of joints.
#pragma once

#include "sim/body/model.h"

namespace pabd {

// What the stiffness of joints follows from. Linear in the number of bodies: find it once a model.
struct JointLoad {
  double g;         // m/s²
  double weight;    // of all movable bodies, any of which may come to hang on a joint; N
  double smallest;  // thickness of the thinnest of them; m
};

// 9.81 m/s² where gravity is zero; a weight of 0 when nothing can move.
JointLoad joint_load(const Model& model, const Vec3& gravity);

// κ at which that weight stretches a bond of `law` by 1e-8 of the smallest body: N/m for soft bonds, J for
// hard ones; 1 when nothing can move.
double auto_joint_kappa(const JointLoad& load, const BondLaw& law);

// The same for a joint between bodies: at most so stiff that the rounding of a place 2 km from the origin
// pulls with the weight of the lighter of its bodies. Only chains of some ten thousand links ask for more.
double auto_joint_kappa(const Model& model, const JointLoad& load, const Joint& joint);

// Part of the automatic κ that limits get. A stop goes on and off as bodies hit it; where it is as stiff as
// the joint itself, 1e-10 rad decide which, and iterations flip between the two.
inline constexpr float kLimitScale = 1e-3f;

}  // namespace pabd
