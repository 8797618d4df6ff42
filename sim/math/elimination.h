// SPDX-License-Identifier: MIT
// The symbolic part of a sparse Cholesky factorisation: in which order the rows of a graph are eliminated,
// and which blocks of L fill.
//
// Leaves first, again and again, which leaves nothing of a tree and fills nothing; what remains is ordered by
// approximate minimum degree.
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "sim/math/types.h"

namespace pabd {

class Elimination {
 public:
  using Pairs = std::vector<std::pair<Index, Index>>;

  // `pairs`: coupled rows p < q of n, sorted, each once. Costs nothing where the graph stayed. False, and not
  // to be used, where a factorisation would take more than `most_products` products of two blocks.
  bool analyze(Index n, const Pairs& pairs, double most_products = std::numeric_limits<double>::infinity());

  Index rows() const { return static_cast<Index>(position_.size()); }
  std::size_t blocks() const { return row_.size(); }  // of L below the diagonal
  double products() const { return products_; }

  Index position(Index p) const { return position_[p]; }  // of a row in the order
  Index row_at(Index k) const { return row_at_[k]; }      // and back
  // Column k has blocks first(k) … first(k + 1) − 1, at the positions row(e), which rise.
  std::size_t first(Index k) const { return first_[k]; }
  Index row(std::size_t e) const { return row_[e]; }
  // The block at positions (row, column), which is there.
  std::size_t block(Index row, Index column) const;

 private:
  void order(Index n);
  void order_core(Index n);  // the rest, where every row has two neighbours or more
  bool find_fill(Index n, double most_products);

  Pairs pairs_;
  std::vector<Index> position_, row_at_, row_;
  std::vector<std::size_t> first_;
  double products_ = 0;
};

}  // namespace pabd
