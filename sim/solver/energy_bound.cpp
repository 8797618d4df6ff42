// SPDX-License-Identifier: MIT
#include "sim/solver/energy_bound.h"

#include <algorithm>

#include "sim/math/so3.h"
#include "sim/solver/joint_actions.h"
#include "sim/solver/joint_set.h"
#include "sim/solver/step_summary.h"

namespace pabd {
namespace {

constexpr int kBisections = 10;
constexpr double kRounding = 1e-9;  // of H that is no gain

// W of one joint; J.
double drive_work_of(const Problem& p, const Iterate& it, Index k) {
  const Joint& joint = p.joints[k];
  double work = action_work(p, it, k);
  if (!joint.drive && !joint.turn) return work;
  BondList first, last;
  expand_held(p, it, k, p.time - p.params->h, first);
  expand_held(p, it, k, p.time, last);
  for (int b = 0; b < last.count; ++b) {
    const PointBond &from = first.bond[b], &to = last.bond[b];
    work += evaluate(p.law_of(k), to).gradient.dot((to.y_b - to.y_a) - (from.y_b - from.y_a));
  }
  return work;
}

// Of the stretch that a bond between i and j may close in a step: ½ μ (s/h)²; J.
double closing_energy(const Problem& p, Index i, Index j, double s) {
  const auto inverse_mass = [&](Index k) { return p.movable(k) ? 1 / p.model->mass[k] : 0.0; };
  const double speed = s / p.params->h;
  return 0.5 * speed * speed / (inverse_mass(i) + inverse_mass(j));
}

// What the bonds of a manifold, of a joint, hold at the iterate and can give back in a step; J.
double given_back(const Problem& p, const Iterate& it, const ContactManifold& manifold) {
  const ContactState s = state_of(it, manifold);
  const Lanes energy = contact_energy(p.law_of(manifold), manifold, s);
  double sum = 0;
  for (int k = 0; k < manifold.count; ++k) {
    const double stretch = std::clamp(p.law.barrier.d_hat - s.d[k], 0.0, p.law.barrier.d_hat);
    sum += std::min(energy[k], closing_energy(p, manifold.a, manifold.b, stretch));
  }
  return sum;
}
double given_back(const Problem& p, const Iterate& it, Index k) {
  BondList list;
  expand_held(p, it, k, p.time - p.params->h, list);
  const Joint& joint = p.joints[k];
  double sum = 0;
  for (int b = 0; b < list.count; ++b) {
    const PointBondForce f = evaluate(p.law_of(k), list.bond[b]);
    sum += std::min(f.energy, closing_energy(p, joint.i, joint.j, f.stretch));
  }
  return sum;
}

double contact_energies(const Problem& p, const Island& island, const Iterate& it) {
  double energy = 0;
  for (const Index k : island.manifolds)
    energy += sum(contact_energy(p.law_of(it.manifold[k]), it.manifold[k], state_of(it, it.manifold[k])));
  return energy;
}

// What the island may have at the end but for the work of gravity and drives; drives stand where they stood.
// Leaves it at its start.
double energy_at_start(const Problem& p, const Island& island, EnergyBound bound, Iterate& it) {
  double energy = 0;
  for (const Index i : island.bodies) {
    it.pose[i] = p.start_pose(i);
    energy += kinetic_energy(*p.model, i, p.start->R[i], p.start->v[i], p.start->omega[i]);
  }
  for (const Index k : island.joints) energy += spring_energy(p, it, k);
  if (bound == EnergyBound::kinetic) {
    for (const Index k : island.manifolds) energy += given_back(p, it, it.manifold[k]);
    for (const Index k : island.joints) energy += given_back(p, it, k);
    return energy;
  }
  energy += contact_energies(p, island, it);
  for (const Index k : island.joints) energy += energy_of_joint(p, it, k, p.time - p.params->h);
  return energy;
}

// Puts the island at the part t of its way to `end`; returns what it has there less the work of gravity and
// drives.
double energy_at_part(const Problem& p, const Island& island, EnergyBound bound, double t,
                      const std::vector<Pose>& end, const Velocities& velocities, Iterate& it) {
  double energy = 0;
  for (const Index i : island.bodies) {
    const Pose start = p.start_pose(i);
    Pose& pose = it.pose[i];
    pose = end[i];
    if (t < 1) {
      pose.c = start.c + t * (end[i].c - start.c);
      pose.R = exp_so3(t * log_so3(end[i].R * start.R.transpose())) * start.R;
    }
    energy += t * t * kinetic_energy(*p.model, i, end[i].R, velocities.v[i], velocities.omega[i]) -
              p.model->mass[i] * p.params->gravity.dot(pose.c - start.c);
  }
  for (const Index k : island.joints) energy += spring_energy(p, it, k) - drive_work_of(p, it, k);
  if (bound == EnergyBound::kinetic) return energy;
  energy += contact_energies(p, island, it);
  for (const Index k : island.joints) energy += energy_of_joint(p, it, k);
  return energy;
}

}  // namespace

double drive_work(const Problem& p, const Iterate& it) {
  double work = 0;
  for (std::size_t k = 0; k < p.joints.size(); ++k) work += drive_work_of(p, it, static_cast<Index>(k));
  return work;
}

int bound_energy(const Problem& p, const Island& island, EnergyBound bound, std::vector<Pose>& end,
                 Iterate& it, Velocities& velocities) {
  end.resize(p.model->shape.size());
  for (const Index i : island.bodies) end[i] = it.pose[i];
  const double budget = energy_at_start(p, island, bound, it);
  const auto gains = [&](double t) {
    return !(energy_at_part(p, island, bound, t, end, velocities, it) <= budget * (1 + kRounding));
  };
  if (!gains(1)) return 0;
  double low = 0, high = 1;
  for (int k = 0; k < kBisections; ++k) {
    const double t = 0.5 * (low + high);
    (gains(t) ? high : low) = t;
  }
  energy_at_part(p, island, bound, low, end, velocities, it);
  for (const Index i : island.bodies) {
    velocities.v[i] *= low;
    velocities.omega[i] *= low;
  }
  return static_cast<int>(island.bodies.size());
}

}  // namespace pabd
