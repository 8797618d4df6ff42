// SPDX-License-Identifier: MIT
// A model put together body by body, for tests that need no physics.
#pragma once

#include "sim/body/mass_properties.h"
#include "sim/body/model.h"
#include "sim/body/state.h"

namespace pabd {

struct TinyModel {
  Model model;
  State state;

  Index add(const Shape& shape, const Vec3& c, const Mat3& R = Mat3::Identity(), bool fixed = false) {
    const MassProperties mass = fixed ? MassProperties{0, Mat3::Zero()} : mass_properties(shape, 1000);
    model.name.push_back("body " + std::to_string(model.size()));
    model.shape.push_back(shape);
    model.mass.push_back(mass.mass);
    model.J.push_back(mass.J);
    model.fixed.push_back(fixed ? 1 : 0);
    state.c.push_back(c);
    state.R.push_back(R);
    state.v.push_back(Vec3::Zero());
    state.omega.push_back(Vec3::Zero());
    return model.size() - 1;
  }

  Index add_fixed(const Shape& shape, const Vec3& c) { return add(shape, c, Mat3::Identity(), true); }
};

}  // namespace pabd
