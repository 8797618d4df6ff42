// SPDX-License-Identifier: MIT
// The plots of panels, made from a snapshot and the state of the view: panels draw them, files contain them.
#pragma once

#include <optional>
#include <string>

#include "app/gui/ui_state.h"
#include "app/plots/figures/barrier_plots.h"
#include "app/workbench/snapshot.h"
#include "render/context/context.h"

namespace pabd {

inline constexpr std::size_t kMostCurvePoints = 1600;  // that a panel draws of a curve of steps

// `x`, `y`: ranges that a drag holds.
BarrierPanel barrier_panel_of(const Snapshot& sim, const command::BarrierView& view,
                              const std::optional<PlotRange>& x = {}, const std::optional<PlotRange>& y = {});

// Of the view `ui.convergence`: a plot, or several where energies are of different functions. The title of the first says
// which held curves are left out; empty: none.
std::vector<Plot> convergence_panels_of(const Snapshot& sim, const UiState& ui);

// Why there is no curve: iterations are only recorded while the window is open.
std::string why_no_curve(const StepReport& report, bool on_device);

// Of the view `ui.series`.
Plot series_panel_of(const Snapshot& sim, const UiState& ui);

// One of kPlottingPanels as a figure: with a title, and a caption that says scene, step and parameters.
Figure panel_figure(const std::string& panel, const Snapshot& sim, const UiState& ui);

// Writes it, by the ending of the name: .csv, .svg, .pdf or .png; size 0: what suits it. Throws
// Error(bad_input), Error(file). Changes the current ImGui context for a .png.
void export_plot(const command::ExportPlot& what, const Snapshot& sim, const UiState& ui);
// Whether the name ends in one of these; throws Error(bad_input) else.
void check_plot_name(const std::string& path);

}  // namespace pabd
