// What every body did in a step, for colours and inspectors.
#pragma once

#include "sim/solver/islands.h"
#include "sim/solver/report.h"
#include "sim/solver/sissm.h"

namespace pabd {

// One report a body at the end of a finished step. `solved`: how its islands were solved.
void report_bodies(const Problem& p, const Islands& islands, const std::vector<IslandReport>& solved,
                   const Iterate& it, const SissmMemory& sissm, std::vector<BodyReport>& out);

}  // namespace pabd
