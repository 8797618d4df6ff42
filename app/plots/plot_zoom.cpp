// SPDX-License-Identifier: MIT
// See plot_zoom.h.
#include "app/plots/plot_zoom.h"

#include <algorithm>
#include <cmath>

namespace pabd {
namespace {

// Labels of ticks tell values apart up to here, and no further away is anything to be seen.
constexpr double kFinest = 1e-6, kFinestLog = 1.01, kLeast = 1e-15, kMost = 1e15, kLeastSteps = 2;

bool can_show(const Axis& axis, const PlotRange& r) {
  if (!std::isfinite(r.lo) || !std::isfinite(r.hi)) return false;
  if (axis.log) return r.lo >= kLeast * kLeast && r.hi <= kMost * kMost && r.hi >= kFinestLog * r.lo;
  const double largest = std::max(std::abs(r.lo), std::abs(r.hi));
  return largest <= kMost && r.hi - r.lo >= std::max(kLeast, kFinest * largest) &&
         (!axis.integer || r.hi - r.lo >= kLeastSteps);
}

// From place u to place v of what is shown now, or that where the axis goes no further.
PlotRange part(const Axis& axis, const AxisScale& scale, double u, double v) {
  const PlotRange wanted{scale.value(u), scale.value(v)};
  return can_show(axis, wanted) ? wanted : PlotRange{scale.lo, scale.hi};
}

struct AxisEnds {
  double u = 0, v = 1;
};
PlotZoom parts(const Plot& plot, const PlotLayout& layout, const AxisEnds& x, const AxisEnds& y,
               const AxisEnds& right) {
  PlotZoom out;
  out.x = part(plot.x, layout.x, x.u, x.v);
  out.y = part(plot.y, layout.y, y.u, y.v);
  if (layout.has_right) out.right = part(plot.y_right, layout.y_right, right.u, right.v);
  return out;
}

}  // namespace

PlotZoom zoomed(const Plot& plot, const PlotLayout& layout, const Point& pixel, double factor) {
  const Rect& in = layout.inner;
  const auto about = [factor](double at) { return AxisEnds{at - at / factor, at + (1 - at) / factor}; };
  const double up = (in.bottom() - pixel.y) / in.h;
  const bool below = pixel.y > in.bottom(), left = !below && pixel.x < in.x,
             right = !below && pixel.x > in.right();
  const AxisEnds still;
  return parts(plot, layout, left || right ? still : about((pixel.x - in.x) / in.w),
               below || right ? still : about(up), below || left ? still : about(up));
}

PlotZoom panned(const Plot& plot, const PlotLayout& layout, double dx, double dy) {
  const double across = -dx / layout.inner.w, up = dy / layout.inner.h;
  const AxisEnds y{up, 1 + up};
  return parts(plot, layout, {across, 1 + across}, y, y);
}

void show_part(const PlotZoom& zoom, Plot& plot) {
  const auto show = [](const std::optional<PlotRange>& range, Axis& axis) {
    if (!range) return;
    axis.lo = range->lo;
    axis.hi = range->hi;
  };
  show(zoom.x, plot.x);
  show(zoom.y, plot.y);
  show(zoom.right, plot.y_right);
}

}  // namespace pabd
