// One time step, in the order of the algorithm.

#include "sim/solver/time_step.h"

#include <Eigen/Dense>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "sim/body/mass_properties.h"
#include "sim/math/extremes.h"
#include "sim/math/flush_denormals.h"
#include "sim/math/so3.h"
#include "sim/solver/body_reports.h"
#include "sim/solver/coloring.h"
#include "sim/solver/contact_setup.h"
#include "sim/solver/energy_bound.h"
#include "sim/solver/free_flight.h"
#include "sim/solver/friction.h"
#include "sim/solver/islands.h"
#include "sim/solver/joint_reports.h"
#include "sim/solver/joint_set.h"
#include "sim/solver/momentum.h"
#include "sim/solver/newton.h"
#include "sim/solver/recovery.h"
#include "sim/solver/runaway.h"
#include "sim/solver/solve.h"
#include "sim/solver/step_summary.h"
#include "sim/solver/stiffness_cap.h"

namespace pabd {
namespace {

class Stopwatch {
 public:
  double ms() const { return std::chrono::duration<double, std::milli>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

// 1. Q* = [c*, R*]: free flight of every body.
void predict(const Model& model, const Params& params, const State& state, int threads,
             StepWorkspace::Impl& w) {
  w.star.resize(state.c.size());
  w.radius.resize(state.c.size());
  w.turn.assign(state.c.size(), Vec3::Zero());
  w.v = state.v;
  w.omega = state.omega;
  w.collision.team.for_each(threads, model.shape.size(), kBlock, [&](std::size_t i) {
    w.star[i] = {state.c[i], state.R[i]};
    w.radius[i] = bounding_radius(model.shape[i]);
    if (model.fixed[i]) return;
    w.turn[i] = free_flight(model.J[i], params.gravity, params.h, w.star[i], w.v[i], w.omega[i]);
  });
}

// 4. Momentum is kept by what nothing outside holds; v ← v + (c − c*)/h. The spin gets the angular impulse
// that the minimiser of E implies, −axial(R* J Rᵀ)/h, which is I log(R R*ᵀ)/h to first order and exactly the
// contacts' r × f h (Deviation D8).
void update_velocities(const Model& model, const Params& params, const State& start, StepWorkspace::Impl& w) {
  balance_poses(model, start, params.h, w);
  for (const Index i : w.solved) {
    if (w.pose[i].c == w.star[i].c && w.pose[i].R == w.star[i].R) continue;  // flew freely
    w.pose[i].R = reorthonormalized(w.pose[i].R);
    w.v[i] += (w.pose[i].c - w.star[i].c) / params.h;
    const Mat3 I = inertia_tensor(model.J[i]);
    const Vec3 spin = w.star[i].R * (I * (w.star[i].R.transpose() * w.omega[i])) -
                      axial(w.star[i].R * model.J[i] * w.pose[i].R.transpose()) / params.h;
    w.omega[i] = w.pose[i].R * I.llt().solve(w.pose[i].R.transpose() * spin);
  }
  balance_velocities(model, w);
}

// Of the bodies at `pose`, and their velocities.
bool all_finite(const std::vector<Pose>& pose, const StepWorkspace::Impl& w) {
  double sum = 0;
  for (std::size_t i = 0; i < w.v.size(); ++i)
    sum += 0.0 * (pose[i].c.sum() + pose[i].R.sum() + w.v[i].sum() + w.omega[i].sum());
  return sum == 0;  // 0 · x is NaN for an infinite or undefined x
}

IterationRecord record(const SolveContext& s, double residual, double gap_before, const StepReport& report) {
  IterationRecord r;
  r.energy = incremental_potential(s);
  r.residual = residual;
  r.min_gap_after = smallest_gap(s.w);
  r.min_gap_before = report.method == SolverMethod::sissm ? gap_before : r.min_gap_after;
  r.max_penetration_before = larger(0, -r.min_gap_before);
  r.max_penetration_after = larger(0, -r.min_gap_after);
  r.max_joint_error = largest_joint_error(s);
  r.projection_change = 0;
  if (report.method == SolverMethod::sissm) {
    for (const Index i : s.w.solved) r.projection_change = larger(r.projection_change, s.w.projected[i]);
  }
  return r;
}

// Every body with bonds, in order of number.
void list_solved(StepWorkspace::Impl& w) {
  w.solved = w.colored;
  w.solved.insert(w.solved.end(), w.newton.begin(), w.newton.end());
  std::sort(w.solved.begin(), w.solved.end());
}

// Does friction obey its law at an iterate that no longer moves? Before it may, bodies that can no longer
// hold let go.
bool friction_settled(const SolveContext& s) {
  if (largest_friction_error(s) > kFrictionTolerance || holds_back(s.w)) return false;
  if (!let_go(s.w)) return true;
  forget_best(*s.w.system);
  return false;
}

// 3. Iterates until the bodies move by less than `tolerance` · d̂ under friction that obeys its law, or the
// cap.
void solve(const SolveContext& s, const StepOptions& options, StepReport& report) {
  StepWorkspace::Impl& w = s.w;
  report.status = w.solved.empty() ? StepStatus::converged : StepStatus::iteration_limit;
  if (w.solved.empty()) return;
  w.moved.assign(w.v.size(), 0.0);
  w.rests.assign(w.v.size(), 0);
  w.projected.assign(w.v.size(), 0.0);
  // Jacobi's threads share patches, and do not mark them.
  const bool marks =
      report.method != SolverMethod::sissm && s.params.solver.projection != Projection::weighted;
  for (ContactPatch& patch : w.patches) patch.felt = !marks;
  const bool swept = sweeps_limits(s, report.method);  // friction bounds
  bool every_body = true;
  if (report.method == SolverMethod::sissm) w.A.resize(w.v.size());
  if (options.record_iterations) report.first_iterate = record(s, 0, smallest_gap(w), report);
  start_newton(s, *w.system);
  const LimitsOf moved_here = swept ? LimitsOf::newton : LimitsOf::all;
  for (int k = 0; k < s.params.solver.iterations; ++k) {
    if (k > 0 && move_friction_limits(s, moved_here)) forget_best(*w.system);
    double gap_before = 0;
    if (report.method == SolverMethod::sissm) {
      sissm_iteration(s, options.record_iterations ? &gap_before : nullptr);
    } else {
      newton_iteration(s, k + 1 == s.params.solver.iterations, *w.system);
      descent_sweep(s, {k == 0, swept && k > 0, every_body});
    }
    ++report.iterations;
    report.residual = 0;
    for (const Index i : w.solved) report.residual = larger(report.residual, w.moved[i]);
    if (options.record_iterations) report.records.push_back(record(s, report.residual, gap_before, report));
    if (s.w.stop.requested()) {
      report.status = StepStatus::interrupted;
      return;
    }
    if (!std::isfinite(report.residual)) {
      report.status = StepStatus::non_finite;
      return;
    }
    if (!(report.residual < s.params.solver.tolerance)) {
      every_body = false;
    } else if ((!every_body && any_rests(w)) || !friction_settled(s)) {
      every_body = true;  // once more, to be sure
    } else {
      report.status = StepStatus::converged;
      return;
    }
  }
  if (report.method != SolverMethod::sissm) finish_newton(s, *w.system);
}

// The log barrier has no force for a pair that overlaps: such a start is reported, not solved.
bool is_infeasible(const StepWorkspace::Impl& w) {
  return w.law.barrier.kind == BarrierKind::log && smallest_gap(w) <= 0;
}

// The step was not made: what it would have ended with is not known.
void fail(const Stopwatch& total, StepReport& report) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  report.status = StepStatus::non_finite;
  if (report.iterations == 0) report.residual = kUnknown;
  for (double* quantity : {&report.kinetic, &report.potential, &report.elastic, &report.max_penetration,
                           &report.min_gap, &report.max_joint_error})
    *quantity = kUnknown;
  report.times.total = total.ms();
}

void clear(StepReport& report) {
  std::vector<IterationRecord> records = std::move(report.records);
  std::vector<ContactReport> contacts = std::move(report.contact_reports);
  std::vector<BodyReport> bodies = std::move(report.body_reports);
  std::vector<JointReport> joints = std::move(report.joint_reports);
  records.clear();
  contacts.clear();
  bodies.clear();
  joints.clear();
  report = StepReport{};
  report.records = std::move(records);
  report.contact_reports = std::move(contacts);
  report.body_reports = std::move(bodies);
  report.joint_reports = std::move(joints);
}

void interrupt(const Stopwatch& total, StepReport& report) {
  report.status = StepStatus::interrupted;
  report.times.total = total.ms();
}

}  // namespace

void step(const Model& model, const Params& params, const StepOptions& options, State& state,
          StepWorkspace& workspace, StepReport& report) {
  const FlushDenormals flush;
  StepWorkspace::Impl& w = workspace.impl();
  const Stopwatch total;
  clear(report);
  report.step = state.step + 1;
  report.time = state.time + params.h;
  report.method =
      params.solver.method == SolverMethod::automatic ? SolverMethod::descent : params.solver.method;

  w.stop = w.collision.stop = {&options.stop};
  predict(model, params, state, options.threads, w);  // 1. free flight: Q*
  if (!all_finite(w.star, w)) return fail(total, report);
  const Stopwatch detecting;
  find_contacts(model, params, state, options.threads, w);  // 2. bonds of this step, S(17)
  report.times.detect = detecting.ms();
  if (w.stop.requested()) return interrupt(total, report);
  start_recovery(params, state, w);
  list_ends(model, w);
  take_pulls(model, options.pulls, w);
  find_islands(model, params, state, w);
  report.left_pairs = w.collision.left_pairs;
  report.too_dense = prepare_newton(model, w);
  color_bodies(model, w);
  list_solved(w);
  report.method = params.solver.method;
  if (report.method == SolverMethod::automatic)
    report.method = w.newton.size() > w.colored.size() ? SolverMethod::newton : SolverMethod::descent;
  initial_guess(model, params, state, w);
  const SolveContext context{model, params, options.threads, report.time, w};
  report.capped_bonds = cap_stiffness(context);
  start_friction(context, state);
  report.times.set_up = total.ms() - report.times.detect;
  report.kappa = w.law.barrier.kappa;

  const Stopwatch solving;
  const bool feasible = !is_infeasible(w);
  if (feasible) solve(context, options, report);  // 3. minimise E
  if (report.status == StepStatus::interrupted) return interrupt(total, report);
  report.times.solve = solving.ms();
  const Stopwatch finishing;
  note_free_flight(context);
  update_velocities(model, params, state, w);  // 4. velocities

  if (!feasible || report.status == StepStatus::non_finite || !all_finite(w.pose, w) ||
      ran_away(context, state))
    return fail(total, report);
  if (bounds_energy(params.solver)) report.held_bodies = bound_energy(context, state);
  if (report.held_bodies > 0) {
    report.status = StepStatus::iteration_limit;
    balance_velocities(model, w);
  }
  finish_recovery(params, state, w);
  for (std::size_t i = 0; i < w.v.size(); ++i) {
    state.c[i] = w.pose[i].c;
    state.R[i] = w.pose[i].R;
  }
  state.v.swap(w.v);
  state.omega.swap(w.omega);
  store_friction(w, state.anchors);
  state.step = report.step;
  state.time = report.time;
  summarize_contacts(context, options.report_contacts, report);
  for (std::size_t k = 0; k < w.all_joints.size(); ++k)
    report.elastic += energy_of_joint(context, static_cast<Index>(k));
  report.drive_work = drive_work(context);
  report.max_joint_error = largest_joint_error(context);
  if (options.report_joints) report_joints(context, report.joint_reports);
  if (options.report_bodies) report_bodies(model, params.solver.method, w, report.body_reports);
  report.kinetic = kinetic_energy(model, state);
  report.potential = potential_energy(model, params, state);
  report.times.velocities = finishing.ms();
  report.times.total = total.ms();
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

StepWorkspace::Impl::Impl() : system(std::make_unique<NewtonSystem>()) {}
StepWorkspace::Impl::~Impl() = default;

StepWorkspace::StepWorkspace() : impl_(std::make_unique<Impl>()) {}
StepWorkspace::~StepWorkspace() = default;
StepWorkspace::StepWorkspace(StepWorkspace&&) noexcept = default;
StepWorkspace& StepWorkspace::operator=(StepWorkspace&&) noexcept = default;

}  // namespace pabd
