// SPDX-License-Identifier: MIT
// `newton`: all bodies of an island at once, in the tangent space of SE(3): δ = (δc, δω) of each body, R ← cayley(δω) R. In the
// order of a step:
//
//   find_structure    couplings of block rows, elimination order; asked by choice.cpp, whether it is cheap enough
//   start_newton
//   newton_iteration
//     while only ball joints hold the island together, the step from their forces     dual_newton
//     else the matrix at the iterate                                     newton_matrix, linear_bonds, coupled_matrix
//       its direction; friction bounds and holds of motors at the end of it            sliding_tangent, joint_actions
//       that step in full, or searched along a line; the best iterate so far           island_step
//   finish_newton     back to the best iterate where the last one is worse
//
//   matrix   inertia m/h², (tr(X) 1 − X_s)/h²; Gauss–Newton blocks s_i s_j J_iᵀ K J_j of the bonds with J = [1, −[r]]; the
//            geometric stiffness of joints, and of contacts where a few iterations do not suffice, while that leaves it positive
//            definite
//   step     full, turns limited to 1 rad: with stiff joints E is a narrow curved valley, in which a line search creeps. Where E
//            stays above its lowest value for too long, back to that iterate (a watchdog), and on from there with inertia raised
//            (Levenberg and Marquardt): light links under a heavy weight jump far before joints and contacts carry them.
//            Contacts alone and soft pulls always need a line search
#pragma once

#include "sim/solver/coupled_matrix.h"
#include "sim/solver/dual_newton.h"
#include "sim/solver/island_step.h"
#include "sim/solver/rest.h"
#include "sim/solver/sliding_tangent.h"
#include "sim/solver/workers.h"

namespace pabd {

// Of one island. Kept from step to step for its memory and, while the graph of bodies stays, its symbolic
// factorisation. Neither influences a result. Block rows are the bodies of the island.
struct NewtonSystem {
  Elimination::Pairs pairs;  // coupled block rows p < q, sorted
  CoupledMatrix matrix;
  IslandStep motion;
  RestMemory rest;

  // Gradient on b of each bond of joints after the full step, by the linear model; N. Bond j of the island's
  // joint k is number BondList::kMost k + j.
  std::vector<Vec3> force;

  double damping;  // full steps went in circles: inertia of the matrix is raised by so many times itself
  int iterations;
  bool curved;       // the matrix has ContactCurvature
  bool bounds_stay;  // friction bounds are no unknowns
  double
      nearest_move;  // largest move of the iteration nearest_at, the last one that halved it or began a turn; d̂
  int nearest_at;

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
// what joints alone held together), or where its matrix is not finite.
bool newton_iteration(const Problem& p, const Island& island, const Workers& workers, NewtonSystem& system,
                      Iterate& it);

// Fills it.joint_force for the joints of the island with what the last iteration found.
void store_joint_forces(const Problem& p, const Island& island, const NewtonSystem& system, Iterate& it);

// E has changed: friction bounds moved. What was best under the old ones is no measure.
void forget_best(NewtonSystem& system);

// Goes back to the best iterate where the last one is worse.
void finish_newton(const Problem& p, const Island& island, NewtonSystem& system, Iterate& it);

}  // namespace pabd
