// SPDX-License-Identifier: MIT
#include "sim/math/elimination.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>

#include "sim/math/row_list.h"

namespace pabd {

bool Elimination::analyze(Index n, const Pairs& pairs, double most_products) {
  if (rows() == n && pairs_ == pairs) return products_ <= most_products;
  pairs_ = pairs;
  order(n);
  if (find_fill(n, most_products)) return true;
  position_.clear();  // half done: nothing to keep
  return false;
}

// Leaves first, again and again: that leaves nothing of a tree and fills nothing. What remains is ordered by
// approximate minimum degree.
void Elimination::order(Index n) {
  const auto rows = static_cast<std::size_t>(n);
  RowList<Index> neighbors;
  neighbors.fill(rows, [&](const auto& visit) {
    for (const auto& [p, q] : pairs_) {
      visit(p, q);
      visit(q, p);
    }
  });
  std::vector<std::size_t> degree(rows);
  for (Index p = 0; p < n; ++p) degree[p] = neighbors[p].size();
  row_at_.clear();
  position_.assign(rows, -1);
  const auto eliminate = [&](Index p) {
    position_[p] = static_cast<Index>(row_at_.size());
    row_at_.push_back(p);
  };
  for (Index p = 0; p < n; ++p) {
    if (degree[p] <= 1 && position_[p] < 0) eliminate(p);
  }
  for (std::size_t k = 0; k < row_at_.size(); ++k) {
    for (const Index q : neighbors[row_at_[k]])
      if (position_[q] < 0 && --degree[q] <= 1) eliminate(q);
  }
  if (row_at_.size() < rows) order_core(n);
}

void Elimination::order_core(Index n) {
  std::vector<Index> core, number(static_cast<std::size_t>(n), -1);
  for (Index p = 0; p < n; ++p) {
    if (position_[p] >= 0) continue;
    number[p] = static_cast<Index>(core.size());
    core.push_back(p);
  }
  std::vector<Eigen::Triplet<int, Index>> entries;
  for (Index k = 0; k < static_cast<Index>(core.size()); ++k) entries.emplace_back(k, k, 1);  // AMD wants it
  for (const auto& [p, q] : pairs_) {
    if (number[p] >= 0 && number[q] >= 0) entries.emplace_back(number[q], number[p], 1);
  }
  const auto size = static_cast<Index>(core.size());
  Eigen::SparseMatrix<int> graph(size, size);
  graph.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> elimination;
  Eigen::AMDOrdering<int>()(graph.selfadjointView<Eigen::Lower>(), elimination);
  for (Index k = 0; k < size; ++k) {
    const Index p = core[elimination.indices()[k]];
    position_[p] = static_cast<Index>(row_at_.size());
    row_at_.push_back(p);
  }
}

// Rows of column k: those of A below it, and those of the columns whose first row is k.
bool Elimination::find_fill(Index n, double most_products) {
  const auto columns = static_cast<std::size_t>(n);
  std::vector<std::pair<Index, Index>> entries;  // (column, row) of A
  entries.reserve(pairs_.size());
  for (const auto& [p, q] : pairs_) entries.push_back(std::minmax(position_[p], position_[q]));
  std::sort(entries.begin(), entries.end());

  first_.assign(columns + 1, 0);
  row_.clear();
  products_ = 0;
  std::vector<Index> child(columns, -1), next_child(columns, -1);  // lists of the elimination tree
  std::vector<Index> seen(columns, -1);
  auto entry = entries.begin();
  for (Index k = 0; k < n; ++k) {
    const std::size_t start = row_.size();
    const auto visit = [&](Index r) {
      if (r <= k || seen[r] == k) return;
      seen[r] = k;
      row_.push_back(r);
    };
    for (; entry != entries.end() && entry->first == k; ++entry) visit(entry->second);
    for (Index c = child[k]; c >= 0; c = next_child[c]) {
      for (std::size_t e = first_[c]; e < first_[c + 1]; ++e) visit(row_[e]);
    }
    std::sort(row_.begin() + static_cast<std::ptrdiff_t>(start), row_.end());
    first_[k + 1] = row_.size();
    const auto count = static_cast<double>(row_.size() - start);
    products_ += 0.5 * count * (count + 1);
    if (products_ > most_products) return false;
    if (count == 0) continue;
    const Index parent = row_[start];
    next_child[k] = child[parent];
    child[parent] = k;
  }
  return true;
}

std::size_t Elimination::block(Index row, Index column) const {
  const auto begin = row_.begin() + static_cast<std::ptrdiff_t>(first_[column]);
  const auto end = row_.begin() + static_cast<std::ptrdiff_t>(first_[column + 1]);
  return static_cast<std::size_t>(std::lower_bound(begin, end, row) - row_.begin());
}

}  // namespace pabd
