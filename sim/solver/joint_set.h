// The joints of a step, those of the model and the pulls, on the arrays of the workspace: energies, and
// derivatives for the solvers.
#pragma once

#include "sim/joint/expand.h"
#include "sim/solver/solve.h"

namespace pabd {

// A joint seen from one of its bodies: the sums that its bonds add to the body's quadratic model.
struct JointSums {
  double energy = 0;
  Vec3 g_c = Vec3::Zero(), g_w = Vec3::Zero();
  Mat3 H_cc = Mat3::Zero(), H_wc = Mat3::Zero(), H_ww = Mat3::Zero();
};

// Makes the pulls of a step joints of the workspace: soft distance joints of length 0 from the world.
void take_pulls(const Model& model, const std::vector<Pull>& pulls, StepWorkspace::Impl& w);

// Bonds of joint k with body `moved` at `trial` (kWorld: all where they are).
void expand_at(const SolveContext& s, Index k, Index moved, const Pose& trial, BondList& out);

// Calls visit(f, y, other) for every bond of the joints of body i at the current iterate: energy and weight
// of the bond, and the gradient on i's point; that point, seen from the centre of i, world; the body at the
// other end.
template <class Visit>
void each_bond_of(const SolveContext& s, Index i, const Visit& visit) {
  BondList list;
  for (const Index k : s.w.joints_of(i)) {
    const Joint& joint = s.w.all_joints[static_cast<std::size_t>(k)];
    expand_at(s, k, kWorld, {}, list);
    const BondLaw law = law_of(s.w, k);
    const bool is_a = joint.i == i;
    for (int b = 0; b < list.count; ++b) {
      PointBondForce f = evaluate(law, list.bond[b]);
      if (is_a) f.gradient = -f.gradient;
      visit(f, Vec3((is_a ? list.bond[b].y_a : list.bond[b].y_b) - s.w.pose[i].c), is_a ? joint.j : joint.i);
    }
  }
}

// Energy of the joints of body i at a trial pose, and their quadratic model at the current one.
double joint_energy(const SolveContext& s, Index i, const Pose& trial);
void add_joints(const SolveContext& s, Index i, JointSums& sums);

// Energy of joint k at the current iterate; J.
double energy_of_joint(const SolveContext& s, Index k);

// Largest distance between points that should coincide, over all joints; m.
double largest_joint_error(const SolveContext& s);

}  // namespace pabd
