// SPDX-License-Identifier: MIT
// What one time step reports.
#pragma once

#include <vector>

#include "sim/math/types.h"
#include "sim/solver/params.h"

namespace pabd {

// From good to bad. non_finite: a result is not finite, or the step threw a body out of all bounds (runaway.h).
enum class StepStatus : std::uint8_t { converged, iteration_limit, non_finite, interrupted };
const char* to_string(StepStatus status);  // "converged", "iteration_limit", "non_finite", "interrupted"

// State after one iteration of the solver.
struct IterationRecord {
  double energy;                  // incremental potential E; J
  double residual;                // relative step: largest displacement of a body in this iteration over d̂
  double max_penetration_before;  // max(0, −d) over contacts after the affine step, before the projection; m
  double max_penetration_after;   // the same after the projection onto SO(3); m
  double min_gap_before;          // smallest d before and after the projection; m; +inf without contacts
  double min_gap_after;
  double max_joint_error;    // m
  double projection_change;  // largest ‖A − R‖ (Frobenius) over bodies
};

// One contact at the end of a step, in world coordinates.
struct ContactReport {
  Index a, b;           // a owns the normal
  Vec3 y_a, y_b;        // the two points; d = (y_b − y_a)·n
  Vec3 n;               // unit, from a to b
  double d;             // m
  double normal_force;  // f_n = −Ψ'(d) ≥ 0; N
  Vec3 friction;        // friction force on b; N
  bool sticking;
  double mu;  // coefficient of the step: static, or dynamic where the pair of bodies slides
};

// One body at the end of a step.
struct BodyReport {
  // ‖A − R‖ (Frobenius) and det A of the last iteration of `sissm`, A damped as the iterate is. The other
  // solvers have no A: 0 and 1, as for bodies that nothing touches.
  double projection_change = 0;
  double det_A = 1;
  // Number of the component of bodies that hang together through joints or contacts within reach, counted
  // from 0 in order of their lowest body; −1 for a fixed body and for one that has no bonds.
  Index island = -1;
  SolverMethod solver = SolverMethod::descent;  // sissm, descent or newton; only where there is an island
  double residual = 0;                          // of that island; d̂
  int contacts = 0;                             // with d < d̂
  double contact_energy = 0;                    // half of the energy of each of them, Ψ and friction; J
};

// What the first body of a joint does to the second one through it, at the end of a step; world axes.
struct JointReport {
  Vec3 force = Vec3::Zero();   // N
  Vec3 moment = Vec3::Zero();  // about the joint's anchor on the first body; N m
  Vec3 axis = Vec3::UnitX();   // of the joint, with the first body; unit
  double error = 0;            // largest distance between points that it holds together; m
  double coupling = 0;         // what the joint that it follows drives its angle or offset with; N m or N
};

// One island of bodies that hang together, as it was solved.
struct IslandReport {
  Index first_body;  // its lowest
  Index bodies, manifolds, joints;
  SolverMethod solver;  // sissm, descent or newton
  StepStatus status;
  int iterations;
  double residual;  // largest way of a body in the last iteration over d̂; where the moves of `newton` shrink
                    // quadratically that of the next one, extrapolated
  // Of an island that was made again in halves: the worst of them.
  double friction_error =
      0;  // of a step at the iteration limit: how far a friction force is from Coulomb's law, as a
          // share of μ f_n or of μ times the lighter body's weight

  // Did its bodies stay where they were, without an iteration (rest.h)?
  bool rests() const { return status == StepStatus::converged && iterations == 0; }
};

// Wall clock; ms. The first four add up to the total of a step that was made.
struct PhaseTimes {
  double detect = 0;      // contact points: broad and narrow phase, manifolds
  double set_up = 0;      // free flight, islands, colours, friction, first iterate
  double solve = 0;       // the iterations
  double velocities = 0;  // velocities, momentum, energies, reports
  double total = 0;

  PhaseTimes& operator+=(const PhaseTimes& other) {
    detect += other.detect;
    set_up += other.set_up;
    solve += other.solve;
    velocities += other.velocities;
    total += other.total;
    return *this;
  }
};

// A step in numbers of a fixed size: what the past of a run keeps of it.
struct StepSummary {
  std::int64_t step = 0;                        // number of the step just done (first: 1)
  double time = 0;                              // at its end; s
  SolverMethod method = SolverMethod::descent;  // `auto`: the one that ended most bodies
  StepStatus status = StepStatus::iteration_limit;
  int iterations = 0;           // of the island that needed most
  double kinetic = 0;           // J
  double potential = 0;         // −Σ m g·c; J
  double elastic = 0;           // energy in contacts, bonds and springs; J
  double kappa = 0;             // resolved contact κ; J
  int contacts = 0;             // with d < d̂
  double max_penetration = 0;   // m
  double min_gap = 0;           // m; +inf without contacts
  double max_normal_force = 0;  // of one contact point; N
  double max_joint_error = 0;   // m
  double residual = 0;          // the largest of the islands
  // What was skipped because it would cost too much: pairs of bodies in crowds that were not looked at, overlap
  // or not (collision/broad_phase.h), and bodies that `descent` solved in place of `newton` (choice.h).
  std::int64_t left_pairs = 0;
  Index too_dense = 0;
  double drive_work =
      0;  // of drives, motors, dampers and friction of joints, belts and forces from outside; J
  int capped_bonds = 0;   // joints and contact points that `sissm` made softer than asked (sissm.h)
  int held_bodies = 0;    // that were slowed down so that no energy is made (energy_bound.h)
  int halved_bodies = 0;  // whose step was made again in halves (halving.h)
  int halvings = 0;       // how often it was halved, at most
  // Coulomb's law: largest ‖friction‖/(μ f_n) − 1 of the contacts that carry more than 1e-3 of the heaviest
  // weight (of less loaded ones: with that load), 0 where all obey. At most 0.01 in a step that converged.
  double friction_excess = 0;
  PhaseTimes times;
};

// The summary, and the details that a step is asked for.
struct StepReport : StepSummary {
  std::vector<IslandReport> islands;     // in order of their lowest bodies
  std::vector<IterationRecord> records;  // one an iteration; empty unless StepOptions::record_iterations
  IterationRecord first_iterate{};       // before the first iteration, filled together with `records`
  std::vector<ContactReport>
      contact_reports;  // contacts with d < d̂; empty unless StepOptions::report_contacts
  // One a body, in order of number; empty unless StepOptions::report_bodies, or when the step failed.
  std::vector<BodyReport> body_reports;
  // One a joint of the model, in order of number; empty unless StepOptions::report_joints, or when the step
  // failed.
  std::vector<JointReport> joint_reports;

  const StepSummary& summary() const { return *this; }
};

}  // namespace pabd
