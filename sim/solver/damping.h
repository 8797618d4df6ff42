// SPDX-License-Identifier: MIT
// Damping of normal motion in contacts, `contact.damping` τ. The force is Ψ′ at d + τ ḋ: more while bodies come together, less
// while they part, and never a pull. At the end of a step of length h, ḋ = (d − d₀)/h makes that
//
//   f = Ψ′(g d + s)      g = 1 + τ/h, s = −τ/h min(d₀, d̂)
//
// the slope of Ψ(g d + s)/g. What comes from beyond d̂ is felt from d̂ on. Near rest it is the damper τ Ψ″ beside the spring Ψ″.
#pragma once

#include "sim/solver/problem.h"

namespace pabd {

// Those that do not come apart after a deep overlap, which have a speed of their own.
void damp_contacts(const Problem& p, Iterate& it);

}  // namespace pabd
