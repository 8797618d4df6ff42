// SPDX-License-Identifier: MIT
// Contacts are found where bodies would fly to (contact_setup.h). What a hit turns aside ends elsewhere, and may end in
// something that the step did not know of.
#pragma once

#include "sim/solver/contact_setup.h"
#include "sim/solver/islands.h"
#include "sim/solver/report.h"
#include "sim/solver/workers.h"

namespace pabd {

// Marks the bodies that overlap at the iterate in points that the step has no contact for, with all of their islands, but for
// crowds. Looks only where a body ends more than d̂/2 beside where its contacts were looked for (`looked_at`), and not at what is
// not finite.
void mark_late_contacts(const Problem& p, const Islands& islands, const std::vector<IslandReport>& outcome,
                        const Workers& workers, const Iterate& it, const Detection& looked_at,
                        Detection& memory, std::vector<std::uint8_t>& marked);

// Marks what the marked bodies, which are at the end of their halves, overlap with of all others: halves know of no body but
// their own. False: nothing.
bool mark_what_they_hit(const Problem& p, const Islands& islands, const Workers& workers, const Iterate& it,
                        const Detection& looked_at, Detection& memory, std::vector<std::uint8_t>& marked);

}  // namespace pabd
