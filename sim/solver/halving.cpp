// SPDX-License-Identifier: MIT
#include "sim/solver/halving.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "sim/solver/friction.h"
#include "sim/solver/runaway.h"
#include "sim/solver/step_memory.h"

namespace pabd {

bool may_halve(const SolverParams& solver) {
  return solver.halvings > 0 && solver.iterations > 1 && solver.method != SolverMethod::sissm;
}

bool is_far_from_solved(const IslandReport& island) {
  return island.status == StepStatus::non_finite || !(island.residual <= kUnsolved);
}

bool ends_unsolved(const IslandReport& island, const EnergyBalance& energy) {
  if (is_far_from_solved(island)) return true;
  if (!(island.friction_error <= kUnsettled)) return true;
  return gains(energy, island.solver == SolverMethod::newton ? kRise : kRiseInSweeps, island.residual);
}

namespace {

// Of a step of second order; empty: it is judged as any other.
std::optional<Verdict> judge_motion(const Problem& p, std::size_t k, const IslandReport& outcome,
                                    StepMemory& m) {
  const Island& island = m.islands.list[k];
  EnergyBalance& energy = m.balance[k];
  double& gained = m.second_order.gained[k];
  const double before = gained_before(p, island.bodies.front());
  gained = before + energy.rise;
  const bool second_order = p.second_order(island.bodies.front());
  // Euler's velocities are those of the middle of a step: T is off by about half of what it changes by.
  if (!second_order && before == 0) gained -= std::abs(energy.sped_up);
  if (!second_order || is_far_from_solved(outcome)) return {};
  if (!gains_in_all(energy, before)) {
    energy = {};
    return Verdict::stays;
  }
  if (may_halve(p.params->solver)) {
    gained = before;  // at most
    return Verdict::again;
  }
  energy.rise = std::exchange(gained, 0);
  return Verdict::stays;
}

}  // namespace

Verdict judge_island(const Problem& p, std::size_t k, const Workers& workers, StepMemory& m,
                     IslandReport& outcome) {
  const Island& island = m.islands.list[k];
  const bool halves = may_halve(p.params->solver);
  if (outcome.status == StepStatus::non_finite ||
      ran_away(p, island, workers, m.velocities, m.energy, m.iterate)) {
    outcome.status = StepStatus::non_finite;
    return halves ? Verdict::again : Verdict::fails;
  }
  if (outcome.rests()) {
    if (remembers(p)) m.second_order.gained[k] = gained_before(p, island.bodies.front());
    return Verdict::stays;
  }
  if (remembers(p) && halves && ends_broken_in(p, island, m.iterate)) {
    m.second_order.gained[k] = gained_before(p, island.bodies.front());  // at most
    return Verdict::again;
  }
  if (p.params->solver.projection != Projection::polar) {
    const bool solved = outcome.status == StepStatus::converged;
    m.balance[k] = energy_balance(p, island, solved, workers, m.velocities, m.energy, m.iterate);
    if (remembers(p))
      if (const auto verdict = judge_motion(p, k, outcome, m)) return *verdict;
  }
  if (outcome.status == StepStatus::iteration_limit && p.friction)
    outcome.friction_error = largest_friction_error(p, island, m.iterate, 1);
  // Halves of a crowd end no better: other pairs are skipped in each.
  if (island.crowd || !halves) return Verdict::stays;
  const bool reserve = p.is_half && p.params->solver.halvings <= kReserve;
  const bool unsolved = reserve ? is_far_from_solved(outcome) : ends_unsolved(outcome, m.balance[k]);
  return unsolved ? Verdict::again : Verdict::stays;
}

Params of_half(const Params& whole, double kappa) {
  Params half = whole;
  half.h *= 0.5;
  if (--half.solver.halvings == 0) half.solver.iterations *= kLastChance;
  half.contact.kappa = kappa;
  return half;
}

StepSummary both(const StepSummary& first, const StepSummary& second) {
  StepSummary out = second;
  out.status = std::max(second.status, first.status);
  out.iterations = std::max(second.iterations, first.iterations);
  out.residual = std::max(second.residual, first.residual);
  out.drive_work += first.drive_work;
  out.too_dense = std::max(second.too_dense, first.too_dense);
  out.left_pairs = std::max(second.left_pairs, first.left_pairs);
  out.capped_bonds = std::max(second.capped_bonds, first.capped_bonds);
  out.held_bodies = std::max(second.held_bodies, first.held_bodies);
  out.halvings = std::max(second.halvings, first.halvings);
  out.times += first.times;
  return out;
}

void Halves::take(const Problem& p, const std::vector<std::uint8_t>& chosen) {
  take_bodies(*p.model, chosen, part_);
  take_part(part_, *p.start, state_);
}

const StepReport& Halves::make(const Problem& p, const StepOptions& options, Team& team) {
  params_ = of_half(*p.params, p.law.barrier.kappa);
  options_ = options;
  options_.record_iterations = false;
  options_.is_half = true;
  options_.pulls.clear();
  for (Pull pull : options.pulls) {
    if (!part_.holds(pull.body)) continue;
    pull.body = part_.place[pull.body];
    options_.pulls.push_back(pull);
  }
  Team& own = workspace_.memory().detection.collision.team;
  std::swap(own, team);
  const auto half = [&](StepReport& report) {
    step(part_.model, params_, options_, state_, workspace_, report);
    return report.status == StepStatus::converged || report.status == StepStatus::iteration_limit;
  };
  if (half(both_)) {
    half(half_);
    const StepSummary first = both_;
    both_ = half_;
    static_cast<StepSummary&>(both_) = both(first, half_);
  }
  std::swap(own, team);
  return both_;
}

void Halves::place(std::vector<Pose>& pose) const {
  for (std::size_t k = 0; k < part_.bodies.size(); ++k) {
    if (!part_.model.fixed[k]) pose[part_.bodies[k]] = {state_.c[k], state_.R[k]};
  }
}

void Halves::put(const Islands& islands, State& state, StepReport& report) const {
  put_part(part_, state_, state);
  // Its islands are parts of those that are there already, and what it skipped is counted already.
  const std::size_t whole = report.islands.size();
  const StepSummary counted = report.summary();
  add_report(part_, both_, report);
  report.left_pairs = std::max(counted.left_pairs, both_.left_pairs);
  report.too_dense = std::max(counted.too_dense, both_.too_dense);
  report.capped_bonds = std::max(counted.capped_bonds, both_.capped_bonds);
  const auto is_ours = [&](const Island& island) { return part_.holds(island.bodies.front()); };
  const auto ours = std::find_if(islands.list.begin(), islands.list.end(), is_ours) - islands.list.begin();
  for (std::size_t k = whole; k < report.islands.size(); ++k) {
    const IslandReport& half = report.islands[k];
    const Index of = islands.of[half.first_body];  // its lowest body may have had no bond before
    IslandReport& island = report.islands[of < 0 ? ours : of];
    island.solver = half.solver;
    island.status = std::max(island.status, half.status);
    island.iterations = std::max(island.iterations, half.iterations);
    island.residual = std::max(island.residual, half.residual);
  }
  report.islands.resize(whole);
  Index movable = 0;
  for (const std::uint8_t fixed : part_.model.fixed) movable += fixed ? 0 : 1;
  report.halved_bodies = movable;
  report.halvings = 1 + both_.halvings;
  for (std::size_t k = 0; k < both_.body_reports.size(); ++k) {
    BodyReport& body = report.body_reports[part_.bodies[k]];
    const BodyReport& half = both_.body_reports[k];
    if (part_.model.fixed[k]) {  // of every part
      body.contacts += half.contacts;
      body.contact_energy += half.contact_energy;
      continue;
    }
    const Index island = std::exchange(body, half).island;
    body.island = island;
  }
  for (std::size_t k = 0; k < both_.joint_reports.size(); ++k)
    report.joint_reports[part_.joints[k]] = both_.joint_reports[k];
}

}  // namespace pabd
