// SPDX-License-Identifier: MIT
// Numbers that a step reports about the state it ends in.
#pragma once

#include "sim/body/state.h"
#include "sim/solver/problem.h"
#include "sim/solver/report.h"

namespace pabd {

// Of body i with rotation R; J.
double kinetic_energy(const Model& model, Index i, const Mat3& R, const Vec3& v, const Vec3& omega);

// Kinetic and potential energy of all movable bodies; J. E_kin = ½ m v² + ½ ωᵀ R I Rᵀ ω, E_pot = −m g·c.
double kinetic_energy(const Model& model, const State& state);
double potential_energy(const Model& model, const Params& params, const State& state);

// Of the springs of all joints; J.
double spring_energy(const Model& model, const State& state);

// elastic, contacts, max_penetration, min_gap, friction_excess and, if asked, contact_reports at the iterate.
void summarize_contacts(const Problem& p, const Iterate& it, bool with_reports, StepReport& report);

}  // namespace pabd
