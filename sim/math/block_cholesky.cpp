// SPDX-License-Identifier: MIT
#include "sim/math/block_cholesky.h"

#include <algorithm>

#include "sim/math/levels.h"

namespace pabd {
namespace {

template <int N>
using Column = typename Block<N>::Column;

template <int N>
Column<N> load(const typename Block<N>::Vector& x) {
  Column<N> out{};
  for (int r = 0; r < N; ++r) out[r] = x[r];
  return out;
}
template <int N>
void store(const Column<N>& v, typename Block<N>::Vector& x) {
  for (int r = 0; r < N; ++r) x[r] = v[r];
}

template <int N>
double sum(const Column<N>& v) {
  if constexpr (N == 3) return v[0] + v[1] + v[2];
  if constexpr (N == 6) return ((v[0] + v[1]) + (v[2] + v[3])) + (v[4] + v[5]);
}

// 1 in lane k; 1 in the lanes below k.
template <int N>
Column<N> unit(int k) {
  Column<N> out{};
  out[k] = 1;
  return out;
}
template <int N>
Column<N> below(int k) {
  Column<N> out{};
  for (int r = k + 1; r < N; ++r) out[r] = 1;
  return out;
}

// B ← L without its unit diagonal, zero above it; 1/D. False: not positive definite.
template <int N>
bool factorize_block(Block<N>& B, Column<N>& inverse) {
  for (int j = 0; j < N; ++j) {
    const double pivot = B.column[j][j];
    if (!(pivot > 0)) return false;
    inverse += (1 / pivot) * unit<N>(j);
    const Column<N> l = (1 / pivot) * B.column[j] * below<N>(j);
    for (int c = j + 1; c < N; ++c) B.column[c] -= B.column[j] * l[c];
    B.column[j] = l;
  }
  return true;
}

// B ← B L⁻ᵀ: then B = (L D) of the column.
template <int N>
void divide_by_transpose(const Block<N>& L, Block<N>& B) {
  for (int j = 0; j < N - 1; ++j) {
    for (int c = j + 1; c < N; ++c) B.column[c] -= B.column[j] * L.column[j][c];
  }
}

// C −= A Bᵀ.
template <int N>
void subtract_product(const Block<N>& A, const Block<N>& B, Block<N>& C) {
  for (int c = 0; c < N; ++c) {
    Column<N> sum = A.column[0] * B.column[0][c];
    for (int k = 1; k < N; ++k) sum += A.column[k] * B.column[k][c];
    C.column[c] -= sum;
  }
}

// x ← L⁻¹ x and x ← L⁻ᵀ x.
template <int N>
void forward(const Block<N>& L, Column<N>& x) {
  for (int j = 0; j < N - 1; ++j) x -= L.column[j] * x[j];
}
template <int N>
void backward(const Block<N>& L, Column<N>& x) {
  for (int j = N - 2; j >= 0; --j) x -= sum<N>(L.column[j] * x) * unit<N>(j);
}

// x −= B y.
template <int N>
void subtract_times(const Block<N>& B, const Column<N>& y, Column<N>& x) {
  Column<N> sum = B.column[0] * y[0];
  for (int c = 1; c < N; ++c) sum += B.column[c] * y[c];
  x -= sum;
}

// y −= Bᵀ x.
template <int N>
void subtract_transposed_times(const Block<N>& B, const Column<N>& x, Column<N>& y) {
  for (int c = 0; c < N; ++c) y -= sum<N>(B.column[c] * x) * unit<N>(c);
}

}  // namespace

template <int N>
bool BlockCholesky<N>::analyze(Index n, const Elimination::Pairs& pairs, double most_products) {
  if (!graph_.analyze(n, pairs, most_products)) return false;
  diagonal_.resize(static_cast<std::size_t>(n));
  below_.resize(graph_.blocks());
  inverse_.resize(static_cast<std::size_t>(n));
  x_.resize(static_cast<std::size_t>(n));
  return true;
}

template <int N>
void BlockCholesky<N>::set_zero() {
  std::fill(diagonal_.begin(), diagonal_.end(), Block<N>{});
  std::fill(below_.begin(), below_.end(), Block<N>{});
}

template <int N>
void BlockCholesky<N>::add_off_diagonal(Index q, Index p, const Matrix& block) {
  const Index r = graph_.position(q), c = graph_.position(p);
  Block<N>& place = below_[graph_.block(std::max(r, c), std::min(r, c))];
  if (r > c) {
    place.add(block);
  } else {
    place.add(block.transpose());
  }
}

// A_ij −= (L D)_ik L_jkᵀ for all pairs of rows i ≥ j of column k.
template <int N>
void BlockCholesky<N>::subtract_outer(Index k) {
  const std::size_t begin = graph_.first(k), end = graph_.first(k + 1);
  for (std::size_t j = begin; j < end; ++j) {
    subtract_product(scaled_[j - begin], below_[j], diagonal_[graph_.row(j)]);
    std::size_t at =
        graph_.first(graph_.row(j));  // all further rows are in that column too, in the same order
    for (std::size_t i = j + 1; i < end; ++i, ++at) {
      while (graph_.row(at) != graph_.row(i)) ++at;
      subtract_product(scaled_[i - begin], below_[j], below_[at]);
    }
  }
}

template <int N>
bool BlockCholesky<N>::factorize_columns(const Stop& stop) {
  for (Index k = 0; k < rows(); ++k) {
    if (k % 64 == 0 && stop.requested()) return false;
    inverse_[k].value = Column{};
    if (!factorize_block(diagonal_[k], inverse_[k].value)) return false;
    const std::size_t begin = graph_.first(k), count = graph_.first(k + 1) - begin;
    if (scaled_.size() < count) scaled_.resize(count);
    for (std::size_t e = 0; e < count; ++e) {
      Block<N>& block = below_[begin + e];
      divide_by_transpose(diagonal_[k], block);
      scaled_[e] = block;
      for (int c = 0; c < N; ++c) block.column[c] *= inverse_[k].value[c];
    }
    subtract_outer(k);
  }
  return true;
}

template <int N>
void BlockCholesky<N>::solve_rows(std::vector<Vector>& x) const {
  for (Index k = 0; k < rows(); ++k) x_[k].value = load<N>(x[graph_.row_at(k)]);
  for (Index k = 0; k < rows(); ++k) {
    forward(diagonal_[k], x_[k].value);
    for (std::size_t e = graph_.first(k); e < graph_.first(k + 1); ++e)
      subtract_times(below_[e], x_[k].value, x_[graph_.row(e)].value);
  }
  for (Index k = rows() - 1; k >= 0; --k) {
    Column y = x_[k].value * inverse_[k].value;
    for (std::size_t e = graph_.first(k); e < graph_.first(k + 1); ++e)
      subtract_transposed_times(below_[e], x_[graph_.row(e)].value, y);
    backward(diagonal_[k], y);
    x_[k].value = y;
    store<N>(y, x[graph_.row_at(k)]);
  }
}

template <>
PABD_EACH_LEVEL bool BlockCholesky<3>::factorize(const Stop& stop) {
  return factorize_columns(stop);
}
template <>
PABD_EACH_LEVEL bool BlockCholesky<6>::factorize(const Stop& stop) {
  return factorize_columns(stop);
}
template <>
PABD_EACH_LEVEL void BlockCholesky<3>::solve(std::vector<Vector>& x) const {
  solve_rows(x);
}
template <>
PABD_EACH_LEVEL void BlockCholesky<6>::solve(std::vector<Vector>& x) const {
  solve_rows(x);
}

template class BlockCholesky<3>;
template class BlockCholesky<6>;

}  // namespace pabd
