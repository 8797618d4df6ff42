// SPDX-License-Identifier: MIT
// Restitution (Deviation D29): what hits bounces with e times the speed it came with, whatever the barrier is like.
//
// A step of E is inelastic. Where bodies come faster than what a step knows as rest, 2 g h, and e > 0, the velocities at its end
// are replaced by those of an impact at its poses; v⁻ is what bodies would have there if nothing had touched them, by the
// energy of free flight. Contacts that approach reflect together, v ← v + (1 + e) M⁻¹ Jᵀ λ with λ ≥ 0 ⊥ J (v + M⁻¹ Jᵀ λ) ≥ 0,
// until none does ("generalized reflections": Smith et al., Reflections on Simultaneous Impact, 2012). Friction gets its share
// of those impulses at the end, by Coulomb's law. Joints hold: M is then that of all bodies that they join, M + h² Σ Jᵀ K J with
// the stiffness K of their bonds. What bounced is not pushed again while it parts faster than e times that speed.
#pragma once

#include "sim/solver/islands.h"
#include "sim/solver/velocities.h"

namespace pabd {

// Does any pair of bodies bounce?
bool has_restitution(const Model& model, const ContactParams& contact);

// Of two bodies, of their own or contact.restitution, made one as friction is; 0 … 1.
double restitution_between(const Model& model, const ContactParams& contact, Index a, Index b);

// Releases contact points that part where the step starts: their barriers push no more in it.
void release_parting_contacts(const Problem& p, Iterate& it);

// Velocities after the impacts of an island; points that part after them push no more. Nothing where nothing hits.
// Precondition: the iterate is the end of the step, `velocities` those of it.
void bounce(const Problem& p, const Island& island, Velocities& velocities, Iterate& it);

}  // namespace pabd
