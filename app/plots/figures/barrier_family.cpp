// SPDX-License-Identifier: MIT
// See barrier_family.h.
#include "app/plots/figures/barrier_family.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/plots/axis_ticks.h"
#include "app/plots/figures/run_caption.h"

namespace pabd {
namespace barrier_family {

Dim dim_of(BarrierAbscissa abscissa) {
  constexpr Dim kDimOf[] = {gaps, thickness, orders, stiffness};
  return kDimOf[static_cast<std::size_t>(abscissa)];
}

bool has_orders(BarrierKind k) { return traits_of(k).least_N > 0; }

Family family_of(const BarrierCurves& curves) {
  Family f{curves, !curves.kappa.empty(), {}, {}, {}, {}};
  BarrierCurves& in = f.in;
  if (in.kappa.empty()) in.kappa = {1.0};
  if (in.gaps.empty()) in.gaps = {0.5 * in.d_hat[0], 0, -0.25 * in.d_hat[0]};
  const bool any_orders = std::any_of(in.kinds.begin(), in.kinds.end(), has_orders);
  f.count[orders] = any_orders ? in.N.size() : 1;
  f.count[thickness] = in.d_hat.size();
  f.count[gaps] = in.gaps.size();
  f.count[kind] = in.kinds.size();
  f.count[stiffness] = in.kappa.size();
  f.count[dim_of(in.abscissa)] = 1;
  Index5 most;  // of each in one plot
  for (std::size_t d = 0; d < kDims; ++d) {
    most[d] = 1;
    if (f.count[d] == 1) continue;
    if (!f.color) {
      f.color = static_cast<Dim>(d);
      most[d] = d == kind ? kColors : kShades;
    } else if (!f.dash) {
      f.dash = static_cast<Dim>(d);
      most[d] = kDashes;
    }
  }
  // Pieces of about equal size, and every combination of them.
  f.rows.resize(1);
  for (std::size_t d = 0; d < kDims; ++d) {
    const std::size_t pieces = (f.count[d] + most[d] - 1) / most[d];
    std::vector<std::array<std::pair<std::size_t, std::size_t>, kDims>> next;
    for (auto row : f.rows) {
      for (std::size_t p = 0; p < pieces; ++p) {
        row[d] = {p * f.count[d] / pieces, (p + 1) * f.count[d] / pieces};
        next.push_back(row);
      }
    }
    f.rows = std::move(next);
  }
  return f;
}

std::pair<int, int> color_of(const Family& f, std::size_t i) {
  return {static_cast<int>(i), *f.color == kind ? 0 : static_cast<int>(f.count[*f.color])};
}

bool is_curve(const Family& f, const Index5& at, std::size_t first_order) {
  const BarrierKind k = f.in.kinds[at[kind]];
  if (!has_orders(k)) return at[orders] == first_order;
  if (traits_of(k).least_N != 2 || f.in.abscissa == BarrierAbscissa::order) return true;
  const int N = f.in.N[at[orders]];
  if (N < 2) return f.in.N.size() == 1;
  for (std::size_t i = first_order; i < at[orders]; ++i) {
    if (f.in.N[i] / 2 == N / 2) return false;
  }
  return true;
}

std::string value_of(const Family& f, Dim dim, std::size_t i) {
  switch (dim) {
    case orders:
      return fmt::format("N = {}", f.in.N[i]);
    case thickness:
      return parameter_text(&ContactParams::d_hat, f.in.d_hat[i]);
    case gaps:
      return fmt::format("d = {} m", format_value(f.in.gaps[i]));
    case kind:
      return to_string(f.in.kinds[i]);
    default:
      return parameter_text(&ContactParams::kappa, f.in.kappa[i]);
  }
}

namespace {

constexpr Dim kWordOrder[] = {kind, orders, thickness, gaps, stiffness};

}  // namespace

std::string name_of(const Family& f, const Index5& at) {
  std::vector<std::string> parts;
  for (const Dim dim : kWordOrder) {
    if (f.count[dim] == 1 || (dim == orders && !has_orders(f.in.kinds[at[kind]]))) continue;
    parts.push_back(value_of(f, dim, at[dim]));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string name_of_row(const Family& f, std::size_t row) {
  std::vector<std::string> parts;
  for (const Dim dim : kWordOrder) {
    if (f.count[dim] == 1 || dim == f.color || dim == f.dash) continue;
    parts.push_back(value_of(f, dim, f.rows[row][dim].first));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace barrier_family

BarrierFigureSize size_of(const BarrierCurves& curves) {
  using namespace barrier_family;
  const Family f = family_of(curves);
  BarrierFigureSize size{f.rows.size(), 0};
  for (std::size_t row = 0; row < f.rows.size(); ++row)
    for_each_curve(f, row, [&](const Index5&) { ++size.curves; });
  return size;
}

}  // namespace pabd
