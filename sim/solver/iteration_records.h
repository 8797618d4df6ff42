// SPDX-License-Identifier: MIT
// What each iteration of a solve did, for the plots of convergence.
#pragma once

#include "sim/solver/islands.h"
#include "sim/solver/report.h"

namespace pabd {

// An island at the iterate, as a solver sees it that has no projection.
IterationRecord record(const Problem& p, const Island& island, const Iterate& it);

// Records of all islands as those of the step: energies add up, of the rest the worst counts. An island that
// has converged stays at its last one. The first record of each is that before its first iteration.
void merge_records(const std::vector<std::vector<IterationRecord>>& islands, std::size_t count,
                   StepReport& report);

}  // namespace pabd
