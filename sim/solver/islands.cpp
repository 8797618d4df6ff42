// SPDX-License-Identifier: MIT
// See islands.h.
#include "sim/solver/islands.h"

#include <numeric>

namespace pabd {
namespace {

// One of the bodies of a joint that can move; fixed where none can.
Index moving_body(const Problem& p, Index joint) {
  const auto [i, j] = p.joint_ends[static_cast<std::size_t>(joint)];
  return p.movable(i) ? i : j;
}

// Joins the ends of all bonds; fixed bodies and the world join nothing.
void join_bodies(const Problem& p, const Iterate& it, std::vector<Index>& parent) {
  parent.resize(p.model->shape.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto join = [&](Index a, Index b) {
    if (p.movable(a) && p.movable(b)) parent[root(parent, a)] = root(parent, b);
  };
  for (const ContactManifold& manifold : it.manifold) join(manifold.a, manifold.b);
  for (std::size_t k = 0; k < p.joints.model.size(); ++k) join(p.joint_ends[k].first, p.joint_ends[k].second);
  for (const Index k : p.followers) {
    const Index leader = p.joints[k].follows->leader;
    join(moving_body(p, k), moving_body(p, leader));
  }
}

// Numbers the islands in order of their lowest bodies.
Index number_islands(const Problem& p, Islands& out) {
  const Index n = p.model->size();
  out.of.assign(static_cast<std::size_t>(n), -1);
  out.solved.clear();
  Index count = 0;
  for (Index i = 0; i < n; ++i) {
    if (!p.movable(i) || (p.ends[i].empty() && p.joints_at[i].empty())) continue;
    Index& number = out.of[root(out.parent, i)];  // of the root first
    if (number < 0) number = count++;
    out.of[i] = number;
    out.solved.push_back(i);
  }
  return count;
}

}  // namespace

void split_into_islands(const Problem& p, const Iterate& it, Islands& out) {
  join_bodies(p, it, out.parent);
  const auto count = static_cast<std::size_t>(number_islands(p, out));
  const auto of = [&](Index a, Index b) { return out.of[p.movable(a) ? a : b]; };
  out.bodies.fill(count, [&](const auto& visit) {
    for (const Index i : out.solved) visit(out.of[i], i);
  });
  out.manifolds.fill(count, [&](const auto& visit) {
    for (std::size_t k = 0; k < it.manifold.size(); ++k)
      visit(of(it.manifold[k].a, it.manifold[k].b), static_cast<Index>(k));
  });
  out.joints.fill(count, [&](const auto& visit) {
    for (std::size_t k = 0; k < p.joint_ends.size(); ++k) {
      const auto [i, j] = p.joint_ends[k];
      if (p.movable(i) || p.movable(j)) visit(of(i, j), static_cast<Index>(k));
    }
  });
  out.couplings.fill(count, [&](const auto& visit) {
    for (std::size_t n = 0; n < p.followers.size(); ++n) {
      const Index body = moving_body(p, p.followers[n]);
      if (p.movable(body)) visit(out.of[body], static_cast<Index>(n));
    }
  });
  out.row.assign(p.model->shape.size() + 1, -1);
  for (std::size_t k = 0; k < count; ++k) {
    Index row = 0;
    for (const Index i : out.bodies[static_cast<Index>(k)]) out.row[i] = row++;
  }
  out.list.clear();
  for (std::size_t k = 0; k < count; ++k) {
    const auto number = static_cast<Index>(k);
    Island island;
    island.bodies = out.bodies[number];
    island.manifolds = out.manifolds[number];
    island.joints = out.joints[number];
    island.couplings = out.couplings[number];
    island.row = out.row;
    island.jointed =
        !island.joints.empty() && static_cast<std::size_t>(island.joints.front()) < p.joints.model.size();
    out.list.push_back(island);
  }
}

}  // namespace pabd
