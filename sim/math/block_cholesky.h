// Cholesky factorisation A = L D Lᵀ of a sparse symmetric positive definite matrix of 6×6 blocks.
//
//   analyze        elimination order and fill (elimination.h)
//   diagonal, …    A is written where L will stand
//   factorize      column by column (right-looking); L has a unit diagonal
//   solve          A x = b in place
//
// On a chain or a tree nothing fills, and the work is linear in the number of block rows.
#pragma once

#include <vector>

#include "sim/math/elimination.h"
#include "sim/math/stop.h"

namespace pabd {

// A 6×6 block by columns of eight: whole vector instructions, two lanes to spare.
struct Block6 {
  using Column = double __attribute__((vector_size(8 * sizeof(double))));
  Column column[6];

  void set_zero() { *this = Block6{}; }
  double operator()(int r, int c) const { return column[c][r]; }
  void add(const Mat6& B) {
    for (int c = 0; c < 6; ++c) {
      for (int r = 0; r < 6; ++r) column[c][r] += B(r, c);
    }
  }
};

class BlockCholesky {
 public:
  // As Elimination::analyze: false, and not to be used, where it would cost more.
  bool analyze(Index n, const Elimination::Pairs& pairs,
               double most_products = std::numeric_limits<double>::infinity());

  Index rows() const { return graph_.rows(); }
  const Elimination& graph() const { return graph_; }

  void set_zero();
  Block6& diagonal(Index p) { return diagonal_[graph_.position(p)]; }  // its lower triangle counts
  // Adds `block` (rows q, columns p) and its transpose; p ≠ q, coupled.
  void add_off_diagonal(Index q, Index p, const Mat6& block);

  // False where A is not positive definite, or when stopped; it is destroyed either way.
  bool factorize(const Stop& stop = {});
  void solve(std::vector<Vec6>& x) const;  // x: block rows in the caller's order

 private:
  void subtract_outer(Index k);

  Elimination graph_;
  std::vector<Block6> diagonal_;  // then L_kk without its unit diagonal
  std::vector<Block6> below_;
  std::vector<Block6> scaled_;             // scratch of a column: L D
  std::vector<Block6::Column> inverse_;    // 1/D
  mutable std::vector<Block6::Column> x_;  // scratch of solve
};

}  // namespace pabd
