// SPDX-License-Identifier: MIT
#include "sim/solver/solve.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "sim/math/extremes.h"
#include "sim/solver/friction.h"
#include "sim/solver/halving.h"
#include "sim/solver/iteration_records.h"
#include "sim/solver/joint_actions.h"

namespace pabd {
namespace {

// The sweeps of an island of so many bodies are shared by all threads (`newton` takes it alone); smaller ones are
// solved side by side, where they have so many bodies together that another thread is worth waking.
constexpr std::size_t kShared = 512, kSideBySide = 32;

// Does the sweep of `descent` move the friction bounds as well?
bool sweeps_limits(const Problem& p, const Island& island) {
  return island.solver == SolverMethod::descent && p.params->solver.projection != Projection::weighted;
}

// Do the solver's iterations mark the manifolds that push? Jacobi's threads share manifolds, and do not.
bool marks_felt(const Problem& p, const Island& island) {
  return island.solver != SolverMethod::sissm && p.params->solver.projection != Projection::weighted;
}

// An island, what belongs to it while it is solved, and how far its iterations have come.
struct Task {
  const Problem& p;
  Island island;  // its solver may change
  const Workers& workers;
  SolverMemory& memory;
  NewtonSystem* system;                   // where `newton` takes the island
  std::vector<IterationRecord>* records;  // where they are asked for

  int iterations = 0;      // made
  int since = 0;           // iteration from which on the island has its solver
  double first = 0;        // largest move of the first one; d̂
  double moved = 0;        // of the last one; d̂
  double residual = 0;     // expected of the next one; d̂
  bool every_body = true;  // the next sweep relaxes quiet bodies too

  bool newton() const { return island.solver == SolverMethod::newton; }
  bool sweeps() const { return island.solver == SolverMethod::descent; }
};

// Does friction obey its law at an iterate that no longer moves? Before it may, bodies that can no longer
// hold let go.
bool friction_settled(const Task& t, Iterate& it) {
  if (largest_friction_error(t.p, t.island, it) > kFrictionTolerance || holds_back(t.p, t.island, it))
    return false;
  if (!let_go(t.p, t.island, it)) return true;
  if (t.newton()) forget_best(*t.system);
  return false;
}

// The same for what acts along joints with a largest force.
bool actions_settled(const Task& t, bool converged, Iterate& it) {
  if (!switch_actions(t.p, t.island, converged, it)) return true;
  if (t.newton()) forget_best(*t.system);
  return false;
}

void start(const Task& t, Iterate& it) {
  for (const Index k : t.island.manifolds) it.manifold[k].felt = !marks_felt(t.p, t.island);
  if (t.newton()) start_newton(t.p, t.island, it, *t.system);
  if (t.records) t.records->assign(1, record(t.p, t.island, it));
}

void record_iteration(const Task& t, double gap_before, const Iterate& it) {
  IterationRecord r = record(t.p, t.island, it);
  r.residual = t.moved;
  if (t.island.solver == SolverMethod::sissm) {
    r.min_gap_before = gap_before;
    r.max_penetration_before = larger(0, -gap_before);
    for (const Index i : t.island.bodies)
      r.projection_change = larger(r.projection_change, t.memory.sissm.projected[i]);
  }
  t.records->push_back(r);
}

// Below what residual an island may be at its end; d̂. Sweeps begin with moves that are far less than d̂ where the step is
// short, and so is all their way; what rests falls by h² g and is put back. Of joints nothing is known after the first sweep.
double tolerance_of(const Task& t) {
  constexpr double kRounding = 1e-12;
  constexpr double kOfContacts = 100;  // by default they are solved to a part in 10⁴ of their way
  const double tolerance = t.p.params->solver.tolerance;
  if (!t.sweeps() || tolerance == 0) return tolerance;
  if (!t.island.couplings.empty()) return 0;  // moves are short because it cannot solve them
  const auto part = [&](double way) { return std::max(tolerance * std::min(1.0, way), kRounding); };
  if (t.island.jointed) return t.iterations > 1 ? part(t.first) : kRounding;
  const double h = t.p.params->h, fall = h * h * t.p.params->gravity.norm() / t.p.law.barrier.d_hat;
  return part(kOfContacts * std::max(t.first, fall));
}

// The move after those of `before` and t.moved. Where nothing switches, the moves of `newton` shrink quadratically: after two
// that do, the next is about now³/before². A hundred times that, to be sure. Those of sweeps over joints hardly shrink: what
// is still to go is their sum, now/(1 − now/before).
double next_move(const Task& t, double before) {
  const double now = t.moved;
  if (t.sweeps() && t.island.jointed) return now < before ? now / (1 - now / before) : now;
  if (!t.newton() || !t.system->dual || !(now < 0.1 * before)) return now;
  return std::min(now, 100 * now * (now / before) * (now / before));
}

// One iteration of the island's solver, after friction bounds and what acts along joints have followed the last one.
void iterate(Task& t, Iterate& it) {
  const int k = t.iterations;
  const bool swept = sweeps_limits(t.p, t.island);
  if (k > 0 && !swept) move_friction_limits(t.p, t.island, t.workers, it);
  if (k > 0) actions_settled(t, false, it);
  double gap_before = 0;  // smallest d before the projection of `sissm`
  switch (t.island.solver) {
    case SolverMethod::sissm:
      sissm_iteration(t.p, t.island, t.workers, t.records ? &gap_before : nullptr, t.memory.sissm, it);
      break;
    case SolverMethod::newton:
      if (newton_iteration(t.p, t.island, t.workers, *t.system, it)) break;
      t.island.solver = SolverMethod::descent;
      t.since = k;
      [[fallthrough]];
    default:
      descent_sweep(t.p, t.island, {k == t.since, swept && k > 0, t.every_body, tolerance_of(t)}, t.workers,
                    t.memory.descent, it);
  }
  ++t.iterations;
  const double before = std::exchange(t.moved, largest_moved(t.island, it));
  t.residual = next_move(t, before);
  if (k == 0) t.first = t.moved;
  if (t.records) record_iteration(t, gap_before, it);
}

constexpr std::size_t kFew = 64;  // bodies, which cost `newton` little more than a sweep does

// `auto` in halves of piles: bodies hit, and begin the step deep in each other. A few sweeps take them apart, which costs
// `newton` twice as many iterations.
bool begins_with_sweeps(const Task& t) {
  return t.p.is_half && t.newton() && !t.island.jointed && t.island.bodies.size() >= kFew &&
         t.p.params->solver.method == SolverMethod::automatic;
}

// `auto` in a pile. While contacts come and go each iteration of `newton` solves another system, and costs
// more than a sweep: where it does not halve the moves in every iteration, down to d̂, it has the pile again
// after some sweeps. Few bodies it keeps while some step lowers E.
void change_solver(Task& t, Iterate& it) {
  constexpr int kTrial = 2, kSweeps = 20, kFirstSweeps = 4;
  if (!t.system || t.island.jointed || t.p.params->solver.method != SolverMethod::automatic) return;
  const int n = t.iterations - t.since;
  const bool few = t.island.bodies.size() < kFew;
  const bool fails = few ? t.system->stuck : n >= kTrial && t.residual > std::max(1.0, std::ldexp(16.0, -n));
  if (t.newton() && fails) {
    finish_newton(t.p, t.island, *t.system, it);
    t.island.solver = SolverMethod::descent;
  } else if (!t.newton() && n >= (t.since == 0 ? kFirstSweeps : kSweeps)) {
    t.island.solver = SolverMethod::newton;
    start_newton(t.p, t.island, it, *t.system);
  } else {
    return;
  }
  t.since = t.iterations;
}

// May it make more iterations? Hits need more than what rests: what is near enough not to be made again in halves goes on.
// Tolerance 0 asks for so many and no more, where friction obeys its law.
bool goes_on(const Task& t, const Iterate& it) {
  if (t.iterations < t.island.iterations) return true;
  return t.iterations < t.island.most_iterations && t.residual <= kUnsolved &&
         (t.p.params->solver.tolerance > 0 || largest_friction_error(t.p, t.island, it) > kFrictionTolerance);
}

// How the solve ends after its last iteration; empty: it does not. It is converged where bodies move by less than the
// tolerance, no body was skipped in the last sweep unless the one before relaxed all, and both friction and what acts
// along joints obey their laws. Whatever fails that is settled for the next iteration, and asked again after it.
std::optional<StepStatus> outcome(Task& t, Iterate& it) {
  if (t.workers.stop.requested()) return StepStatus::interrupted;
  if (!std::isfinite(t.residual)) return StepStatus::non_finite;
  const bool small = t.residual < tolerance_of(t);
  const bool unsure = !t.every_body && t.sweeps() && any_rests(t.island, t.memory.descent);
  if (small && !unsure && friction_settled(t, it) && actions_settled(t, true, it))
    return StepStatus::converged;
  t.every_body = small;  // once more, to be sure
  change_solver(t, it);
  if (!goes_on(t, it)) return StepStatus::iteration_limit;
  return std::nullopt;
}

// For the next step: the forces of the joints, and for `auto` whether `newton` handed over.
void remember_outcome(const Task& t, Iterate& it) {
  if (t.newton()) store_joint_forces(t.p, t.island, *t.system, it);
  if (t.p.params->solver.method != SolverMethod::automatic || t.island.jointed) return;
  for (const Index k : t.island.manifolds) it.manifold[k].restless = t.sweeps();
}

// A pile where `newton` has nothing to do. Tolerance 0 asks for its iterations all the same.
bool rests(Task& t, Iterate& it) {
  const Island& island = t.island;
  if (!t.newton() || !island.joints.empty() || t.p.params->solver.tolerance == 0) return false;
  if (!rests(t.p, island, t.system->rest, it, t.residual)) return false;
  return largest_friction_error(t.p, island, it) <= kFrictionTolerance;
}

void solve(Task t, Iterate& it, IslandReport& out) {
  start(t, it);
  std::optional<StepStatus> status;
  if (rests(t, it)) {
    status = StepStatus::converged;
  } else if (begins_with_sweeps(t)) {
    t.island.solver = SolverMethod::descent;
  }
  while (!status) {
    iterate(t, it);
    status = outcome(t, it);
  }
  if (*status == StepStatus::iteration_limit && t.newton()) finish_newton(t.p, t.island, *t.system, it);
  remember_outcome(t, it);
  out.solver = t.island.solver;
  out.status = *status;
  out.iterations = t.iterations;
  out.residual = t.residual;
}

// Largest first, so that no thread begins a large one at the end.
void order_by_size(const Islands& islands, std::vector<Index>& order) {
  order.resize(islands.list.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index x, Index y) {
    const std::size_t n = islands.list[x].bodies.size(), m = islands.list[y].bodies.size();
    return n != m ? n > m : x < y;
  });
}

void prepare(const Problem& p, const Islands& islands, bool record, SolverMemory& m, Iterate& it,
             StepReport& report) {
  const std::size_t bodies = p.model->shape.size();
  it.moved.assign(bodies, 0.0);
  it.joint_force.assign(p.model->joints.size(), Vec3::Zero());
  m.descent.rests.assign(bodies, 0);
  m.descent.last_step.resize(bodies);
  if (p.params->solver.method == SolverMethod::sissm) {
    m.sissm.A.resize(bodies);
    m.sissm.c.resize(bodies);
    m.sissm.next.resize(bodies);
    m.sissm.projected.assign(bodies, 0.0);
  }
  if (record && m.records.size() < islands.list.size()) m.records.resize(islands.list.size());
  report.islands.resize(islands.list.size());
  for (std::size_t k = 0; k < islands.list.size(); ++k) {
    const Island& island = islands.list[k];
    report.islands[k] = {island.bodies.front(),
                         static_cast<Index>(island.bodies.size()),
                         static_cast<Index>(island.manifolds.size()),
                         static_cast<Index>(island.joints.size()),
                         island.solver,
                         StepStatus::iteration_limit,
                         0,
                         0};
  }
}

// The step did what the worst of its islands did; `auto` was what ended most of its bodies. What `newton`
// should have solved and did not was too dense.
void sum_up(SolverMethod asked, const Islands& islands, StepReport& report) {
  report.status = StepStatus::converged;
  for (const IslandReport& island : report.islands) add_outcome(island, report);
  if (asked == SolverMethod::newton || asked == SolverMethod::automatic) {
    for (std::size_t k = 0; k < islands.list.size(); ++k) {
      const bool due = asked == SolverMethod::newton || islands.list[k].jointed;
      if (due && report.islands[k].solver == SolverMethod::descent)
        report.too_dense += report.islands[k].bodies;
    }
  }
  if (asked != SolverMethod::automatic) return;
  Index newton = 0, all = 0;
  for (const IslandReport& island : report.islands) {
    all += island.bodies;
    newton += island.solver == SolverMethod::newton ? island.bodies : 0;
  }
  report.method = 2 * newton > all ? SolverMethod::newton : SolverMethod::descent;
}

}  // namespace

void add_outcome(const IslandReport& island, StepSummary& step) {
  step.status = std::max(step.status, island.status);
  step.iterations = std::max(step.iterations, island.iterations);
  step.residual = larger(step.residual, island.residual);
}

void solve_islands(const Problem& p, const Islands& islands, const Workers& workers, bool record,
                   SolverMemory& memory, Iterate& it, StepReport& report) {
  prepare(p, islands, record, memory, it, report);
  order_by_size(islands, memory.order);
  std::atomic<bool> stopped = false;
  const auto solve_one = [&](Index number, const Workers& with) {
    const auto k = static_cast<std::size_t>(number);
    const Island& island = islands.list[k];
    const bool newton = island.solver == SolverMethod::newton;
    IslandReport& out = report.islands[k];
    if (stopped) {
      out.status = StepStatus::interrupted;
      return;
    }
    const Task task{p,
                    island,
                    with,
                    memory,
                    newton ? memory.newton[k].get() : nullptr,
                    record ? &memory.records[k] : nullptr};
    solve(task, it, out);
    if (out.status == StepStatus::interrupted) stopped = true;
  };
  std::size_t next = 0;
  for (; next < memory.order.size() && islands.list[memory.order[next]].bodies.size() >= kShared; ++next)
    solve_one(memory.order[next], workers);
  const Workers alone = workers.alone();
  std::size_t bodies = 0;
  for (std::size_t k = next; k < memory.order.size(); ++k)
    bodies += islands.list[memory.order[k]].bodies.size();
  workers.team.for_each_large(workers.threads, memory.order.size() - next, bodies >= kSideBySide,
                              [&](std::size_t k) { solve_one(memory.order[next + k], alone); });
  sum_up(p.params->solver.method, islands, report);
  if (record && !islands.list.empty()) merge_records(memory.records, islands.list.size(), report);
}

}  // namespace pabd
