// The linear system of `newton` and one iteration.
#pragma once

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include "sim/solver/solve.h"

namespace pabd {

// Kept from step to step for its memory and, while the graph of bodies stays, its symbolic factorisation.
// Neither influences a result.
struct NewtonSystem {
  Index bodies = -1;
  std::vector<Index> row;                                  // body to block row, −1: not solved here
  std::vector<std::pair<Index, Index>> pairs, next_pairs;  // coupled block rows p < q, sorted
  std::vector<Index> first_pair;
  std::vector<Pose> from;
  Eigen::SparseMatrix<double> H;  // lower triangle
  Eigen::VectorXd g, step;
  std::vector<Vec3> force;  // on b of each bond, predicted by the last linear solve; N
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> cholesky;
};

// One Newton step of the bodies in w.newton. Fills w.moved for them.
void newton_iteration(const SolveContext& s, NewtonSystem& system);

}  // namespace pabd
