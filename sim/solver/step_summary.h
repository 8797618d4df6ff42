// SPDX-License-Identifier: MIT
// What a step reports about the state it ends in: energies and gaps, and on demand each contact, body and joint.
#pragma once

#include "sim/body/state.h"
#include "sim/solver/problem.h"
#include "sim/solver/report.h"

namespace pabd {

struct Islands;
struct SissmMemory;

// Of body i with rotation R; J.
double kinetic_energy(const Model& model, Index i, const Mat3& R, const Vec3& v, const Vec3& omega);

// Kinetic and potential energy of all movable bodies; J. E_kin = ½ m v² + ½ ωᵀ R I Rᵀ ω, E_pot = −m g·c.
double kinetic_energy(const Model& model, const State& state);
double potential_energy(const Model& model, const Params& params, const State& state);

// Of the springs of all joints; J.
double spring_energy(const Model& model, const State& state);

// elastic, contacts, max_penetration, min_gap, max_normal_force, friction_excess and, if asked, contact_reports at the iterate.
void summarize_contacts(const Problem& p, const Iterate& it, bool with_reports, StepReport& report);

// One report a body of the model, at the end of a step. Every body has its contacts; the island and what solved
// it (`solved`, one entry an island) are there for bodies of an island, what the projection changed for those
// that `sissm` solved.
void report_bodies(const Problem& p, const Islands& islands, const std::vector<IslandReport>& solved,
                   const Iterate& it, const SissmMemory& sissm, std::vector<BodyReport>& out);

// One report a joint of the model, in order of number: the sums of the forces of its bonds at the iterate,
// which are those that the step was made with where it converged. `solved`: of each joint what the solver
// found (State::joint_force); joints with one bond report that. Pulls are none of them.
void report_joints(const Problem& p, const Iterate& it, const std::vector<Vec3>& solved,
                   const Workers& workers, std::vector<JointReport>& out);

}  // namespace pabd
