#include "sim/solver/energy_bound.h"

#include <algorithm>

#include "sim/math/so3.h"
#include "sim/solver/islands.h"
#include "sim/solver/joint_set.h"
#include "sim/solver/step_summary.h"

namespace pabd {
namespace {

constexpr int kBisections = 10;
constexpr double kRounding = 1e-9;  // of H that is no gain

bool moves(const Model& model, Index i) { return i != kWorld && !model.fixed[i]; }

double drive_work_of(const SolveContext& s, Index k) {
  const Joint& joint = s.w.all_joints[static_cast<std::size_t>(k)];
  if (!joint.drive && !joint.turn) return 0;
  SolveContext before = s;
  before.time = s.time - s.params.h;
  BondList first, last;
  expand_at(before, k, kWorld, {}, first);
  expand_at(s, k, kWorld, {}, last);
  double work = 0;
  for (int b = 0; b < last.count; ++b) {
    const PointBond &from = first.bond[b], &to = last.bond[b];
    work += evaluate(law_of(s.w, k), to).gradient.dot((to.y_b - to.y_a) - (from.y_b - from.y_a));
  }
  return work;
}

// Calls add(body, energy) for every bond at the current iterate, `body` being one of its movable ends.
template <class Add>
void each_bond_energy(const SolveContext& s, const Add& add) {
  for (const ContactPatch& patch : s.w.patches)
    add(moves(s.model, patch.a) ? patch.a : patch.b,
        sum(contact_energy(law_of(s.w, patch), patch, state_of(s.w, patch))));
  for (std::size_t k = 0; k < s.w.all_joints.size(); ++k) {
    const Joint& joint = s.w.all_joints[k];
    if (!moves(s.model, joint.i) && !moves(s.model, joint.j)) continue;
    add(moves(s.model, joint.i) ? joint.i : joint.j, energy_of_joint(s, static_cast<Index>(k)));
  }
}

// H at the start of the step, with its bonds; drives stand where they stood. Leaves the iterate at the start.
void sum_start(const SolveContext& s, const State& start, EnergyBound& e) {
  StepWorkspace::Impl& w = s.w;
  for (const Index i : w.solved) {
    w.pose[i] = {start.c[i], start.R[i]};
    e.budget[root(w.parent, i)] += kinetic_energy(s.model, i, start.R[i], start.v[i], start.omega[i]);
  }
  SolveContext before = s;
  before.time = s.time - s.params.h;
  each_bond_energy(before, [&](Index i, double energy) { e.budget[root(w.parent, i)] += energy; });
}

// Puts every island at its part of the way, and sums H − W there.
void sum_at_part(const SolveContext& s, const State& start, EnergyBound& e) {
  StepWorkspace::Impl& w = s.w;
  e.energy.assign(e.budget.size(), 0);
  for (const Index i : w.solved) {
    const Index island = root(w.parent, i);
    const double t = e.part[island];
    const Pose& end = e.end[i];
    w.pose[i] = end;
    if (t < 1) {
      w.pose[i].c = start.c[i] + t * (end.c - start.c[i]);
      w.pose[i].R = exp_so3(t * log_so3(end.R * start.R[i].transpose())) * start.R[i];
    }
    e.energy[island] += t * t * kinetic_energy(s.model, i, end.R, w.v[i], w.omega[i]) -
                        s.model.mass[i] * s.params.gravity.dot(w.pose[i].c - start.c[i]);
  }
  each_bond_energy(s, [&](Index i, double energy) { e.energy[root(w.parent, i)] += energy; });
  for (std::size_t k = 0; k < w.all_joints.size(); ++k) {
    const Joint& joint = w.all_joints[k];
    const Index i = moves(s.model, joint.i) ? joint.i : joint.j;
    if (moves(s.model, i)) e.energy[root(w.parent, i)] -= drive_work_of(s, static_cast<Index>(k));
  }
}

bool gains(const EnergyBound& e, Index island) {
  return !(e.energy[island] <= e.budget[island] * (1 + kRounding));
}

}  // namespace

double drive_work(const SolveContext& s) {
  double work = 0;
  for (std::size_t k = 0; k < s.w.all_joints.size(); ++k) work += drive_work_of(s, static_cast<Index>(k));
  return work;
}

int bound_energy(const SolveContext& s, const State& start) {
  StepWorkspace::Impl& w = s.w;
  EnergyBound& e = w.energy_bound;
  join_islands(s.model, w);
  e.end = w.pose;
  e.budget.assign(w.v.size(), 0);
  e.part.assign(w.v.size(), 1);
  e.low.assign(w.v.size(), 0);
  e.high.assign(w.v.size(), 1);
  sum_start(s, start, e);
  sum_at_part(s, start, e);
  e.held.clear();
  for (const Index i : w.solved) {
    if (root(w.parent, i) == i && gains(e, i)) e.held.push_back(i);
  }
  if (e.held.empty()) return 0;
  for (int k = 0; k < kBisections; ++k) {
    for (const Index island : e.held) e.part[island] = 0.5 * (e.low[island] + e.high[island]);
    sum_at_part(s, start, e);
    for (const Index island : e.held) (gains(e, island) ? e.high : e.low)[island] = e.part[island];
  }
  for (const Index island : e.held) e.part[island] = e.low[island];
  sum_at_part(s, start, e);
  int held = 0;
  for (const Index i : w.solved) {
    const double t = e.part[root(w.parent, i)];
    if (t == 1) continue;
    ++held;
    w.v[i] *= t;
    w.omega[i] *= t;
  }
  return held;
}

}  // namespace pabd
