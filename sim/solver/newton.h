// SPDX-License-Identifier: MIT
// `newton`: all bodies of an island at once. The linear system, and its iterations.
#pragma once

#include "sim/solver/coupled_matrix.h"
#include "sim/solver/dual_newton.h"
#include "sim/solver/island_step.h"
#include "sim/solver/sliding_tangent.h"
#include "sim/solver/workers.h"

namespace pabd {

// Of one island. Kept from step to step for its memory and, while the graph of bodies stays, its symbolic
// factorisation. Neither influences a result. Block rows are the bodies of the island.
struct NewtonSystem {
  Elimination::Pairs pairs;  // coupled block rows p < q, sorted
  CoupledMatrix matrix;
  IslandStep motion;

  // Gradient on b of each bond of joints after the full step, by the linear model; N. Bond j of the island's
  // joint k is number BondList::kMost k + j.
  std::vector<Vec3> force;

  double damping;  // full steps went in circles: inertia of the matrix is raised by so many times itself
  int iterations;
  bool curved;       // the matrix has ContactCurvature
  bool bounds_stay;  // friction bounds are no unknowns

  bool stuck;  // no step along the last direction lowered E
  SlidingTangent sliding;

  double most_products;  // of a factorisation

  // The same iteration with the forces of the joints as unknowns, while the island can be taken so.
  bool dual;
  DualSystem by_forces;
};

// Finds the structure of the island's matrix, of the dual one where it can. False where its factorisation
// would take more than `most_products` products of 6×6 blocks.
bool find_structure(const Problem& p, const Island& island, const Iterate& it, double most_products,
                    NewtonSystem& system);

// Before the first iteration of a step. Precondition: its structure is found.
void start_newton(const Problem& p, const Island& island, const Iterate& it, NewtonSystem& system);

// One iteration; fills it.moved for the bodies of the island. False where the island has become too dense (a contact came to
// what joints alone held together), or where its matrix is beyond all numbers.
bool newton_iteration(const Problem& p, const Island& island, const Workers& workers, NewtonSystem& system,
                      Iterate& it);

// Fills it.joint_force for the joints of the island with what the last iteration found.
void tell_forces(const Problem& p, const Island& island, const NewtonSystem& system, Iterate& it);

// E has changed: friction bounds moved. What was best under the old ones is no measure.
void forget_best(NewtonSystem& system);

// Goes back to the best iterate where the last one is worse.
void finish_newton(const Problem& p, const Island& island, NewtonSystem& system, Iterate& it);

}  // namespace pabd
