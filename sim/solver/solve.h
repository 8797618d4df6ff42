// SPDX-License-Identifier: MIT
// Solves the islands of a step, side by side: each has its own line search, watchdog and convergence.
#pragma once

#include "sim/solver/choice.h"
#include "sim/solver/descent.h"
#include "sim/solver/report.h"
#include "sim/solver/sissm.h"

namespace pabd {

// Memory of the solvers, reused from step to step; it does not influence results.
struct SolverMemory {
  NewtonSystems newton;
  DescentMemory descent;
  SissmMemory sissm;
  std::vector<Index> order;                           // islands, largest first
  std::vector<std::vector<IterationRecord>> records;  // of each island, where they are asked for
};

// Status, iterations and residual of a step are the worst of its islands.
void add_outcome(const IslandReport& island, StepSummary& step);

// Moves the poses of all islands to the minimum of E, or as far as their iterations go. Fills report.islands and status,
// iterations and residual of the step; with `record` also the records of every iteration. The same bits for every number of
// threads.
void solve_islands(const Problem& p, const Islands& islands, const Workers& workers, bool record,
                   SolverMemory& memory, Iterate& it, StepReport& report);

}  // namespace pabd
