// Bodies that overlap deeply come apart slowly (contact.recovery_speed).
//
// At a deep overlap the barrier holds far more energy than any impact brought. A pair with a contact deeper
// than 2 d̂ at the start of a step recovers: in each of its contacts that starts at d₀ < d̂ − V h, with V the
// speed,
//
//   Ψ(d) → q Ψ(d + s),   s = d̂ − V h − d₀,   q = Ψ'(d₀)/Ψ'(d₀ + s)
//
// pushes at d₀ as hard as before, so that it carries the same load, and ends where the contact has opened by
// V h. The pair recovers until its contacts are within V h of d̂, or rest without overlap. Not for the log
// barrier, which has no overlap.
#pragma once

#include "sim/solver/problem.h"

namespace pabd {

// Finds the pairs that recover, by depth and by what the last step left in the start's anchors, and sets
// their contacts up. Precondition: the patches are those of the step, sorted by pair.
void start_recovery(const Problem& p, Iterate& it);

// Keeps ContactPatch::recovers where the recovery goes on after the step.
void finish_recovery(const Problem& p, Iterate& it);

}  // namespace pabd
