// SPDX-License-Identifier: MIT
// Dragging d̂ and κ on the barrier plot, and the strip of contacts over d/d̂ below it.
//
//   d̂   contact thickness: the upright line                      m
//   κ   contact stiffness: a handle on the curve, Ψ = κ B_N(d)    J (log barrier: J/m²)
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "app/gui/panel.h"
#include "app/plots/figures/barrier_plots.h"
#include "app/plots/plot_layout.h"
#include "app/workbench/command.h"
#include "sim/solver/report.h"

namespace pabd {

enum class BarrierGrip : std::uint8_t { none, d_hat, kappa };

// What a press at `mouse` grips within `reach` px. κ comes first: its handle is small.
BarrierGrip barrier_grip(const BarrierPanel& panel, const PlotLayout& layout, const Point& mouse,
                         double reach);

// During a drag the axes keep their ranges: otherwise they would move with the pointer.
class BarrierDrag {
 public:
  bool active() const { return grip_ != BarrierGrip::none; }
  BarrierGrip grip() const { return grip_; }
  PlotRange x() const { return x_; }  // ranges to hold
  PlotRange y() const { return y_; }

  // `kappa`: the resolved one, at the start.
  void begin(BarrierGrip grip, const BarrierPanel& panel, double kappa, const PlotLayout& layout,
             const Point& mouse);
  // The command for the pointer's place; none where it equals the last one. A drag is one step of undo. Values have
  // four significant digits, and are at least a hundredth of d̂ and a millionth of κ at the start.
  std::optional<command::Set> move(const PlotLayout& layout, const Point& mouse);
  void end() { grip_ = BarrierGrip::none; }

 private:
  BarrierGrip grip_ = BarrierGrip::none;
  PlotRange x_{0, 1}, y_{0, 1};
  double start_ = 0;  // value at the start
  Point offset_;      // from the pointer to what it holds; px
  KappaHandle handle_{};
  std::optional<double> sent_;
  bool more_ = false;
};

// The distribution of contacts over d/d̂ as a low strip of bars along the distance axis, where a histogram has no room.
struct ContactStrip {
  static constexpr int kBins = 48;  // from `lo` to d̂; deeper ones are in the first
  std::array<int, kBins> counts{};
  int most = 0, contacts = 0;
  double lo = 0, d_hat = 1;  // m
  double median = 0;         // of d/d̂
};
ContactStrip contact_strip(double lo, double d_hat, const std::vector<ContactReport>& contacts);

// At the cursor, along the x axis (d in m) of `plot`.
void draw_contact_strip(GuiFrame& frame, const ContactStrip& strip, const PlotLayout& plot, float height);

}  // namespace pabd
