// SPDX-License-Identifier: MIT
#include "sim/solver/joint_set.h"

#include <cmath>

#include "sim/math/extremes.h"
#include "sim/solver/couplings.h"

namespace pabd {

void pulls_as_joints(const Model& model, const std::vector<Pull>& pulls, std::vector<Joint>& out) {
  out.resize(pulls.size());
  std::size_t count = 0;
  for (const Pull& pull : pulls) {
    if (model.fixed[pull.body]) continue;
    Joint& joint = out[count++];
    joint.type = JointType::distance;
    joint.j = pull.body;
    joint.on_i = {pull.target, Mat3::Identity()};
    joint.on_j = {pull.r, Mat3::Identity()};
    joint.law.kappa = pull.kappa;
  }
  out.resize(count);
}

namespace {

// `trial`: where body `moved` is in place of its iterate, null where none is. What acts along a joint is left out unless
// `acts`.
void expand_at(const Problem& p, const Iterate& it, Index k, Index moved, const Pose* trial, double time,
               bool acts, BondList& out) {
  const Joint& joint = p.joints[k];
  const auto pose = [&](Index body) -> const Pose& {
    return trial != nullptr && body == moved && body != kWorld ? *trial : it.pose[it.slot(body)];
  };
  expand(joint, pose(joint.i), pose(joint.j), time, out);
  if (!acts || p.action_at.empty() || p.action_at[k] < 0) return;
  add_action(joint, it.action[p.action_at[k]], place(joint, pose), out);
}

double energy_of(const BondLaw& law, const BondList& list) {
  double energy = 0;
  for (int b = 0; b < list.count; ++b) energy += evaluate(law, list.bond[b]).energy;
  return energy;
}

}  // namespace

void expand_at(const Problem& p, const Iterate& it, Index k, BondList& out) {
  expand_at(p, it, k, kWorld, nullptr, p.time, true, out);
}
void expand_at(const Problem& p, const Iterate& it, Index k, Index moved, const Pose& trial, BondList& out) {
  expand_at(p, it, k, moved, &trial, p.time, true, out);
}
void expand_held(const Problem& p, const Iterate& it, Index k, double time, BondList& out) {
  expand_at(p, it, k, kWorld, nullptr, time, false, out);
}

double joint_energy(const Problem& p, const Iterate& it, Index i, const Pose& trial) {
  double energy = 0;
  BondList list;
  for (const Index k : p.joints_at[i]) {
    expand_at(p, it, k, i, trial, list);
    energy += energy_of(p.law_of(k), list);
  }
  return energy;
}

void add_joints(const Problem& p, const Iterate& it, Index i, JointSums& sums) {
  each_bond_of(p, it, i, [&](const PointBondForce& f, const Vec3& r, Index) {
    const Mat3 rK = skew(r) * f.weight;
    sums.energy += f.energy;
    sums.g_c += f.gradient;
    sums.g_w += r.cross(f.gradient);
    sums.H_cc += f.weight;
    sums.H_wc += rK;
    sums.H_ww -= rK * skew(r);
  });
}

namespace {

double coupling_energy_of_joint(const Problem& p, const Iterate& it, Index k) {
  const Index n = coupling_of(p, k);
  return n < 0 ? 0 : coupling_energy(p, it, n);
}

}  // namespace

double potential_of_joint(const Problem& p, const Iterate& it, Index k) {
  BondList list;
  expand_at(p, it, k, list);
  return energy_of(p.law_of(k), list) + coupling_energy_of_joint(p, it, k);
}
double energy_of_joint(const Problem& p, const Iterate& it, Index k) {
  return energy_of_joint(p, it, k, p.time);
}
double energy_of_joint(const Problem& p, const Iterate& it, Index k, double time) {
  BondList list;
  expand_held(p, it, k, time, list);
  return energy_of(p.law_of(k), list) + coupling_energy_of_joint(p, it, k);
}

namespace {

// The largest of its bonds, which are `list`; m.
double error_of(const Problem& p, const Iterate& it, Index k, const BondList& list) {
  const Joint& joint = p.joints[k];
  if (traits_of(joint.type).points && joint.law.potential == BondPotential::soft) return 0;  // a spring
  double largest = 0;
  for (int b = 0; b < list.count; ++b) largest = larger(largest, evaluate(joint.law, list.bond[b]).stretch);
  if (const Index n = coupling_of(p, k); n >= 0) {
    const double error = std::abs(coupling_error(p, it, n));
    largest =
        larger(largest, coupled_measure(joint)->of == JointMeasure::Of::angle ? joint.arm * error : error);
  }
  return largest;
}

}  // namespace

JointResult result_of_joint(const Problem& p, const Iterate& it, Index k) {
  BondList list;
  expand_held(p, it, k, p.time, list);
  return {energy_of(p.law_of(k), list) + coupling_energy_of_joint(p, it, k), error_of(p, it, k, list)};
}

}  // namespace pabd
