// SPDX-License-Identifier: MIT
// The curves of a barrier figure: every combination of the lists, and what distinguishes them: colour, dashes, rows.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/plots/figures/barrier_figure.h"
#include "sim/solver/parameter_table.h"

namespace pabd::barrier_family {

inline constexpr std::size_t kColors = 6;   // of the palette; the last one is for kinds without orders
inline constexpr std::size_t kShades = 12;  // of a ramp: more could not be told apart
inline constexpr int kPlain = 6;

// What can have several values.
enum Dim : std::uint8_t { orders, thickness, gaps, kind, stiffness, kDims };
using Index5 = std::array<std::size_t, kDims>;

struct Family {
  BarrierCurves in;  // every list has an entry
  bool energy = false;
  Index5 count{};  // values of each that curves have
  std::optional<Dim> color, dash;
  std::vector<std::array<std::pair<std::size_t, std::size_t>, kDims>> rows;  // begin and end of each
};

Dim dim_of(BarrierAbscissa abscissa);
bool has_orders(BarrierKind kind);
Family family_of(const BarrierCurves& curves);

// The colour of value i of what is told apart by colour: kinds have some of the palette, what is in order has a ramp
// over all rows. `color` and `ramp` of a Series or PlotKey.
std::pair<int, int> color_of(const Family& family, std::size_t i);

// Whether a combination is a curve of its own: kinds without orders have one for all N, the even barrier one
// for 2n and 2n + 1 and none below 2.
bool is_curve(const Family& family, const Index5& at, std::size_t first_order);

// The curves of a row, as the numbers of their values.
template <class Visit>
void for_each_curve(const Family& f, std::size_t row, const Visit& visit) {
  const auto& range = f.rows[row];
  Index5 at;
  for (at[kind] = range[kind].first; at[kind] < range[kind].second; ++at[kind])
    for (at[thickness] = range[thickness].first; at[thickness] < range[thickness].second; ++at[thickness])
      for (at[gaps] = range[gaps].first; at[gaps] < range[gaps].second; ++at[gaps])
        for (at[stiffness] = range[stiffness].first; at[stiffness] < range[stiffness].second; ++at[stiffness])
          for (at[orders] = range[orders].first; at[orders] < range[orders].second; ++at[orders])
            if (is_curve(f, at, range[orders].first)) visit(at);
}

std::string value_of(const Family& family, Dim dim, std::size_t i);
// What distinguishes a curve from the others of the figure.
std::string name_of(const Family& family, const Index5& at);
// What all curves of a row have in common and those of other rows have not.
std::string name_of_row(const Family& family, std::size_t row);

}  // namespace pabd::barrier_family
