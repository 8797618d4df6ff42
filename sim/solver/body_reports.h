// SPDX-License-Identifier: MIT
// What every body did in a step, for colours and inspectors.
#pragma once

#include "sim/solver/islands.h"
#include "sim/solver/report.h"
#include "sim/solver/sissm.h"

namespace pabd {

// One report a body of the model, at the end of a step. Every body has its contacts; the island and what solved
// it (`solved`, one entry an island) are there for bodies of an island, what the projection changed for those
// that `sissm` solved.
void report_bodies(const Problem& p, const Islands& islands, const std::vector<IslandReport>& solved,
                   const Iterate& it, const SissmMemory& sissm, std::vector<BodyReport>& out);

}  // namespace pabd
