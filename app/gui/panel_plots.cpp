// SPDX-License-Identifier: MIT
// See panel_plots.h.
#include "app/gui/panel_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>

#include "app/overlay/overlay_panels.h"
#include "app/plots/axis_ticks.h"
#include "app/plots/figure.h"
#include "app/plots/figures/barrier_curves.h"
#include "app/plots/figures/barrier_over.h"
#include "app/plots/figures/convergence.h"
#include "app/plots/figures/quantity_plot.h"
#include "app/plots/figures/run_caption.h"
#include "app/plots/figures/time_panel.h"
#include "render/output/png.h"
#include "sim/base/atomic_file.h"
#include "sim/base/counted.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

// Part of the time axis: changes of κ closer than that are one, as of a slider.
constexpr double kNear = 0.02;

// Where κ changed, as the reports have it.
std::vector<TimeMark> kappa_marks(const Reports& history) {
  struct Change {
    double time, from, to;
  };
  std::vector<Change> changes;
  const double span = history.empty() ? 0 : history.back().time - history.front().time;
  for (std::size_t i = 1; i < history.size(); ++i) {
    const double from = history[i - 1].kappa, to = history[i].kappa, time = history[i - 1].time;
    if (!(from > 0) || from == to) continue;
    if (!changes.empty() && time - changes.back().time < kNear * span) {
      changes.back().to = to;
    } else {
      changes.push_back({time, from, to});
    }
  }
  std::vector<TimeMark> marks;
  for (const Change& c : changes) {
    marks.push_back({c.time, fmt::format("κ {} → {}", format_value(c.from, 3), format_value(c.to, 3)),
                     MarkKind::parameter});
  }
  return marks;
}

std::vector<TimeMark> marks_of(const Snapshot& sim) {
  std::vector<TimeMark> out = kappa_marks(sim.a.history);
  if (const auto& parting = sim.a.parting) {
    out.push_back({parting->time, "branch", MarkKind::branch});
    if (parting->parted) out.push_back({*parting->parted, "parts by d̂", MarkKind::divergence});
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const TimeMark& a, const TimeMark& b) { return a.time < b.time; });
  return out;
}

std::string ending_of(const std::string& path) { return std::filesystem::path(path).extension().string(); }

void write_png_of(const Figure& figure, const PictureSize& size, const std::string& path, bool dark) {
  const PlotTheme& theme = dark ? dark_theme() : light_theme();
  PngText text;
  text["Software"] = "pabd " PABD_VERSION;
  text["Caption"] = plain_text(figure.caption);
  write_png(path, picture_to_image(figure_picture(figure, theme), size.width, size.height, theme.paper),
            text);
}

}  // namespace

BarrierPanel barrier_panel_of(const Snapshot& sim, const command::BarrierView& view,
                              const std::optional<PlotRange>& x, const std::optional<PlotRange>& y) {
  const RunView& run = sim.a;
  BarrierPanelOptions options;
  options.quantity = static_cast<BarrierQuantity>(place_in(kBarrierQuantities, view.quantity));
  options.log_y = view.log;
  options.energy = view.energy;
  options.variants = {view.printed, view.onset, view.even, view.log_barrier};
  options.most_markers = 600;
  options.x = x;
  options.y = y;
  const auto& contacts = run.report.contact_reports;
  const auto abscissa = static_cast<BarrierAbscissa>(place_in(kBarrierAbscissas, view.against));
  if (abscissa != BarrierAbscissa::gap)
    return barrier_over(run.params.contact, run.kappa, contacts, abscissa, options);
  return barrier_panel(run.params.contact, run.kappa, contacts, contact_ink, options);
}

std::string why_no_curve(const StepReport& report, bool on_device) {
  if (report.step == 0) return "No step yet: press play (space) or → for one step.";
  if (on_device) return "The GPU does not tell of its iterations.";
  if (report.iterations == 0 && report.status == StepStatus::converged)
    return fmt::format("Step {}: {}.", report.step, why_no_iterations(report));
  return fmt::format("Step {}: its iterations were not recorded. → makes a step that shows them.",
                     report.step);
}

std::vector<Plot> convergence_panels_of(const Snapshot& sim, const UiState& ui) {
  const StepReport& r = sim.a.report;
  const std::size_t what = place_in(kConvergenceViews, ui.convergence);
  std::vector<Plot> plots;
  if (what == 0) {
    plots.push_back(convergence_plot(r, !sim.a.model->joints.empty()));
    plots.front().title = sim.held.empty()
                              ? ""  // the list says it
                              : counted(sim.held.size(), "held curve") + " not shown: choose one quantity";
  } else {
    const auto quantity = static_cast<ConvergenceQuantity>(what - 1);
    std::vector<MethodRun> runs{{to_string(r.method), r.records, r.capped_bonds}};
    std::size_t others = 0;
    for (const HeldCurve& held : sim.held) {
      // E_end is one step's own.
      if (quantity == ConvergenceQuantity::energy_gap && held.step != r.step) {
        ++others;
      } else {
        runs.push_back({held.step == r.step ? "held: " + held.name.substr(0, held.name.find(',')) : held.name,
                        *held.records, held.softened});
      }
    }
    plots = convergence_panels(runs, quantity);
    if (plots.size() == 1) plots.front().title.clear();  // the list says it
    if (others > 0) plots.front().title = fmt::format("{} held of other steps not shown", others);
  }
  for (Plot& plot : plots) {
    if (r.step == 0) plot.none = "no step yet";
    PlotZoom zoom = ui.zoom_of(convergence_tab.name);
    if (&plot != &plots.front()) zoom.y.reset();  // another function's
    show_part(zoom, plot);
  }
  return plots;
}

namespace {

Plot whole_series(const Snapshot& sim, const UiState& ui) {
  const RunView& a = sim.a;
  const double d_hat = a.params.contact.d_hat;
  TimePanelOptions options;
  options.cursor = a.state->time;
  options.d_hat = d_hat;
  options.marks = marks_of(sim);
  if (sim.b) {
    options.other = sim.b->history;
    options.name = std::string("A");
    options.other_name = std::string("B");
  } else if (a.left) {
    options.other = *a.left;
    options.name = std::string("now");
    options.other_name = std::string("before");
  }
  const std::size_t what = place_in(kSeriesViews, ui.series);
  if (ui.series == kChosenSeries) {
    const StepQuantity *x = find_step_quantity(ui.series_x), *y = find_step_quantity(ui.series_y);
    return quantity_plot(a.history, x ? *x : step_quantities()[0], y ? *y : step_quantities()[1], options);
  }
  if (what > 0) return time_panel(a.history, static_cast<TimeQuantity>(what - 1), options);
  Plot plot = time_series_plot(a.history, d_hat, !a.model->joints.empty(), options.other);
  // Cursor and marks as the other plots have them.
  add_time_marks(options, plot);
  return plot;
}

}  // namespace

Plot series_panel_of(const Snapshot& sim, const UiState& ui) {
  Plot plot = whole_series(sim, ui);
  show_part(ui.zoom_of(series_tab.name), plot);
  return plot;
}

Figure panel_figure(const std::string& panel, const Snapshot& sim, const UiState& ui) {
  Plot plot;
  Figure figure;
  std::string title;
  if (panel == barrier_tab.name) {
    const PlotZoom& zoom = ui.zoom_of(panel);
    plot = barrier_panel_of(sim, ui.barrier, zoom.x, zoom.y).plot;
    title = ui.barrier.energy ? "Contact potential" : "Contact barrier";
    if (ui.barrier.against == kBarrierAbscissas[0].name) {
      plot.series.push_back(contact_strip_series(plot.x.lo, sim.a.params.contact.d_hat,
                                                 sim.a.report.contact_reports, contact_ink));
    }
  } else if (panel == convergence_tab.name) {
    figure.plots = convergence_panels_of(sim, ui);
    plot = std::move(figure.plots.back());
    figure.plots.pop_back();
    title = "Convergence of the step";
  } else {
    plot = series_panel_of(sim, ui);
    title = plot.title.empty() ? "Over time" : plot.title;
  }
  figure.title = std::move(title);
  figure.caption = run_caption(sim.scene->name, sim.a.state->step, sim.a.params, sim.a.kappa, true);
  if (sim.b && panel == series_tab.name) figure.caption += "; B: κ = " + format_value(sim.b->kappa);
  if (figure.plots.empty()) plot.title.clear();
  figure.plots.push_back(std::move(plot));
  figure.columns = static_cast<int>(figure.plots.size());
  return figure;
}

void check_plot_name(const std::string& path) {
  const std::string ending = ending_of(path);
  for (const char* known : {".csv", ".svg", ".pdf", ".png"}) {
    if (ending == known) return;
  }
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: expected a name that ends in .csv, .svg, .pdf or .png", path));
}

void export_plot(const command::ExportPlot& what, const Snapshot& sim, const UiState& ui) {
  check_plot_name(what.path);
  const Figure figure = panel_figure(what.panel, sim, ui);
  const std::string ending = ending_of(what.path);
  PictureSize size = default_size(figure);
  if (what.width > 0) size.width = what.width;
  if (what.height > 0) size.height = what.height;
  if (ending == ".png") return write_png_of(figure, size, what.path, ui.dark);
  write_file(what.path, ending == ".csv"   ? figure_to_csv(figure)
                        : ending == ".svg" ? figure_to_svg(figure, size.width, size.height)
                                           : picture_to_pdf(figure_picture(figure), size.width, size.height));
}

}  // namespace pabd
