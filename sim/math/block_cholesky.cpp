#include "sim/math/block_cholesky.h"

#include <algorithm>

namespace pabd {
namespace {

using Column = Block6::Column;

Column load(const Vec6& x) { return Column{x[0], x[1], x[2], x[3], x[4], x[5], 0, 0}; }
void store(const Column& v, Vec6& x) {
  for (int r = 0; r < 6; ++r) x[r] = v[r];
}

double sum(const Column& v) { return ((v[0] + v[1]) + (v[2] + v[3])) + (v[4] + v[5]); }

constexpr Column kUnit[6] = {{1, 0, 0, 0, 0, 0, 0, 0}, {0, 1, 0, 0, 0, 0, 0, 0}, {0, 0, 1, 0, 0, 0, 0, 0},
                             {0, 0, 0, 1, 0, 0, 0, 0}, {0, 0, 0, 0, 1, 0, 0, 0}, {0, 0, 0, 0, 0, 1, 0, 0}};
constexpr Column kBelow[6] = {{0, 1, 1, 1, 1, 1, 0, 0}, {0, 0, 1, 1, 1, 1, 0, 0}, {0, 0, 0, 1, 1, 1, 0, 0},
                              {0, 0, 0, 0, 1, 1, 0, 0}, {0, 0, 0, 0, 0, 1, 0, 0}, {0, 0, 0, 0, 0, 0, 0, 0}};

// B ← L without its unit diagonal, zero above it; 1/D. False: not positive definite.
bool factorize_block(Block6& B, Column& inverse) {
  for (int j = 0; j < 6; ++j) {
    const double pivot = B.column[j][j];
    if (!(pivot > 0)) return false;
    inverse += (1 / pivot) * kUnit[j];
    const Column l = (1 / pivot) * B.column[j] * kBelow[j];
    for (int c = j + 1; c < 6; ++c) B.column[c] -= B.column[j] * l[c];
    B.column[j] = l;
  }
  return true;
}

// B ← B L⁻ᵀ: then B = (L D) of the column.
void divide_by_transpose(const Block6& L, Block6& B) {
  for (int j = 0; j < 5; ++j) {
    for (int c = j + 1; c < 6; ++c) B.column[c] -= B.column[j] * L.column[j][c];
  }
}

// C −= A Bᵀ.
void subtract_product(const Block6& A, const Block6& B, Block6& C) {
  for (int c = 0; c < 6; ++c) {
    Column sum = A.column[0] * B.column[0][c];
    for (int k = 1; k < 6; ++k) sum += A.column[k] * B.column[k][c];
    C.column[c] -= sum;
  }
}

// x ← L⁻¹ x and x ← L⁻ᵀ x.
void forward(const Block6& L, Column& x) {
  for (int j = 0; j < 5; ++j) x -= L.column[j] * x[j];
}
void backward(const Block6& L, Column& x) {
  for (int j = 4; j >= 0; --j) x -= sum(L.column[j] * x) * kUnit[j];
}

// x −= B y.
void subtract_times(const Block6& B, const Column& y, Column& x) {
  Column sum = B.column[0] * y[0];
  for (int c = 1; c < 6; ++c) sum += B.column[c] * y[c];
  x -= sum;
}

// y −= Bᵀ x.
void subtract_transposed_times(const Block6& B, const Column& x, Column& y) {
  for (int c = 0; c < 6; ++c) y -= sum(B.column[c] * x) * kUnit[c];
}

}  // namespace

bool BlockCholesky::analyze(Index n, const Elimination::Pairs& pairs, double most_products) {
  if (!graph_.analyze(n, pairs, most_products)) return false;
  diagonal_.resize(static_cast<std::size_t>(n));
  below_.resize(graph_.blocks());
  inverse_.resize(static_cast<std::size_t>(n));
  x_.resize(static_cast<std::size_t>(n));
  return true;
}

void BlockCholesky::set_zero() {
  std::fill(diagonal_.begin(), diagonal_.end(), Block6{});
  std::fill(below_.begin(), below_.end(), Block6{});
}

void BlockCholesky::add_off_diagonal(Index q, Index p, const Mat6& block) {
  const Index r = graph_.position(q), c = graph_.position(p);
  Block6& place = below_[graph_.block(std::max(r, c), std::min(r, c))];
  if (r > c) {
    place.add(block);
  } else {
    place.add(block.transpose());
  }
}

// A_ij −= (L D)_ik L_jkᵀ for all pairs of rows i ≥ j of column k.
void BlockCholesky::subtract_outer(Index k) {
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

bool BlockCholesky::factorize(const Stop& stop) {
  for (Index k = 0; k < rows(); ++k) {
    if (k % 64 == 0 && stop.requested()) return false;
    inverse_[k] = Column{};
    if (!factorize_block(diagonal_[k], inverse_[k])) return false;
    const std::size_t begin = graph_.first(k), count = graph_.first(k + 1) - begin;
    if (scaled_.size() < count) scaled_.resize(count);
    for (std::size_t e = 0; e < count; ++e) {
      Block6& block = below_[begin + e];
      divide_by_transpose(diagonal_[k], block);
      scaled_[e] = block;
      for (int c = 0; c < 6; ++c) block.column[c] *= inverse_[k][c];
    }
    subtract_outer(k);
  }
  return true;
}

void BlockCholesky::solve(std::vector<Vec6>& x) const {
  for (Index k = 0; k < rows(); ++k) x_[k] = load(x[graph_.row_at(k)]);
  for (Index k = 0; k < rows(); ++k) {
    forward(diagonal_[k], x_[k]);
    for (std::size_t e = graph_.first(k); e < graph_.first(k + 1); ++e)
      subtract_times(below_[e], x_[k], x_[graph_.row(e)]);
  }
  for (Index k = rows() - 1; k >= 0; --k) {
    Column y = x_[k] * inverse_[k];
    for (std::size_t e = graph_.first(k); e < graph_.first(k + 1); ++e)
      subtract_transposed_times(below_[e], x_[graph_.row(e)], y);
    backward(diagonal_[k], y);
    x_[k] = y;
    store(y, x[graph_.row_at(k)]);
  }
}

}  // namespace pabd
