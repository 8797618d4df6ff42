#include "sim/solver/joint_set.h"

#include <algorithm>

namespace pabd {

void expand_at(const SolveContext& s, Index k, Index moved, const Pose& trial, BondList& out) {
  const Joint& joint = s.model.joints[static_cast<std::size_t>(k)];
  const auto pose = [&](Index body) -> const Pose& {
    return body == moved && body != kWorld ? trial : s.w.pose[s.w.slot(body)];
  };
  expand(joint, pose(joint.i), pose(joint.j), s.time, out);
}

double joint_energy(const SolveContext& s, Index i, const Pose& trial) {
  double energy = 0;
  BondList list;
  for (const Index k : s.w.joints_of(i)) {
    expand_at(s, k, i, trial, list);
    for (int b = 0; b < list.count; ++b) energy += evaluate(s.model.joints[k].law, list.bond[b]).energy;
  }
  return energy;
}

void add_joints(const SolveContext& s, Index i, JointSums& sums) {
  const Pose& pose = s.w.pose[i];
  BondList list;
  for (const Index k : s.w.joints_of(i)) {
    const Joint& joint = s.model.joints[k];
    expand_at(s, k, kWorld, pose, list);
    const bool is_a = joint.i == i;
    for (int b = 0; b < list.count; ++b) {
      const PointBondForce f = evaluate(joint.law, list.bond[b]);
      const Vec3 r = (is_a ? list.bond[b].y_a : list.bond[b].y_b) - pose.c;
      const Vec3 gradient = is_a ? Vec3(-f.gradient) : f.gradient;
      const Mat3 rK = skew(r) * f.weight;
      sums.energy += f.energy;
      sums.g_c += gradient;
      sums.g_w += r.cross(gradient);
      sums.H_cc += f.weight;
      sums.H_wc += rK;
      sums.H_ww -= rK * skew(r);
    }
  }
}

double energy_of_joint(const SolveContext& s, Index k) {
  BondList list;
  expand_at(s, k, kWorld, {}, list);
  double energy = 0;
  for (int b = 0; b < list.count; ++b) energy += evaluate(s.model.joints[k].law, list.bond[b]).energy;
  return energy;
}

double largest_joint_error(const SolveContext& s) {
  double largest = 0;
  BondList list;
  for (std::size_t k = 0; k < s.model.joints.size(); ++k) {
    const Joint& joint = s.model.joints[k];
    if (joint.type == JointType::distance && joint.law.potential == BondPotential::soft)
      continue;  // a spring
    expand_at(s, static_cast<Index>(k), kWorld, {}, list);
    for (int b = 0; b < list.count; ++b)
      largest = std::max(largest, evaluate(joint.law, list.bond[b]).stretch);
  }
  return largest;
}

}  // namespace pabd
