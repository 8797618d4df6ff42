#include "sim/solver/joint_set.h"

#include "sim/math/extremes.h"

namespace pabd {

void take_pulls(const Model& model, const std::vector<Pull>& pulls, StepWorkspace::Impl& w) {
  w.pulls.resize(pulls.size());
  std::size_t count = 0;
  for (const Pull& pull : pulls) {
    if (model.fixed[static_cast<std::size_t>(pull.body)]) continue;
    Joint& joint = w.pulls[count++];
    joint.type = JointType::distance;
    joint.j = pull.body;
    joint.on_i = {pull.target, Mat3::Identity()};
    joint.on_j = {pull.r, Mat3::Identity()};
    joint.law.kappa = pull.kappa;
  }
  w.pulls.resize(count);
  w.all_joints = {model.joints, w.pulls};
}

void expand_at(const SolveContext& s, Index k, Index moved, const Pose& trial, BondList& out) {
  const Joint& joint = s.w.all_joints[static_cast<std::size_t>(k)];
  const auto pose = [&](Index body) -> const Pose& {
    return body == moved && body != kWorld ? trial : s.w.pose[s.w.slot(body)];
  };
  expand(joint, pose(joint.i), pose(joint.j), s.time, out);
}

namespace {

double energy_of(const BondLaw& law, const BondList& list) {
  double energy = 0;
  for (int b = 0; b < list.count; ++b) energy += evaluate(law, list.bond[b]).energy;
  return energy;
}

}  // namespace

double joint_energy(const SolveContext& s, Index i, const Pose& trial) {
  double energy = 0;
  BondList list;
  for (const Index k : s.w.joints_of(i)) {
    expand_at(s, k, i, trial, list);
    energy += energy_of(law_of(s.w, k), list);
  }
  return energy;
}

void add_joints(const SolveContext& s, Index i, JointSums& sums) {
  each_bond_of(s, i, [&](const PointBondForce& f, const Vec3& r, Index) {
    const Mat3 rK = skew(r) * f.weight;
    sums.energy += f.energy;
    sums.g_c += f.gradient;
    sums.g_w += r.cross(f.gradient);
    sums.H_cc += f.weight;
    sums.H_wc += rK;
    sums.H_ww -= rK * skew(r);
  });
}

double energy_of_joint(const SolveContext& s, Index k) {
  BondList list;
  expand_at(s, k, kWorld, {}, list);
  return energy_of(law_of(s.w, k), list);
}

double largest_joint_error(const SolveContext& s) {
  double largest = 0;
  BondList list;
  for (std::size_t k = 0; k < s.w.all_joints.size(); ++k) {
    const Joint& joint = s.w.all_joints[k];
    if (joint.type == JointType::distance && joint.law.potential == BondPotential::soft)
      continue;  // a spring
    expand_at(s, static_cast<Index>(k), kWorld, {}, list);
    for (int b = 0; b < list.count; ++b) largest = larger(largest, evaluate(joint.law, list.bond[b]).stretch);
  }
  return largest;
}

}  // namespace pabd
