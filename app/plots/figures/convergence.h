// SPDX-License-Identifier: MIT
// How a solver converges within one step: `pabd plot convergence`, the convergence panel, the live panel, and
// figure 7 of the supplement.
//
//   E        incremental potential                                                  J
//   E_min    its least value, from a reference solve of the same step               J
//   E_end    without a reference: the least value that one of the solves ends with  J
//   residual largest step of a body in an iteration over d̂                          1
//   −d       penetration, before the projection onto SO(3) and after it             m
//   joint error: largest distance between points that a joint holds together        m
//   ‖A − R‖  Frobenius norm of what the projection takes away, largest              1
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/plots/plot.h"
#include "sim/body/model.h"
#include "sim/body/state.h"
#include "sim/solver/params.h"
#include "sim/solver/report.h"

namespace pabd {

// E depends on the friction bounds, which follow the contact forces until a solve ends: only values that
// solves end with are compared, and an earlier one that lies below has no place in a plot of E − E_min.

struct MethodRun {
  std::string name;  // "sissm"
  std::vector<IterationRecord> records;
  int softened = 0;  // bonds with less stiffness than the step's (Deviation D17): its E is another function
};

// What the true minimiser of E over rigid poses has.
struct Minimiser {
  double energy = std::numeric_limits<double>::quiet_NaN();   // J
  double min_gap = std::numeric_limits<double>::quiet_NaN();  // m
  SolverMethod method = SolverMethod::descent;                // that found it
};

enum class ConvergenceQuantity : std::uint8_t {
  energy_gap,
  energy,
  residual,
  penetration,
  joint_error,
  projection_change
};
inline constexpr int kConvergenceQuantities = 6;

// One quantity for several solves. The first run is the present one and drawn strongest, the others are held for
// comparison; each keeps its colour, the palette's in order. E − E_end makes sense for solves of the same step only.
// Gaps, residuals and errors are on a log axis; E and −d, which have a sign, on a linear one.
Plot convergence_panel(const std::vector<MethodRun>& runs, ConvergenceQuantity quantity,
                       const std::optional<Minimiser>& minimiser = std::nullopt);

// The same in as many plots as are needed: energies of different functions have no axis in common.
std::vector<Plot> convergence_panels(const std::vector<MethodRun>& runs, ConvergenceQuantity quantity,
                                     const std::optional<Minimiser>& minimiser = std::nullopt);

// Three plots: energy gap (log), residual (log), penetration before (dashed) and after the projection. A run whose E is
// another function has an energy gap of its own. With joints, which show in the records by an error above zero, one
// more: the joint error (log); the penetration goes when there are no contacts. `about`: what the caption begins
// with, run_caption.
Figure convergence_figure(const std::vector<MethodRun>& runs, const std::optional<Minimiser>& minimiser,
                          const std::string& about = "");

// All of the above for one step in one small plot, log axis; the joint error when the scene has `joints`.
Plot convergence_plot(const StepReport& report, bool joints = false);
// What that plot shows of many steps, for axes that hold in a video.
struct ConvergenceSpan {
  int iterations = 0;                                           // most of a step
  double lo = std::numeric_limits<double>::infinity(), hi = 0;  // positive values of all curves
};
void widen(ConvergenceSpan& span, const StepReport& report, bool joints);
// Decades, sixteen at most, that hold all; as it is where nothing is known.
void hold_axes(const ConvergenceSpan& span, Plot& plot);
// Of a step that was solved where it started.
std::string why_no_iterations(const StepReport& report);

// One step from `state` with each method, `iterations` without early stop, recorded. `state` is not changed.
std::vector<MethodRun> run_methods(const Model& model, const Params& params, const State& state,
                                   const std::vector<SolverMethod>& methods, int iterations, int threads = 1);

// Minimiser of the step's incremental potential over rigid poses, tolerance 1e-14: by `descent` with at most
// `iterations`, or where joints make that slow by `newton` with a hundredth of them.
Minimiser find_minimiser(const Model& model, const Params& params, const State& state, int iterations = 20000,
                         int threads = 1);

// Figure 7: penetration −d of the deepest contact against the iteration, from the first iterate (0) on:
// `sissm` with the projection that the supplement prints (polar) and with the weighted one, each before and
// after it, and the true minimiser as a level. The state is that of figure 6: two boxes with one deepest
// pair.
//
// What they show: all curves become flat, the affine matrix Â still being no rotation. The curves before and
// after stay apart by what the contact force squeezes the affine body, ΔA = h² f rᵀ J⁻¹, which the projection
// takes back: three quarters of the way of a cube's face. So the supplement's "no longer perturbs" holds for
// the change from iteration to iteration, not for the two values. After the polar projection the boxes
// overlap by more than the minimiser of E does, because the global step takes the squeeze into account that
// is lost (its fixed point is another, Deviation D1); after the weighted one they end at the minimiser.
Figure figure7(const Model& model, const Params& params, const State& state, int iterations = 100,
               int threads = 1);

}  // namespace pabd
