// SPDX-License-Identifier: MIT
// See body_colors.h.
#include "app/overlay/body_colors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/base/counted.h"
#include "sim/solver/step_summary.h"

namespace pabd {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kGoldenPart = 0.6180339887498949;  // of the colour map between neighbours

double value_of(const FrameView& run, std::size_t i, ColorQuantity quantity) {
  if (run.model->fixed[i]) return kNone;
  if (quantity == ColorQuantity::speed) return run.state->v[i].norm();
  if (i >= run.report.body_reports.size()) return kNone;
  const BodyReport& r = run.report.body_reports[i];
  switch (quantity) {
    case ColorQuantity::projection:
      return r.projection_change;
    case ColorQuantity::energy:
      return kinetic_energy(*run.model, static_cast<Index>(i), run.state->R[i], run.state->v[i],
                            run.state->omega[i]) +
             r.contact_energy;
    case ColorQuantity::component:
      return r.island < 0 ? kNone : r.island;
    case ColorQuantity::residual:
      return r.island < 0 ? kNone : r.residual;
    default:
      return kNone;
  }
}

std::vector<double> values_of(const FrameView& run, ColorQuantity quantity) {
  std::vector<double> out(run.model->shape.size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = value_of(run, i, quantity);
  return out;
}

double largest_of(const std::vector<double>& values) {
  double out = 0;
  for (const double v : values) {
    if (std::isfinite(v)) out = std::max(out, v);
  }
  return out;
}

}  // namespace

ColorQuantity color_quantity(const std::string& name) {
  for (std::size_t i = 0; i < std::size(kColorNames); ++i) {
    if (name == kColorNames[i]) return static_cast<ColorQuantity>(i);
  }
  return ColorQuantity::body;
}

double largest_value(const FrameView& run, ColorQuantity quantity) {
  return quantity == ColorQuantity::body ? 0 : largest_of(values_of(run, quantity));
}

BodyColors body_colors(const FrameView& run, ColorQuantity quantity, double largest) {
  BodyColors out;
  if (quantity == ColorQuantity::body) return out;
  out.values = values_of(run, quantity);
  out.largest = std::max(largest, largest_of(out.values));
  const double hi = out.largest;
  if (quantity == ColorQuantity::component) {
    out.title = "bodies that hang together";
    int count = 0;
    for (double& v : out.values) {
      if (!std::isfinite(v)) continue;
      count = std::max(count, static_cast<int>(v) + 1);
      v = std::fmod(0.25 + kGoldenPart * v, 1.0);
    }
    out.note = count == 0 ? "nothing touches: no components"
                          : counted(count, "component") + ", one colour each; grey: alone or fixed";
    return out;
  }
  if (hi == 0 && quantity == ColorQuantity::projection) {
    out.title = out.note = "‖A − R‖ is 0: only sissm has an A";
    return out;
  }
  if (hi == 0 && quantity == ColorQuantity::residual) {
    out.title = out.note = "residual 0: nothing touches or all rests";
    return out;
  }
  const bool tiny = quantity == ColorQuantity::projection || quantity == ColorQuantity::residual;
  out.range = round_range(hi, tiny ? 1e-12 : 1e-6, quantity != ColorQuantity::speed);
  out.title = quantity == ColorQuantity::projection ? "‖A − R‖"
              : quantity == ColorQuantity::speed    ? "speed, m/s"
              : quantity == ColorQuantity::residual ? "residual, d̂"
                                                    : "kinetic and contact energy, J";
  return out;
}

}  // namespace pabd
