// SPDX-License-Identifier: MIT
// See barrier_drag.h.
#include "app/gui/barrier_drag.h"

#include <algorithm>
#include <cmath>

#include "app/gui/significant.h"
#include "sim/solver/parameter_table.h"

namespace pabd {
namespace {

constexpr double kLeastThickness = 0.01, kLeastStiffness = 1e-6;  // of the value at the start

Point line_at(const BarrierPanel& panel, const PlotLayout& layout, const Point& mouse) {
  return {layout.map(panel.d_hat, panel.plot.y.hi).x, mouse.y};
}
Point handle_at(const KappaHandle& handle, const PlotLayout& layout) {
  return layout.map(handle.d, handle.y);
}

}  // namespace

BarrierGrip barrier_grip(const BarrierPanel& panel, const PlotLayout& layout, const Point& mouse,
                         double reach) {
  if (panel.kappa) {
    const Point at = handle_at(*panel.kappa, layout);
    if (std::hypot(at.x - mouse.x, at.y - mouse.y) <= reach) return BarrierGrip::kappa;
  }
  const bool height = mouse.y >= layout.inner.y && mouse.y <= layout.inner.bottom();
  if (height && std::abs(line_at(panel, layout, mouse).x - mouse.x) <= reach) return BarrierGrip::d_hat;
  return BarrierGrip::none;
}

void BarrierDrag::begin(BarrierGrip grip, const BarrierPanel& panel, double kappa, const PlotLayout& layout,
                        const Point& mouse) {
  if (grip == BarrierGrip::kappa && !panel.kappa) return;
  grip_ = grip;
  x_ = {panel.plot.x.lo, panel.plot.x.hi};
  y_ = {panel.plot.y.lo, panel.plot.y.hi};
  more_ = false;
  sent_.reset();
  Point held = line_at(panel, layout, mouse);
  start_ = panel.d_hat;
  if (grip == BarrierGrip::kappa) {
    handle_ = *panel.kappa;
    held = handle_at(handle_, layout);
    start_ = kappa;
  }
  offset_ = {held.x - mouse.x, held.y - mouse.y};
}

std::optional<command::Set> BarrierDrag::move(const PlotLayout& layout, const Point& mouse) {
  if (!active()) return std::nullopt;
  const Point data = layout.unmap({mouse.x + offset_.x, mouse.y + offset_.y});
  const bool line = grip_ == BarrierGrip::d_hat;
  const double value = line ? std::max(dragged_d_hat(data.x, start_), kLeastThickness * start_)
                            : std::max(dragged_kappa(handle_, data.y, start_), kLeastStiffness * start_);
  const double sent = significant(value, 4);
  const bool untouched = !sent_ && std::abs(value - start_) <= 1e-6 * start_;
  if (untouched || sent == sent_) return std::nullopt;
  sent_ = sent;
  const bool more = more_;
  more_ = true;
  const ParameterRow& row = line ? parameter_of(&ContactParams::d_hat) : parameter_of(&ContactParams::kappa);
  return command::Set{row.key, as_value(row, sent), Side::a, more};
}

}  // namespace pabd
