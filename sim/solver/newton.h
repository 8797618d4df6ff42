// The linear system of `newton`, and its iterations.
#pragma once

#include "sim/math/block_cholesky.h"
#include "sim/solver/solve.h"

namespace pabd {

// Kept from step to step for its memory and, while the graph of bodies stays, its symbolic factorisation.
// Neither influences a result.
struct NewtonSystem {
  std::vector<Index> row;    // body to block row, −1: not solved here
  Elimination::Pairs pairs;  // coupled block rows p < q, sorted
  BlockCholesky matrix;
  std::vector<Vec6> g, step;  // gradient of E; δ = (δc, δω)

  // Force on b of each bond of joints after the full step, by the linear model; N. Bond j of joint k is
  // number BondList::kMost k + j.
  std::vector<Vec3> force;

  // The best iterate so far.
  double lowest;  // E; J
  std::vector<Pose> best;
  int rises;      // iterations since
  bool searches;  // full steps went in circles: from then on each rise of E is answered by a line search
};

// Finds the structure of the matrix of w.newton. Islands whose factorisation would cost too much are given to
// `descent`; returns their number of bodies. After find_islands, before color_bodies.
Index prepare_newton(const Model& model, StepWorkspace::Impl& w);

// Before the first iteration of a step.
void start_newton(const SolveContext& s, NewtonSystem& system);

// One iteration for the bodies in w.newton; fills w.moved for them. `last`: no other will follow.
void newton_iteration(const SolveContext& s, bool last, NewtonSystem& system);

// E has changed: friction bounds moved. What was best under the old ones is no measure.
void forget_best(NewtonSystem& system);

// Goes back to the best iterate where the last one is worse.
void finish_newton(const SolveContext& s, NewtonSystem& system);

}  // namespace pabd
