// SPDX-License-Identifier: MIT
// Taking hold of d̂ and κ on the barrier plot.
//
//   d̂   contact thickness: the upright line                      m
//   κ   contact stiffness: a handle on the curve, Ψ = κ B_N(d)    J (log barrier: J/m²)
//
// While it lasts the axes stay as they were when it began: they would follow the hand otherwise.
#pragma once

#include <optional>

#include "app/plots/figures/barrier_plots.h"
#include "app/plots/plot_layout.h"
#include "app/workbench/command.h"

namespace pabd {

enum class BarrierGrip : std::uint8_t { none, d_hat, kappa };

// What a press at `mouse` takes hold of, no more than `reach` px away. κ comes first: its handle is small.
BarrierGrip barrier_grip(const BarrierPanel& panel, const PlotLayout& layout, const Point& mouse,
                         double reach);

class BarrierDrag {
 public:
  bool active() const { return grip_ != BarrierGrip::none; }
  BarrierGrip grip() const { return grip_; }
  PlotRange x() const { return x_; }  // ranges to hold
  PlotRange y() const { return y_; }

  // `kappa`: the resolved one, at the start.
  void begin(BarrierGrip grip, const BarrierPanel& panel, double kappa, const PlotLayout& layout,
             const Point& mouse);
  // What to send for the pointer's place; nothing while that is what was sent last. Everything after the
  // first goes on with it, so that a drag is one step of undo. Values have four significant digits, and stay
  // above a hundredth of d̂ and a millionth of κ at the start: nobody means to drag them to nothing.
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

}  // namespace pabd
