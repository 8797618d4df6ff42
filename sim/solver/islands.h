// Which bodies hang together through contacts and joints, and which solver each such island gets.
#pragma once

#include "sim/body/model.h"
#include "sim/solver/params.h"
#include "sim/solver/workspace.h"

namespace pabd {

// Fills w.first_joint/joints, and w.newton with the bodies that `newton` solves, in order of number: with
// method newton all bodies that have bonds, with auto those of islands in which a joint couples bodies, and
// of piles that cost little to factorise.
void find_islands(const Model& model, const Params& params, const State& state, StepWorkspace::Impl& w);

// Fills w.parent: root(w.parent, i) is the same for all bodies that hang together.
void join_islands(const Model& model, StepWorkspace::Impl& w);

// The body that stands for i's island. Shortens the way to it.
inline Index root(std::vector<Index>& parent, Index i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

}  // namespace pabd
