// SPDX-License-Identifier: MIT
#include "sim/solver/energy_bound.h"

#include <algorithm>
#include <cmath>

#include "sim/math/levels.h"
#include "sim/math/so3.h"
#include "sim/solver/halving.h"
#include "sim/solver/joint_actions.h"
#include "sim/solver/joint_set.h"
#include "sim/solver/step_summary.h"
#include "sim/solver/turn_friction.h"

namespace pabd {
namespace {

constexpr int kBisections = 10;

// W of one joint; J.
double drive_work_of(const Problem& p, const Iterate& it, Index k) {
  if (!p.works[k]) return 0;
  const Joint& joint = p.joints[k];
  double work = action_work(p, it, k);
  if (!joint.drive && !joint.turn) return work;
  // Force on its points where the bodies stand so, times the way that the drive moves them.
  const auto along = [&](const Pose& i, const Pose& j, double force_at) {
    BondList first, last, feels;
    expand(joint, i, j, p.time - p.params->h, first);
    expand(joint, i, j, p.time, last);
    expand(joint, i, j, force_at, feels);
    double sum = 0;
    for (int b = 0; b < last.count; ++b) {
      const PointBond &from = first.bond[b], &to = last.bond[b];
      sum += evaluate(p.law_of(k), feels.bond[b]).gradient.dot((to.y_b - to.y_a) - (from.y_b - from.y_a));
    }
    return sum;
  };
  const double at_end = along(it.pose[it.slot(joint.i)], it.pose[it.slot(joint.j)], p.time);
  if (!p.second_order(joint)) return work + at_end;
  return work + 0.5 * (at_end + along(p.start_pose(joint.i), p.start_pose(joint.j), p.time - p.params->h));
}

// A motor or a drive does whatever work its motion takes.
bool drives(const Joint& joint) { return joint.drive || joint.turn || (joint.action && joint.action->motor); }

// What W of a step that a drive is part of may lack; J: a point at r of a body that turns by φ leaves the way along which
// its force is counted by ½ φ² r.
double turning_work(const Problem& p, const Iterate& it, std::span<const Index> joints,
                    const Velocities& velocities) {
  const auto works = [&](Index k) { return p.works[k] && drives(p.joints[k]); };
  if (std::none_of(joints.begin(), joints.end(), works)) return 0;
  const double h = p.params->h;
  double work = 0;
  BondList list;
  for (const Index k : joints) {
    expand_held(p, it, k, p.time, list);
    const auto [i, j] = p.joint_ends[k];
    for (int b = 0; b < list.count; ++b) {
      const PointBond& bond = list.bond[b];
      const double force = evaluate(p.law_of(k), bond).gradient.norm();
      for (const auto& [body, y] : {std::pair(i, bond.y_a), std::pair(j, bond.y_b)})
        if (p.movable(body))
          work += 0.5 * force * (y - it.pose[body].c).norm() * (h * velocities.omega[body]).squaredNorm();
    }
  }
  return work;
}

// Ψ of the points of a manifold at distances d, or −W where recovery does work, see energy_bound.h.
Lanes barrier_energy(const Barrier& barrier, const ContactManifold& manifold, Lanes d, bool solved) {
  const ContactForce f = normal_force(barrier, manifold, d);
  if (solved || !manifold.recovers) return stored_energy(barrier, manifold, f, d);
  return select(manifold.shift > 0, f.first * (d - manifold.start_d), f.value);
}

// Ψ of a manifold where the step starts, point by point: distances and slip are known there.
Lanes energy_at_start(const Problem& p, const ContactManifold& manifold, bool solved) {
  const ContactLaw law = p.law_of(manifold);
  const Lanes d = manifold.start_d;
  return barrier_energy(law.barrier, manifold, d, solved) +
         friction_energy(law, manifold.limit, length(manifold.stretch));
}

PABD_EACH_LEVEL double energy_at_end(const Problem& p, const ContactManifold& manifold, bool solved,
                                     const Iterate& it) {
  const ContactLaw law = p.law_of(manifold);
  const ContactState s = state_of(it, manifold);
  if (feels_nothing(law.barrier, manifold, s.d)) return turn_energy(law, manifold, it);
  return sum(barrier_energy(law.barrier, manifold, s.d, solved) +
             friction_energy(law, manifold.limit, length(s.u))) +
         turn_energy(law, manifold, it);
}

double contact_energies(const Problem& p, const Island& island, bool solved, const Workers& workers,
                        EnergyMemory& memory, const Iterate& it) {
  memory.energy.resize(island.manifolds.size());
  workers.for_each(island.manifolds.size(), [&](std::size_t k) {
    memory.energy[k] = energy_at_end(p, it.manifold[island.manifolds[k]], solved, it);
  });
  double sum = 0;
  for (const double energy : memory.energy) sum += energy;
  return sum;
}

// Does point k overlap where the step starts, and the last step did not know of it?
bool is_found(const ContactManifold& manifold, int k) {
  return !manifold.known[k] && manifold.start_d[k] < 0;
}

// What overlaps where the step starts: in a crowd, and, where nothing is made in halves, what the last step did not know of.
bool comes_apart(const Problem& p, const Island& island, const ContactManifold& manifold) {
  if (island.crowd) return manifold.crowded || smallest_start_d(manifold) < 0;
  if (p.is_half || may_halve(p.params->solver)) return false;
  for (int k = 0; k < manifold.count; ++k) {
    if (is_found(manifold, k)) return true;
  }
  return false;
}

void add_contacts_at_start(const Problem& p, const Island& island, bool solved, const Iterate& it,
                           EnergyBalance& out) {
  for (const Index j : island.manifolds) {
    const ContactManifold& manifold = it.manifold[j];
    const Lanes energy = energy_at_start(p, manifold, solved);
    out.stored += turn_energy_at_start(p, p.law_of(manifold), manifold, it);
    for (int k = 0; k < manifold.count; ++k) {
      out.stored += energy[k];
      if (is_found(manifold, k)) out.found += energy[k];
      if (comes_apart(p, island, manifold)) out.freed += energy[k];
    }
  }
}

// Ψ of the island's joints; drives stand where they stand at `time`.
double joint_energies(const Problem& p, const Island& island, double time, const Workers& workers,
                      EnergyMemory& memory, const Iterate& it) {
  return workers.sum(island.joints.size(), 0.0, memory.partial_sums, [&](std::size_t n) {
    const Index k = island.joints[n];
    return energy_of_joint(p, it, k, time) + spring_energy(p, it, k);
  });
}

// Ψ of the joints where the step starts.
double joint_energies_at_start(const Problem& p, const Island& island, const Workers& workers,
                               EnergyMemory& memory, Iterate& it) {
  if (island.joints.empty()) return 0;
  memory.pose.resize(p.model->shape.size());
  for (const Index i : island.bodies) {
    memory.pose[i] = it.pose[i];
    it.pose[i] = p.start_pose(i);
  }
  const double energy = joint_energies(p, island, p.time - p.params->h, workers, memory, it);
  for (const Index i : island.bodies) it.pose[i] = memory.pose[i];
  return energy;
}

// By how much U of the body is above that of the start, less the work of what acts from outside; J.
double fall(const Problem& p, Index i, const Pose& end) {
  return -p.model->mass[i] * p.params->gravity.dot(end.c - p.start->c[i]) - external_work(p, i, end);
}

// U + Ψ − W with the poses a part t of their way from `from`, above U of the start.
double stored_at_part(const Problem& p, const Island& island, const Workers& workers, double t,
                      EnergyMemory& memory, Iterate& it) {
  double energy = 0;
  for (const Index i : island.bodies) {
    const Pose &from = memory.from[i], &end = memory.pose[i];
    const Vec3 c = from.c + t * (end.c - from.c);
    set_pose(p, i, {c, exp_so3(t * log_so3(end.R * from.R.transpose())) * from.R}, it);
    energy += fall(p, i, it.pose[i]);
  }
  return energy + joint_energies(p, island, p.time, workers, memory, it) +
         contact_energies(p, island, false, workers, memory, it) -
         drive_work(p, it, island.joints, workers, memory);
}

double kinetic_at_end(const Problem& p, const Island& island, const Workers& workers,
                      const Velocities& velocities, EnergyMemory& memory, const Iterate& it) {
  return workers.sum(island.bodies.size(), 0.0, memory.partial_sums, [&](std::size_t k) {
    const Index i = island.bodies[k];
    return kinetic_energy(*p.model, i, it.pose[i].R, velocities.v[i], velocities.omega[i]);
  });
}

}  // namespace

double external_work(const Problem& p, Index i, const Pose& end) {
  if (!has_external(*p.model, i)) return 0;
  const ExternalForce& external = *p.model->external[i];
  const double from = p.time - p.params->h;
  const auto mean = [&](const Vec3& first, const Vec3& last) {
    return p.second_order(i) ? Vec3(0.5 * (first + last)) : last;
  };
  const Vec3 F = mean(external.force_at(from), external.force_at(p.time));
  const Vec3 torque = mean(external.torque_at(from), external.torque_at(p.time));
  return F.dot(end.c - p.start->c[i]) + torque.dot(turn_between(p.start->R[i], end.R));
}

double drive_work(const Problem& p, const Iterate& it, std::span<const Index> joints, const Workers& workers,
                  EnergyMemory& memory) {
  return workers.sum(joints.size(), 0.0, memory.partial_sums,
                     [&](std::size_t k) { return drive_work_of(p, it, joints[k]); });
}

bool gains(const EnergyBalance& energy, double share, double residual) {
  return energy.rise + energy.found >
         share * (energy.kinetic + energy.stored) + 100 * residual * energy.stored;
}

bool gains_in_all(const EnergyBalance& energy, double before) {
  constexpr double kRiseInAll = 1e-3;
  return before + energy.rise > kRiseInAll * (energy.kinetic + energy.stored);
}

EnergyBalance energy_balance(const Problem& p, const Island& island, bool solved, const Workers& workers,
                             const Velocities& velocities, EnergyMemory& memory, Iterate& it) {
  const Model& model = *p.model;
  EnergyBalance out;
  const Vec3 sums =
      workers.sum(island.bodies.size(), Vec3(Vec3::Zero()), memory.partial_vectors, [&](std::size_t k) {
        const Index i = island.bodies[k];
        const double start = kinetic_energy(model, i, p.start->R[i], p.start->v[i], p.start->omega[i]);
        const double flight = has_external(model, i) ? start
                                                     : kinetic_energy(model, i, p.flight->star[i].R,
                                                                      p.start->v[i], p.flight->omega[i]);
        return Vec3(start, flight, fall(p, i, it.pose[i]));
      });
  out.kinetic = sums[0];
  const double flight = sums[1], fell = sums[2];
  const double kinetic = kinetic_at_end(p, island, workers, velocities, memory, it);
  out.sped_up = kinetic - out.kinetic;
  if (!p.second_order(island.bodies.front())) out.kinetic = std::max(out.kinetic, flight);
  out.stored = joint_energies_at_start(p, island, workers, memory, it);
  add_contacts_at_start(p, island, solved, it, out);
  out.rise = kinetic + fell + joint_energies(p, island, p.time, workers, memory, it) +
             contact_energies(p, island, solved, workers, memory, it) -
             drive_work(p, it, island.joints, workers, memory) - out.kinetic - out.stored;
  if (solved) out.rise -= turning_work(p, it, island.joints, velocities);
  for (std::size_t k = 0; k < island.manifolds.size(); ++k)
    if (comes_apart(p, island, it.manifold[island.manifolds[k]])) out.freed -= memory.energy[k];
  return out;
}

void bound_energy(const Problem& p, const Island& island, const Workers& workers,
                  const EnergyBalance& balance, bool unsolved, FreeGroups& groups, EnergyMemory& memory,
                  Velocities& velocities, Iterate& it) {
  double moving = 0;
  for (const Index i : island.bodies) {
    const auto [v, omega] = inner_motion(groups, i, it.pose[i].c, velocities);
    moving += kinetic_energy(*p.model, i, it.pose[i].R, v, omega);
  }
  const auto keep_inner = [&](double part) {
    for (const Index i : island.bodies) {
      const auto [v, omega] = inner_motion(groups, i, it.pose[i].c, velocities);
      velocities.v[i] -= (1 - part) * v;
      velocities.omega[i] -= (1 - part) * omega;
    }
  };
  keep_inner(moving > 0 ? std::sqrt(std::max(0.0, moving - balance.excess()) / moving) : 0);
  if (balance.rise <= moving || !unsolved) return;
  memory.pose.resize(p.model->shape.size());
  memory.from.resize(p.model->shape.size());
  for (const Index i : island.bodies) memory.pose[i] = it.pose[i];
  rigidly_moved(p, island, groups, memory.from);
  const double most =
      balance.kinetic + balance.stored - kinetic_at_end(p, island, workers, velocities, memory, it);
  double low = 0, high = 1;
  for (int k = 0; k < kBisections; ++k) {
    const double t = 0.5 * (low + high);
    (stored_at_part(p, island, workers, t, memory, it) <= most ? low : high) = t;
  }
  stored_at_part(p, island, workers, low, memory, it);
  find_rigid_motions(p, it, groups);  // of the new places
  keep_inner(0);
}

}  // namespace pabd
