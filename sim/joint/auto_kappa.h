// The stiffness "auto" of joints.
#pragma once

#include "sim/body/model.h"

namespace pabd {

// κ at which the weight of all movable bodies stretches a bond of `law` by 1e-8 of the smallest of them: N/m
// for soft bonds, J for hard ones. 9.81 m/s² where gravity is zero.
double auto_joint_kappa(const Model& model, const Vec3& gravity, const BondLaw& law);

}  // namespace pabd
