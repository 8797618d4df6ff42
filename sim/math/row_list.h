// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sim/math/types.h"

namespace pabd {

// Lists of unequal length in one array: row i is items[first[i]] … items[first[i + 1] − 1].
template <class Item>
struct RowList {
  std::vector<Index> first;
  std::vector<Item> items;

  std::span<const Item> operator[](Index i) const {
    const auto k = static_cast<std::size_t>(i);
    return {items.data() + first[k], static_cast<std::size_t>(first[k + 1] - first[k])};
  }

  // Fills `rows` rows: each(visit) calls visit(row, item) for all items, twice, in the order within the rows.
  template <class Each>
  void fill(std::size_t rows, const Each& each) {
    first.assign(rows + 2, 0);
    each([&](Index row, const Item&) { ++first[static_cast<std::size_t>(row) + 2]; });
    for (std::size_t k = 2; k < first.size(); ++k) first[k] += first[k - 1];
    items.resize(static_cast<std::size_t>(first.back()));
    each([&](Index row, const Item& item) { items[first[static_cast<std::size_t>(row) + 1]++] = item; });
    first.pop_back();
  }
};

}  // namespace pabd
