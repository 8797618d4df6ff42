// SPDX-License-Identifier: MIT
// See barrier_plot.h.
#include "app/gui/barrier_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/gui/number_input.h"
#include "app/gui/widgets.h"
#include "app/overlay/overlay_panels.h"
#include "app/plots/axis_ticks.h"
#include "sim/base/counted.h"
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

constexpr double kStripText = 10.5;  // px of an ordinary screen

// m
double bin_start(const ContactStrip& strip, int bin) {
  return strip.lo + bin * (strip.d_hat - strip.lo) / ContactStrip::kBins;
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

ContactStrip contact_strip(double lo, double d_hat, const std::vector<ContactReport>& contacts) {
  ContactStrip strip;
  strip.lo = lo;
  strip.d_hat = d_hat;
  std::vector<double> ratios;
  for (const ContactReport& c : contacts) {
    const double ratio = c.d / d_hat;
    if (!std::isfinite(ratio) || ratio >= 1) continue;
    ratios.push_back(ratio);
    const int bin = static_cast<int>(std::max(0.0, (c.d - lo) / (d_hat - lo) * ContactStrip::kBins));
    int& count = strip.counts[static_cast<std::size_t>(std::min(bin, ContactStrip::kBins - 1))];
    strip.most = std::max(strip.most, ++count);
  }
  strip.contacts = static_cast<int>(ratios.size());
  if (ratios.empty()) return strip;
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  strip.median = *middle;
  return strip;
}

void draw_contact_strip(GuiFrame& f, const ContactStrip& strip, const PlotLayout& plot, float height) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("##strip", {ImGui::GetContentRegionAvail().x, height});
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto left = static_cast<float>(plot.inner.x), right = static_cast<float>(plot.inner.right());
  const float foot = at.y + height - f.px(1);
  const float room = height - f.px(3) - static_cast<float>(kStripText * f.unit);  // for bars, below the words
  const auto x = [&](double d) {
    return std::clamp(static_cast<float>(plot.map(d, plot.y.hi).x), left, right);
  };
  list.AddRectFilled({left, foot}, {right, foot + f.px(1)}, packed(f.theme().axis));
  const ImVec2 mouse = ImGui::GetMousePos();
  std::string under;
  for (int bin = 0; bin < ContactStrip::kBins; ++bin) {
    const int count = strip.counts[static_cast<std::size_t>(bin)];
    const double lo = bin_start(strip, bin), hi = bin_start(strip, bin + 1);
    const float x0 = std::round(x(lo)), x1 = std::round(x(hi));
    if (x1 <= x0) continue;
    if (count > 0) {
      const float bar = std::max(f.px(2), room * static_cast<float>(count) / static_cast<float>(strip.most));
      list.AddRectFilled({x0, foot - bar}, {std::max(x0 + 1, x1 - f.px(1)), foot},
                         packed(contact_ink(0.5 * (lo + hi) / strip.d_hat)));
    }
    if (mouse.x >= x0 && mouse.x < x1)
      under = fmt::format("{} of {} with d/d̂ {} {}", count, counted(strip.contacts, "contact"),
                          bin == 0 ? "below" : fmt::format("from {:.2f} to", lo / strip.d_hat),
                          fmt::format("{:.2f}", hi / strip.d_hat));
  }
  const std::string text =
      ui_text(strip.contacts == 0 ? std::string(f.sim.a.report.contacts > 0 ? "d [m]; contacts not kept"
                                                                            : "d [m]; no contacts")
                                  : fmt::format("d [m]; {}, median {} d̂", counted(strip.contacts, "contact"),
                                                format_value(strip.median, 3)));
  if (ImFont* font = f.fonts.font(kStripText * f.unit))
    list.AddText(font, font->FontSize, {left + f.px(3), at.y}, packed(f.theme().muted), text.c_str());
  if (hovered && !under.empty()) tooltip(under);
}

}  // namespace pabd
