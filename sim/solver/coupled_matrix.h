// SPDX-License-Identifier: MIT
// The matrix of `newton` with couplings: H + Σ s G Gᵀ, where G may be of four bodies. Theirs are no blocks of H; the
// identity of Sherman, Morrison and Woodbury solves with the factor of H instead:
//
//   (H + G S Gᵀ)⁻¹ y = x − Z (S⁻¹ + Gᵀ Z)⁻¹ Gᵀ x      x = H⁻¹ y,  Z = H⁻¹ G
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "sim/math/block_cholesky.h"
#include "sim/solver/couplings.h"
#include "sim/solver/islands.h"

namespace pabd {

// Entries are those of H.
class CoupledMatrix : public BlockCholesky<6> {
 public:
  // Forgets the couplings, but for their memory; adds one, its gradient to g, and returns its energy.
  void clear_couplings() { count_ = 0; }
  double add(const Island& island, const LinearCoupling& coupling, std::vector<Vec6>& g);

  // As those of H.
  bool factorize(const Stop& stop);
  void solve(std::vector<Vec6>& y) const;

 private:
  struct End {
    Index row;
    Vec6 G;
  };
  struct Coupling {
    double stiffness;
    std::array<End, 4> ends;
    int count;
    std::vector<Vec6> Z;
  };
  static double along(const Coupling& coupling, const std::vector<Vec6>& x);

  std::vector<Coupling> couplings_;  // the first count_ are those of the matrix
  std::size_t count_ = 0;
  Eigen::MatrixXd small_;
  Eigen::LDLT<Eigen::MatrixXd> factor_;
  mutable Eigen::VectorXd share_;
};

}  // namespace pabd
