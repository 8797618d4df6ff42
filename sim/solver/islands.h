// SPDX-License-Identifier: MIT
// Bodies that hang together through contacts and joints.
#pragma once

#include "sim/math/extremes.h"
#include "sim/solver/problem.h"

namespace pabd {

// Movable bodies that hang together, with their bonds, by number and in order of number. A body without bonds
// is in no island.
struct Island {
  std::span<const Index> bodies, manifolds, joints, couplings;
  std::span<const Index> row;  // per slot of a pose: the body's place in `bodies`, −1 where nothing moves
  bool jointed = false;        // by joints of the model; pulls alone do not count
  SolverMethod solver = SolverMethod::descent;
  int iterations = 0, most_iterations = 0;  // the second: where a solution is near
  bool crowd = false;  // so many of its contacts are of crowds that no solution is worth much

  // For descent: no two bodies of one colour share a bond. Colour k is colored[first_of_color[k]] …
  // colored[first_of_color[k + 1] − 1].
  std::span<const Index> colored, first_of_color;
};

// Largest Iterate::moved of its bodies; d̂.
inline double largest_moved(const Island& island, const Iterate& it) {
  double moved = 0;
  for (const Index i : island.bodies) moved = larger(moved, it.moved[i]);
  return moved;
}

// All islands of a step, in order of their lowest bodies, and the arrays that they look into.
struct Islands {
  std::vector<Island> list;
  std::vector<Index> solved;  // bodies of all islands, in order of number
  std::vector<Index> of;      // per body: its island, −1 without
  std::vector<Index> row;     // Island::row, the same for all
  RowList<Index> bodies, manifolds, joints, couplings;

  std::vector<Index> color, colored, first_of_color;

  std::vector<Index> parent;  // scratch
};

// Splits the bodies into islands and colours each of them: any may come to `descent`. Depends on the order of bodies and
// bonds alone.
void find_islands(const Problem& p, const Iterate& it, Islands& out);

// The body that stands for i's set. Shortens the way to it.
inline Index root(std::vector<Index>& parent, Index i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

}  // namespace pabd
