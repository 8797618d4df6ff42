#include "sim/solver/islands.h"

#include <numeric>

namespace pabd {
namespace {

Index root(std::vector<Index>& parent, Index i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

bool movable(const Model& model, Index i) { return i != kWorld && !model.fixed[i]; }

void list_joints(const Model& model, StepWorkspace::Impl& w) {
  const std::size_t n = model.shape.size();
  w.first_joint.assign(n + 1, 0);
  const auto each_end = [&](const auto& visit) {
    for (std::size_t k = 0; k < model.joints.size(); ++k) {
      for (const Index i : {model.joints[k].i, model.joints[k].j}) {
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

}  // namespace

void find_islands(const Model& model, SolverMethod method, StepWorkspace::Impl& w) {
  const Index n = model.size();
  list_joints(model, w);
  w.newton.clear();
  w.is_newton.assign(static_cast<std::size_t>(n) + 1, 0);
  if (method != SolverMethod::newton && (method != SolverMethod::automatic || model.joints.empty())) return;

  w.parent.resize(static_cast<std::size_t>(n));
  std::iota(w.parent.begin(), w.parent.end(), 0);
  const auto join = [&](Index a, Index b) {
    if (movable(model, a) && movable(model, b)) w.parent[root(w.parent, a)] = root(w.parent, b);
  };
  for (const ContactPatch& patch : w.patches) join(patch.a, patch.b);
  for (const Joint& joint : model.joints) join(joint.i, joint.j);
  w.cursor.assign(static_cast<std::size_t>(n),
                  method == SolverMethod::newton ? 1 : 0);  // per island: newton?
  for (const Joint& joint : model.joints) {
    for (const Index i : {joint.i, joint.j}) {
      if (movable(model, i)) w.cursor[root(w.parent, i)] = 1;
    }
  }
  for (Index i = 0; i < n; ++i) {
    if (model.fixed[i] || !w.cursor[root(w.parent, i)]) continue;
    if (w.joints_of(i).empty() && w.ends_of(i).empty()) continue;
    w.is_newton[i] = 1;
    w.newton.push_back(i);
  }
}

}  // namespace pabd
