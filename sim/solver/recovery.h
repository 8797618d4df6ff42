// SPDX-License-Identifier: MIT
// Bodies that overlap deeply, or that a scene puts closer than they can rest, come apart slowly
// (contact.recovery_speed).
//
// There the barrier holds energy that nothing brought. A pair with a contact deeper than 2 d̂ at the start of
// a step recovers, and in the first step of a scene one that is closer than d̂/2 without overlap. In each of
// its contacts that starts at d₀ < d̂ − w, with w = min(V h, d̂ h/s + max(0, −d₀)) and V the speed,
//
//   Ψ(d) → q Ψ(d + s),   s = d̂ − w − d₀,   q = Ψ'(d₀)/Ψ'(d₀ + s)
//
// pushes at d₀ as hard as before, so that it carries the same load, and ends where the contact has opened by
// w. The pair recovers until its contacts are within w of d̂, or rest without overlap. Not for the log
// barrier, which has no overlap.
#pragma once

#include "sim/solver/problem.h"

namespace pabd {

// Finds the pairs that recover, by depth and by what contacts remember of the last step,
// and sets their contacts up. Precondition: the manifolds are those of the step, sorted by pair.
void start_recovery(const Problem& p, Iterate& it);

// The pair recovers from now on, from where its points are: what a hit pressed together holds no energy either.
void recover_from(const Problem& p, Lanes d, ContactManifold& manifold);

// Keeps ContactManifold::recovers where the recovery goes on after the step.
void finish_recovery(const Problem& p, Iterate& it);

}  // namespace pabd
