// SPDX-License-Identifier: MIT
// The memory of a step, which the next one reuses: a warm step allocates nothing. Nothing here influences a
// result from one step to the next.
#pragma once

#include "sim/solver/contact_setup.h"
#include "sim/solver/momentum.h"
#include "sim/solver/solve.h"
#include "sim/solver/time_step.h"

namespace pabd {

struct StepMemory {
  Flight flight;
  Detection detection;
  std::vector<Joint> pulls;
  Problem problem;
  Iterate iterate;
  BondGraph graph;
  Islands islands;
  SolverMemory solvers;
  FreeGroups groups;
  Velocities velocities;
  std::vector<Pose> scratch;
};

}  // namespace pabd
