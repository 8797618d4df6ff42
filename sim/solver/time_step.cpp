// SPDX-License-Identifier: MIT
// One time step, in the order of the algorithm.

#include "sim/solver/time_step.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "sim/math/extremes.h"
#include "sim/math/flush_denormals.h"
#include "sim/solver/contact_setup.h"
#include "sim/solver/couplings.h"
#include "sim/solver/energy_bound.h"
#include "sim/solver/friction.h"
#include "sim/solver/halving.h"
#include "sim/solver/joint_actions.h"
#include "sim/solver/joint_set.h"
#include "sim/solver/late_contacts.h"
#include "sim/solver/momentum.h"
#include "sim/solver/recovery.h"
#include "sim/solver/restitution.h"
#include "sim/solver/sissm.h"
#include "sim/solver/solve.h"
#include "sim/solver/step_memory.h"
#include "sim/solver/step_numbers.h"
#include "sim/solver/step_summary.h"

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
  release_parting_contacts(p, m.iterate);
  start_recovery(p, m.iterate);
  damp_contacts(p, m.iterate);
  pulls_as_joints(*p.model, options.pulls, m.pulls);
  p.joints = {p.model->joints, m.pulls};
  if (list_bonds(p, m.iterate, m.graph)) find_islands(p, m.iterate, m.islands);
  if (remembers(p)) predict(p, m.islands, m.iterate, m.flight, m.second_order);
  first_iterate(p, m.iterate);
  report.capped_bonds = cap_stiffness(p, m.iterate);
  start_actions(p, m.iterate);
  start_couplings(p, m.iterate);
  start_friction(p, workers, m.iterate);
  choose_solvers(p, m.iterate, m.islands, m.solvers.newton);
}

// Velocities that follow from the poses; the momentum of what feels no external force is kept.
void find_motion(const Problem& p, const Workers& workers, StepMemory& m) {
  find_free_groups(p, m.islands, m.iterate, m.groups);
  balance_poses(p, m.groups, m.iterate);
  find_velocities(p, m.islands, workers, m.iterate, m.velocities);
  balance_velocities(p, m.iterate, m.groups, m.velocities);
  if (has_second_order(p.params->solver)) let_fly(p, m.iterate, m.velocities);
}

// Which islands are to be made again. False where one is beyond help.
bool judge(const Problem& p, const Workers& workers, StepMemory& m, StepReport& report) {
  m.again.assign(p.model->shape.size(), 0);
  m.balance.assign(m.islands.list.size(), {});
  if (remembers(p)) m.second_order.gained.assign(m.islands.list.size(), 0);
  for (std::size_t k = 0; k < m.islands.list.size(); ++k) {
    const Verdict verdict = judge_island(p, k, workers, m, report.islands[k]);
    if (verdict == Verdict::fails) return false;
    if (verdict == Verdict::stays) continue;
    for (const Index i : m.islands.list[k].bodies) m.again[i] = 1;
  }
  return true;
}

bool is_made_again(const Island& island, const StepMemory& m) { return m.again[island.bodies.front()] != 0; }

// What gained energy is slowed down. Reported is what more halves would not have taken either.
void bound_energy(const Problem& p, const Workers& workers, StepMemory& m, StepReport& report) {
  constexpr double kRounding = 1e-9;
  bool found_motions = false;
  for (std::size_t k = 0; k < m.islands.list.size(); ++k) {
    const Island& island = m.islands.list[k];
    const EnergyBalance& energy = m.balance[k];
    if (is_made_again(island, m) || !(energy.excess() > kRounding * (energy.kinetic + energy.stored)))
      continue;
    if (!std::exchange(found_motions, true)) find_rigid_motions(p, m.iterate, m.groups);
    const bool unsolved = ends_unsolved(report.islands[k], energy);
    bound_energy(p, island, workers, energy, unsolved, m.groups, m.energy, m.velocities, m.iterate);
    if (!unsolved) continue;
    report.held_bodies += static_cast<int>(island.bodies.size());
    report.islands[k].status = report.status = StepStatus::iteration_limit;
  }
}

// The bonds of islands that are made again are no part of this step.
void drop_bonds_made_again(const Problem& p, StepMemory& m) {
  const auto again = [&](Index i) { return p.movable(i) && m.again[i]; };
  std::erase_if(m.iterate.manifold,
                [&](const ContactManifold& manifold) { return again(manifold.a) || again(manifold.b); });
}

void take_over(const Problem& p, StepMemory& m, State& state) {
  if (remembers(p)) {
    remember(p, m.islands, m.second_order, m.again, m.iterate, m.velocities, state.change);
  } else {
    state.change.clear();
  }
  finish_recovery(p, m.iterate);
  for (std::size_t i = 0; i < state.c.size(); ++i) {
    state.c[i] = m.iterate.pose[i].c;
    state.R[i] = m.iterate.pose[i].R;
  }
  // copy, not swap: callers hold views of these arrays
  std::copy(m.velocities.v.begin(), m.velocities.v.end(), state.v.begin());
  std::copy(m.velocities.omega.begin(), m.velocities.omega.end(), state.omega.begin());
  store_friction(p, m.iterate, state.contacts);
  state.joint_force.swap(m.iterate.joint_force);
  state.coupling.resize(p.followers.size());
  for (std::size_t n = 0; n < state.coupling.size(); ++n)
    state.coupling[n] = coupling_error(p, m.iterate, static_cast<Index>(n));
}

// The work of drives, belts and what acts from outside on what is not made again. Precondition: the state is still that of the start.
void count_work(const Problem& p, const Workers& workers, StepMemory& m, StepReport& report) {
  m.reported_joints.clear();
  for (std::size_t k = 0; k < p.joints.size(); ++k) {
    const auto [i, j] = p.joint_ends[k];
    const Index moving = p.movable(i) ? i : j;
    if (!p.movable(moving) || !m.again[moving]) m.reported_joints.push_back(static_cast<Index>(k));
  }
  report.drive_work =
      drive_work(p, m.iterate, m.reported_joints, workers, m.energy) + surface_work(p, m.iterate);
  for (Index i = 0; i < p.model->size(); ++i)
    if (p.movable(i) && !m.again[i]) report.drive_work += external_work(p, i, m.iterate.pose[i]);
}

// Of what is not made again.
void summarize(const Problem& p, const Workers& workers, StepMemory& m, const StepOptions& options,
               const State& end, StepReport& report) {
  summarize_contacts(p, m.iterate, options.report_contacts, report);
  const JointSum joints = workers.sum(m.reported_joints.size(), JointSum{}, m.joint_sums, [&](std::size_t n) {
    const Index k = m.reported_joints[n];
    const JointResult joint = result_of_joint(p, m.iterate, k);
    return JointSum{joint.energy + spring_energy(p, m.iterate, k), joint.error};
  });
  report.elastic += joints.elastic;
  report.max_joint_error = larger(report.max_joint_error, joints.error);
  if (options.report_joints) report_joints(p, m.iterate, end.joint_force, workers, report.joint_reports);
  if (options.report_bodies)
    report_bodies(p, m.islands, report.islands, m.iterate, m.solvers.sissm, report.body_reports);
  const Vec3 energy =
      workers.sum(m.again.size(), Vec3(Vec3::Zero()), m.energy.partial_vectors, [&](std::size_t k) {
        const auto i = static_cast<Index>(k);
        if (!p.movable(i) || m.again[i]) return Vec3(Vec3::Zero());
        return Vec3(kinetic_energy(*p.model, i, end.R[i], end.v[i], end.omega[i]),
                    p.model->mass[i] * p.params->gravity.dot(end.c[i]), 0);
      });
  report.kinetic += energy[0];
  report.potential -= energy[1];
}

// The step was not made: what it would have ended with is not known.
void fail(StepReport& report) {
  report.status = StepStatus::non_finite;
  if (report.iterations == 0) report.residual = std::numeric_limits<double>::quiet_NaN();
  forget_end(report);
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

// False: they were not made, and the report says why.
bool make_again(const StepOptions& options, const Workers& workers, StepMemory& m, StepReport& report) {
  if (!m.halves) m.halves = std::make_unique<Halves>();
  do {
    m.halves->take(m.problem, m.again);
    const StepStatus status = m.halves->make(m.problem, options, m.detection.collision.team).status;
    if (status == StepStatus::non_finite) fail(report);
    if (status == StepStatus::interrupted) report.status = status;
    if (status != StepStatus::converged && status != StepStatus::iteration_limit) return false;
    m.halves->place(m.iterate.pose);
  } while (mark_what_they_hit(m.problem, m.islands, workers, m.iterate, m.detection, m.late, m.again));
  // How it ended the first time is no longer of interest.
  report.status = StepStatus::converged;
  report.iterations = 0;
  report.residual = 0;
  for (std::size_t k = 0; k < report.islands.size(); ++k) {
    IslandReport& island = report.islands[k];
    if (is_made_again(m.islands.list[k], m)) {
      island.status = StepStatus::converged;
      island.iterations = 0;
      island.residual = 0;
    }
    add_outcome(island, report);
  }
  return true;
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

  find_motion(p, workers, m);  // 4. velocities
  if (!feasible || !judge(p, workers, m, report)) return fail(report);
  if (may_halve(p.params->solver))
    mark_late_contacts(p, m.islands, report.islands, workers, m.iterate, m.detection, m.late, m.again);
  const bool halved =
      std::any_of(m.again.begin(), m.again.end(), [](std::uint8_t again) { return again != 0; });
  report.times.velocities = watch.lap();
  if (interrupted()) return;
  if (halved && !make_again(options, workers, m, report)) return;  // 5. what ended unsolved, in halves
  watch.lap();
  bound_energy(p, workers, m, report);
  for (const Island& island : m.islands.list) {  // 6. impacts that bounce
    if (!is_made_again(island, m)) bounce(p, island, m.velocities, m.iterate);
  }
  if (halved) drop_bonds_made_again(p, m);
  count_work(p, workers, m, report);
  take_over(p, m, state);
  summarize(p, workers, m, options, state, report);
  if (halved) m.halves->put(m.islands, state, report);
  state.step = report.step;
  state.time = report.time;
  report.times.velocities += watch.lap();
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
  p.is_half = options.is_half;
  p.law = contact_law(model, params);
  p.friction = has_friction(model, params.contact);
  report.kappa = p.law.barrier.kappa;
  make_step(options, m, state, report);
  report.left_pairs = std::max(report.left_pairs, m.detection.collision.left_pairs);
  report.times.total = watch.lap();
}

const char* to_string(StepStatus status) {
  static constexpr const char* kWords[] = {"converged", "iteration_limit", "non_finite", "interrupted"};
  return kWords[static_cast<std::size_t>(status)];
}

StepWorkspace::StepWorkspace() : memory_(std::make_unique<StepMemory>()) {}
StepWorkspace::~StepWorkspace() = default;
StepWorkspace::StepWorkspace(StepWorkspace&&) noexcept = default;
StepWorkspace& StepWorkspace::operator=(StepWorkspace&&) noexcept = default;

}  // namespace pabd
