// SPDX-License-Identifier: MIT
// Small worlds built in code, and a runner: shared by the physics tests and the benchmarks.
#pragma once

#include <functional>

#include "sim/body/mass_properties.h"
#include "sim/body/model.h"
#include "sim/body/state.h"
#include "sim/joint/attach.h"
#include "sim/joint/auto_kappa.h"
#include "sim/joint/joint_traits.h"
#include "sim/solver/time_step.h"

namespace pabd::testing {

struct World {
  Model model;
  State state;
  Params params;

  Index add(const Shape& shape, double mass, const Vec3& c, const Mat3& R = Mat3::Identity()) {
    const bool fixed = mass == 0;
    MassProperties properties{0, Mat3::Zero()};
    if (!fixed) {
      const double density = mass / volume(shape);
      properties = mass_properties(shape, density);
    }
    model.name.push_back("body " + std::to_string(model.size()));
    model.shape.push_back(shape);
    model.mass.push_back(properties.mass);
    model.J.push_back(properties.J);
    model.fixed.push_back(fixed);
    state.c.push_back(c);
    state.R.push_back(R);
    state.v.push_back(Vec3::Zero());
    state.omega.push_back(Vec3::Zero());
    return model.size() - 1;
  }

  Index add_ground(const Vec3& normal = Vec3::UnitY()) {
    return add(Plane{normal.normalized(), 0}, 0, Vec3::Zero());
  }
  Index add_cube(double edge, double mass, const Vec3& c, const Mat3& R = Mat3::Identity()) {
    return add(Box{Vec3::Constant(edge / 2)}, mass, c, R);
  }
};

// A joint between bodies at the world point `anchor` with its axis along `axis` at the start pose.
inline Joint make_joint(const World& world, JointType type, Index i, Index j, const Vec3& anchor,
                        const Vec3& axis = Vec3::UnitZ()) {
  Joint joint;
  joint.type = type;
  joint.i = i;
  joint.j = j;
  joint.arm = 0.25;
  joint.twist = traits_of(type).twist;
  attach(world.state, anchor, frame_about(axis), joint);
  return joint;
}

// Adds it with the automatic stiffness.
inline void add_joint(World& world, Joint joint) {
  joint.law.kappa = auto_joint_kappa(world.model, joint_load(world.model, world.params.gravity), joint);
  world.model.joints.push_back(std::move(joint));
}

// Runs `steps` steps; `each` sees the report of every one.
inline void run(World& world, int steps, const StepOptions& options = {},
                const std::function<void(const StepReport&)>& each = {}) {
  StepWorkspace workspace;
  StepReport report;
  for (int k = 0; k < steps; ++k) {
    step(world.model, world.params, options, world.state, workspace, report);
    if (each) each(report);
  }
}

}  // namespace pabd::testing
