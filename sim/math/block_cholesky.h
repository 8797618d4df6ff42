// SPDX-License-Identifier: MIT
// Cholesky factorisation A = L D Lᵀ of a sparse symmetric positive definite matrix of N×N blocks, N = 3 or 6.
//
//   analyze        elimination order and fill (elimination.h)
//   diagonal, …    A is written where L will stand
//   factorize      column by column (right-looking); L has a unit diagonal
//   solve          A x = b in place
//
// On a chain or a tree nothing fills, and the work is linear in the number of block rows.
#pragma once

#include <type_traits>
#include <vector>

#include "sim/math/elimination.h"
#include "sim/math/stop.h"

namespace pabd {

// An N×N block by columns of four or eight: whole vector instructions, some lanes to spare.
using Four = double __attribute__((vector_size(4 * sizeof(double))));
using Eight = double __attribute__((vector_size(8 * sizeof(double))));
template <int N>
struct alignas(N <= 4 ? sizeof(Four) : sizeof(Eight)) Block {
  using Column = std::conditional_t<(N <= 4), Four, Eight>;
  using Matrix = Eigen::Matrix<double, N, N>;
  using Vector = Eigen::Matrix<double, N, 1>;
  Column column[N];

  void add(const Matrix& B) {
    for (int c = 0; c < N; ++c) {
      for (int r = 0; r < N; ++r) column[c][r] += B(r, c);
    }
  }
};

template <int N>
class BlockCholesky {
 public:
  using Column = typename Block<N>::Column;
  using Matrix = typename Block<N>::Matrix;
  using Vector = typename Block<N>::Vector;

  // As Elimination::analyze: false, and not to be used, where it would cost more.
  bool analyze(Index n, const Elimination::Pairs& pairs,
               double most_products = std::numeric_limits<double>::infinity());

  Index rows() const { return graph_.rows(); }
  const Elimination& graph() const { return graph_; }

  void set_zero();
  Block<N>& diagonal(Index p) { return diagonal_[graph_.position(p)]; }  // its lower triangle counts
  // Adds `block` (rows q, columns p) and its transpose; p ≠ q, coupled.
  void add_off_diagonal(Index q, Index p, const Matrix& block);

  // False where A is not positive definite, or when stopped; it is destroyed either way.
  bool factorize(const Stop& stop = {});
  void solve(std::vector<Vector>& x) const;  // x: block rows in the caller's order

 private:
  struct alignas(sizeof(Column)) Row {
    Column value;
  };

  bool factorize_columns(const Stop& stop);
  void subtract_outer(Index k);
  void solve_rows(std::vector<Vector>& x) const;

  Elimination graph_;
  std::vector<Block<N>> diagonal_;  // then L_kk without its unit diagonal
  std::vector<Block<N>> below_;
  std::vector<Block<N>> scaled_;  // scratch of a column: L D
  std::vector<Row> inverse_;      // 1/D
  mutable std::vector<Row> x_;    // scratch of solve
};

template <>
bool BlockCholesky<3>::factorize(const Stop& stop);
template <>
bool BlockCholesky<6>::factorize(const Stop& stop);
template <>
void BlockCholesky<3>::solve(std::vector<Vector>& x) const;
template <>
void BlockCholesky<6>::solve(std::vector<Vector>& x) const;
extern template class BlockCholesky<3>;
extern template class BlockCholesky<6>;

}  // namespace pabd
