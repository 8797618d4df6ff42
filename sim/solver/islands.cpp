#include "sim/solver/islands.h"

#include <algorithm>
#include <numeric>

namespace pabd {
namespace {

// What a factorisation may cost before `descent` is the better choice, in products of 6×6 blocks per contact
// patch (measured, see tests/bench/README.md). An island at rest converges in one to three iterations and is
// worth more; one in which contacts come and go needs as many of `newton` as of `descent`.
constexpr double kProductsInMotion = 3, kProductsAtRest = 25;
constexpr double kAtRest = 0.2;          // longest way of a body in a step, in d̂
constexpr double kLargeMassRatio = 100;  // in an island: `descent` would need many iterations
constexpr double kMostProducts = 1e5;    // whatever it is worth: some milliseconds
// Above this size it is not even looked at.
constexpr Index kMostRows = 5000;

bool movable(const Model& model, Index i) { return i != kWorld && !model.fixed[i]; }

void list_joints(const Model& model, StepWorkspace::Impl& w) {
  const std::size_t n = model.shape.size();
  w.first_joint.assign(n + 1, 0);
  const auto each_end = [&](const auto& visit) {
    for (std::size_t k = 0; k < w.all_joints.size(); ++k) {
      for (const Index i : {w.all_joints[k].i, w.all_joints[k].j}) {
        if (movable(model, i)) visit(i, static_cast<Index>(k));
      }
    }
  };
  each_end([&](Index i, Index) { ++w.first_joint[i + 1]; });
  std::partial_sum(w.first_joint.begin(), w.first_joint.end(), w.first_joint.begin());
  w.joints.resize(static_cast<std::size_t>(w.first_joint[n]));
  w.cursor.assign(w.first_joint.begin(), w.first_joint.end());
  each_end([&](Index i, Index k) { w.joints[w.cursor[i]++] = k; });
}

// Islands of contacts alone in which a factorisation costs little.
void choose_piles(const Model& model, double h, const State& state, StepWorkspace::Impl& w) {
  IslandChoice& choice = w.choice;
  const auto candidate = [&](Index i) {
    return movable(model, i) && w.solver_of[root(w.parent, i)] != IslandSolver::newton &&
           !w.ends_of(i).empty();
  };
  choice.row.assign(model.shape.size(), -1);
  Index rows = 0;
  for (Index i = 0; i < model.size(); ++i) {
    if (candidate(i)) choice.row[i] = rows++;
  }
  choice.pairs.clear();
  choice.patches.assign(model.shape.size(), 0);
  for (const ContactPatch& patch : w.patches) {
    const Index p = choice.row[patch.a], q = choice.row[patch.b];
    if (p >= 0 && q >= 0) choice.pairs.emplace_back(std::min(p, q), std::max(p, q));
    if (p >= 0 || q >= 0) ++choice.patches[root(w.parent, p >= 0 ? patch.a : patch.b)];
  }
  std::sort(choice.pairs.begin(), choice.pairs.end());
  choice.pairs.erase(std::unique(choice.pairs.begin(), choice.pairs.end()), choice.pairs.end());
  const double most = 4 * kProductsAtRest * static_cast<double>(w.patches.size());
  if (rows == 0 || rows > kMostRows || !choice.graph.analyze(rows, choice.pairs, most)) return;

  choice.cost.assign(model.shape.size(), {});
  for (Index i = 0; i < model.size(); ++i) {
    if (choice.row[i] < 0) continue;
    const Index k = choice.graph.position(choice.row[i]);
    const auto below = static_cast<double>(choice.graph.first(k + 1) - choice.graph.first(k));
    IslandChoice::Cost& cost = choice.cost[root(w.parent, i)];
    cost.products += 0.5 * below * (below + 1);
    cost.lightest = std::min(cost.lightest, model.mass[i]);
    cost.heaviest = std::max(cost.heaviest, model.mass[i]);
    cost.way = std::max(cost.way, h * state.v[i].norm());
  }
  for (Index i = 0; i < model.size(); ++i) {
    if (choice.patches[i] == 0) continue;
    const IslandChoice::Cost& cost = choice.cost[i];
    const bool at_rest = cost.way <= kAtRest * w.law.barrier.d_hat;
    const bool worth_more = at_rest || cost.heaviest > kLargeMassRatio * cost.lightest;
    if (cost.products <= kMostProducts &&
        cost.products <= (worth_more ? kProductsAtRest : kProductsInMotion) * choice.patches[i])
      w.solver_of[i] = IslandSolver::newton;
  }
}

}  // namespace

void join_islands(const Model& model, StepWorkspace::Impl& w) {
  w.parent.resize(model.shape.size());
  std::iota(w.parent.begin(), w.parent.end(), 0);
  const auto join = [&](Index a, Index b) {
    if (movable(model, a) && movable(model, b)) w.parent[root(w.parent, a)] = root(w.parent, b);
  };
  for (const ContactPatch& patch : w.patches) join(patch.a, patch.b);
  for (const Joint& joint : model.joints) join(joint.i, joint.j);
}

void find_islands(const Model& model, const Params& params, const State& state, StepWorkspace::Impl& w) {
  const SolverMethod method = params.solver.method;
  list_joints(model, w);
  w.newton.clear();
  w.is_newton.assign(model.shape.size() + 1, 0);
  if (method != SolverMethod::newton && method != SolverMethod::automatic) return;

  join_islands(model, w);
  const bool all = method == SolverMethod::newton;
  w.solver_of.assign(model.shape.size(), all ? IslandSolver::newton : IslandSolver::descent);
  if (!all) {
    for (const Joint& joint : model.joints) {
      for (const Index i : {joint.i, joint.j}) {
        if (movable(model, i)) w.solver_of[root(w.parent, i)] = IslandSolver::newton;
      }
    }
    choose_piles(model, params.h, state, w);
  }
  for (Index i = 0; i < model.size(); ++i) {
    if (model.fixed[i] || w.solver_of[root(w.parent, i)] != IslandSolver::newton) continue;
    if (w.joints_of(i).empty() && w.ends_of(i).empty()) continue;
    w.is_newton[i] = 1;
    w.newton.push_back(i);
  }
}

}  // namespace pabd
