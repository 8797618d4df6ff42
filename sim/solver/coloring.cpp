// SPDX-License-Identifier: MIT
#include "sim/solver/coloring.h"

#include <algorithm>

namespace pabd {
namespace {

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
      const Index follower = p.followers[static_cast<std::size_t>(n)];
      for (const Index k : {follower, p.joints[follower].follows->leader}) {
        const auto [i, j] = p.joint_ends[static_cast<std::size_t>(k)];
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

}  // namespace

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

}  // namespace pabd
