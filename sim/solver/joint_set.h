// SPDX-License-Identifier: MIT
// The joints of a step, those of the model and the pulls: energies and derivatives.
#pragma once

#include "sim/joint/expand.h"
#include "sim/solver/problem.h"
#include "sim/solver/time_step.h"

namespace pabd {

// A joint seen from one of its bodies: the sums that its bonds add to the body's quadratic model.
struct JointSums {
  double energy = 0;
  Vec3 g_c = Vec3::Zero(), g_w = Vec3::Zero();
  Mat3 H_cc = Mat3::Zero(), H_wc = Mat3::Zero(), H_ww = Mat3::Zero();
};

// The pulls of a step as joints: soft distance joints of length 0 from the world. Those of fixed bodies are
// left out.
void pulls_as_joints(const Model& model, const std::vector<Pull>& pulls, std::vector<Joint>& out);

// Bonds of joint k at the iterate; with body `moved` at `trial`; and those that hold it alone, without what
// acts along it, as its drive stood at `time`.
void expand_at(const Problem& p, const Iterate& it, Index k, BondList& out);
void expand_at(const Problem& p, const Iterate& it, Index k, Index moved, const Pose& trial, BondList& out);
void expand_held(const Problem& p, const Iterate& it, Index k, double time, BondList& out);

// Calls visit(f, y, other) for every bond of the joints of body i at the iterate: energy and weight of the
// bond, and the gradient on i's point; that point, seen from the centre of i, world; the body at the other
// end.
template <class Visit>
void each_bond_of(const Problem& p, const Iterate& it, Index i, const Visit& visit) {
  BondList list;
  for (const Index k : p.joints_at[i]) {
    const Joint& joint = p.joints[k];
    expand_at(p, it, k, list);
    const BondLaw law = p.law_of(k);
    const bool is_a = joint.i == i;
    for (int b = 0; b < list.count; ++b) {
      PointBondForce f = evaluate(law, list.bond[b]);
      if (is_a) f.gradient = -f.gradient;
      visit(f, Vec3((is_a ? list.bond[b].y_a : list.bond[b].y_b) - it.pose[i].c), is_a ? joint.j : joint.i);
    }
  }
}

// Energy of the joints of body i at a trial pose, and their quadratic model at the iterate.
double joint_energy(const Problem& p, const Iterate& it, Index i, const Pose& trial);
void add_joints(const Problem& p, const Iterate& it, Index i, JointSums& sums);

// What joint k adds to E at the iterate; J.
double potential_of_joint(const Problem& p, const Iterate& it, Index k);
// Of that, the energy of the bonds that hold it, also as its drive stood at another time; J.
double energy_of_joint(const Problem& p, const Iterate& it, Index k);
double energy_of_joint(const Problem& p, const Iterate& it, Index k, double time);

// The same energy, and the largest distance between points of joint k that should coincide, those of what it follows with them;
// m. 0 for a spring.
struct JointResult {
  double energy, error;
};
JointResult result_of_joint(const Problem& p, const Iterate& it, Index k);

}  // namespace pabd
