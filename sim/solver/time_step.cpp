// SPDX-License-Identifier: MIT
// One time step, in the order of the algorithm.

#include "sim/solver/time_step.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <limits>

#include "sim/math/flush_denormals.h"
#include "sim/solver/body_reports.h"
#include "sim/solver/coloring.h"
#include "sim/solver/contact_setup.h"
#include "sim/solver/energy_bound.h"
#include "sim/solver/friction.h"
#include "sim/solver/joint_actions.h"
#include "sim/solver/joint_reports.h"
#include "sim/solver/joint_set.h"
#include "sim/solver/momentum.h"
#include "sim/solver/recovery.h"
#include "sim/solver/runaway.h"
#include "sim/solver/solve.h"
#include "sim/solver/step_memory.h"
#include "sim/solver/step_summary.h"
#include "sim/solver/stiffness_cap.h"

namespace pabd {
namespace {

class Stopwatch {
 public:
  // Time since the last call; ms.
  double lap() {
    const auto now = Clock::now();
    const double ms = std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
    return ms;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
};

// Of all bodies.
bool all_finite(const std::vector<Pose>& pose, const std::vector<Vec3>& v, const std::vector<Vec3>& omega) {
  double sum = 0;
  for (std::size_t i = 0; i < v.size(); ++i)
    sum += 0.0 * (pose[i].c.sum() + pose[i].R.sum() + v[i].sum() + omega[i].sum());
  return sum == 0;  // 0 · x is NaN for an infinite or undefined x
}

// The log barrier has no force for a pair that overlaps: such a start is reported, not solved.
bool is_feasible(const Problem& p, const Iterate& it) {
  if (!is_feasible_only(p.law.barrier.kind)) return true;
  for (const ContactManifold& manifold : it.manifold) {
    const ContactState s = state_of(it, manifold);
    for (int k = 0; k < manifold.count; ++k) {
      if (!(s.d[k] > 0)) return false;
    }
  }
  return true;
}

// Bonds of the step S(17), which bodies hang together, friction from the last step, the first iterate, and
// who solves which island.
void build(const StepOptions& options, const Workers& workers, StepMemory& m, StepReport& report) {
  Problem& p = m.problem;
  start_recovery(p, m.iterate);
  pulls_as_joints(*p.model, options.pulls, m.pulls);
  p.joints = {p.model->joints, m.pulls};
  if (list_bonds(p, m.iterate, m.graph)) {
    split_into_islands(p, m.iterate, m.islands);
    color_bodies(p, m.islands);
  }
  first_iterate(p, m.iterate);
  report.capped_bonds = cap_stiffness(p, m.iterate);
  start_actions(p, m.iterate);
  start_friction(p, workers, m.iterate);
  choose_solvers(p, m.iterate, m.islands, m.solvers.newton);
}

// Velocities that follow from the poses; the momentum of what feels no external force is kept.
void find_motion(const Problem& p, StepMemory& m) {
  find_free_groups(p, m.islands, m.iterate, m.groups);
  balance_poses(p, m.groups, m.iterate);
  find_velocities(p, m.islands, m.iterate, m.velocities);
  balance_velocities(p, m.iterate, m.groups, m.velocities);
}

// Islands of `sissm`, and jointed ones whose solve ended too early, go a part of their way where they would
// gain energy.
void bound_energy(const Problem& p, StepMemory& m, StepReport& report) {
  const bool all = bounds_energy(p.params->solver);
  for (std::size_t k = 0; k < m.islands.list.size(); ++k) {
    const Island& island = m.islands.list[k];
    const IslandReport& outcome = report.islands[k];
    // Who asks for one iteration wants what that gives.
    const bool early = island.jointed && outcome.solver == SolverMethod::newton &&
                       outcome.status == StepStatus::iteration_limit && p.params->solver.iterations > 1;
    if (!all && !early) continue;
    const EnergyBound bound = all ? EnergyBound::total : EnergyBound::kinetic;
    const int held = bound_energy(p, island, bound, m.scratch, m.iterate, m.velocities);
    if (held > 0) unbalance(island, m.groups);
    report.held_bodies += held;
  }
  if (report.held_bodies == 0) return;
  report.status = StepStatus::iteration_limit;
  balance_velocities(p, m.iterate, m.groups, m.velocities);
}

void take_over(const Problem& p, StepMemory& m, const StepReport& report, State& state) {
  finish_recovery(p, m.iterate);
  for (std::size_t i = 0; i < state.c.size(); ++i) {
    state.c[i] = m.iterate.pose[i].c;
    state.R[i] = m.iterate.pose[i].R;
  }
  // Not swapped: who looks at an array sees it go on.
  std::copy(m.velocities.v.begin(), m.velocities.v.end(), state.v.begin());
  std::copy(m.velocities.omega.begin(), m.velocities.omega.end(), state.omega.begin());
  store_friction(p, m.iterate, state.contacts);
  state.joint_force.swap(m.iterate.joint_force);
  state.step = report.step;
  state.time = report.time;
}

void summarize(const Problem& p, const StepMemory& m, const StepOptions& options, const State& end,
               StepReport& report) {
  summarize_contacts(p, m.iterate, options.report_contacts, report);
  for (std::size_t k = 0; k < p.joints.size(); ++k)
    report.elastic += energy_of_joint(p, m.iterate, static_cast<Index>(k));
  report.elastic += spring_energy(*p.model, end);
  report.drive_work = drive_work(p, m.iterate);
  report.max_joint_error = largest_joint_error(p, m.iterate);
  if (options.report_joints) report_joints(p, m.iterate, end.joint_force, report.joint_reports);
  if (options.report_bodies)
    report_bodies(p, m.islands, report.islands, m.iterate, m.solvers.sissm, report.body_reports);
  report.kinetic = kinetic_energy(*p.model, end);
  report.potential = potential_energy(*p.model, *p.params, end);
}

// The step was not made: what it would have ended with is not known.
void fail(StepReport& report) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  report.status = StepStatus::non_finite;
  if (report.iterations == 0) report.residual = kUnknown;
  for (double* quantity : {&report.kinetic, &report.potential, &report.elastic, &report.max_penetration,
                           &report.min_gap, &report.max_joint_error})
    *quantity = kUnknown;
}

// Everything but the memory of its vectors.
void clear(StepReport& report) {
  StepReport fresh;
  const auto keep = [](auto& from, auto& to) {
    to = std::move(from);
    to.clear();
  };
  keep(report.islands, fresh.islands);
  keep(report.records, fresh.records);
  keep(report.contact_reports, fresh.contact_reports);
  keep(report.body_reports, fresh.body_reports);
  keep(report.joint_reports, fresh.joint_reports);
  report = std::move(fresh);
}

void make_step(const StepOptions& options, StepMemory& m, State& state, StepReport& report) {
  const Workers workers{m.detection.collision.team, options.threads, {&options.stop}};
  Problem& p = m.problem;
  const auto interrupted = [&] {
    if (workers.stop.requested()) report.status = StepStatus::interrupted;
    return report.status == StepStatus::interrupted;
  };
  Stopwatch watch;

  fly(*p.model, *p.params, state, workers, m.flight);  // 1. free flight: Q*
  if (!all_finite(m.flight.star, m.flight.v, m.flight.omega)) return fail(report);
  report.times.set_up = watch.lap();
  find_contacts(p, workers, m.detection, m.iterate);  // 2. bonds of this step, S(17)
  report.times.detect = watch.lap();
  if (interrupted()) return;
  build(options, workers, m, report);
  report.times.set_up += watch.lap();

  const bool feasible = is_feasible(p, m.iterate);
  if (feasible)  // 3. minimise E
    solve_islands(p, m.islands, workers, options.record_iterations, m.solvers, m.iterate, report);
  report.times.solve = watch.lap();
  if (report.status == StepStatus::interrupted) return;

  find_motion(p, m);  // 4. velocities
  if (!feasible || report.status == StepStatus::non_finite ||
      !all_finite(m.iterate.pose, m.velocities.v, m.velocities.omega) ||
      ran_away(p, m.islands, m.velocities, m.scratch, m.iterate))
    return fail(report);
  bound_energy(p, m, report);
  take_over(p, m, report, state);
  summarize(p, m, options, state, report);
  report.times.velocities = watch.lap();
}

}  // namespace

void step(const Model& model, const Params& params, const StepOptions& options, State& state,
          StepWorkspace& workspace, StepReport& report) {
  // Numbers that are none make a step that says so.
  assert(state.size() == model.size() && state.R.size() == state.c.size() &&
         state.v.size() == state.c.size() && state.omega.size() == state.c.size());
  assert(std::all_of(options.pulls.begin(), options.pulls.end(),
                     [&](const Pull& pull) { return pull.body >= 0 && pull.body < model.size(); }));
  const FlushDenormals flush;
  Stopwatch watch;
  clear(report);
  report.step = state.step + 1;
  report.time = state.time + params.h;
  report.method =
      params.solver.method == SolverMethod::automatic ? SolverMethod::descent : params.solver.method;
  StepMemory& m = workspace.memory();
  Problem& p = m.problem;
  p.model = &model;
  p.params = &params;
  p.start = &state;
  p.flight = &m.flight;
  p.time = report.time;
  p.law = contact_law(model, params);
  p.friction = has_friction(model, params.contact);
  report.kappa = p.law.barrier.kappa;
  make_step(options, m, state, report);
  report.left_pairs = m.detection.collision.left_pairs;
  report.times.total = watch.lap();
}

const char* to_string(StepStatus status) {
  switch (status) {
    case StepStatus::converged:
      return "converged";
    case StepStatus::iteration_limit:
      return "iteration_limit";
    case StepStatus::non_finite:
      return "non_finite";
    case StepStatus::interrupted:
      return "interrupted";
  }
  return "?";
}

StepWorkspace::StepWorkspace() : memory_(std::make_unique<StepMemory>()) {}
StepWorkspace::~StepWorkspace() = default;
StepWorkspace::StepWorkspace(StepWorkspace&&) noexcept = default;
StepWorkspace& StepWorkspace::operator=(StepWorkspace&&) noexcept = default;

}  // namespace pabd
