// SPDX-License-Identifier: MIT
#include "sim/solver/islands.h"

#include <algorithm>
#include <numeric>

namespace pabd {
namespace {

// One of the bodies of a joint that can move; fixed where none can.
Index moving_body(const Problem& p, Index joint) {
  const auto [i, j] = p.joint_ends[joint];
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

// The smallest colour that no neighbour has.
Index free_color(const Problem& p, const std::vector<Index>& color, Index body) {
  std::uint64_t used = 0;
  Index beyond = 0;  // smallest colour above all neighbours, for the rare body with 64 colours around it
  const auto avoid = [&](Index other) {
    if (!p.movable(other) || color[other] < 0) return;
    if (color[other] < 64) used |= std::uint64_t{1} << color[other];
    beyond = std::max(beyond, color[other] + 1);
  };
  for (const ManifoldEnd& end : p.ends[body]) avoid(end.other);
  for (const Index k : p.joints_at[body]) {
    const auto [i, j] = p.joint_ends[k];
    avoid(i == body ? j : i);
  }
  if (!p.followers.empty()) {
    for (const Index n : p.couplings_at[body]) {
      const Index follower = p.followers[n];
      for (const Index k : {follower, p.joints[follower].follows->leader}) {
        const auto [i, j] = p.joint_ends[k];
        for (const Index other : {i, j})
          if (other != body) avoid(other);
      }
    }
  }
  for (Index k = 0; k < 64; ++k) {
    if (!(used >> k & 1)) return k;
  }
  return beyond;
}

// Greedily, in the order of bodies and bonds.
void color_bodies(const Problem& p, Islands& islands) {
  islands.color.assign(p.model->shape.size(), -1);
  islands.colored.resize(islands.solved.size());
  islands.first_of_color.clear();
  islands.first_of_color.reserve(2 * islands.solved.size());  // so that spans into it stay
  Index* place = islands.colored.data();
  for (Island& island : islands.list) {
    Index colors = 0;
    for (const Index i : island.bodies) {
      islands.color[i] = free_color(p, islands.color, i);
      colors = std::max(colors, islands.color[i] + 1);
    }
    const auto begin = islands.first_of_color.size();
    islands.first_of_color.resize(begin + static_cast<std::size_t>(colors) + 1, 0);
    Index* first = islands.first_of_color.data() + begin;
    for (const Index i : island.bodies) ++first[islands.color[i] + 1];
    for (Index k = 0; k < colors; ++k) first[k + 1] += first[k];
    for (const Index i : island.bodies) place[first[islands.color[i]]++] = i;
    for (Index k = colors; k > 0; --k) first[k] = first[k - 1];
    first[0] = 0;
    island.colored = {place, island.bodies.size()};
    island.first_of_color = {first, static_cast<std::size_t>(colors) + 1};
    place += island.bodies.size();
  }
}

}  // namespace

void find_islands(const Problem& p, const Iterate& it, Islands& out) {
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
  color_bodies(p, out);
}

}  // namespace pabd
