// Which panels are shown, and where.
#include "app/overlay/panel_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/error.h"

namespace pabd {
namespace {

// Sizes at 1280 × 720.
constexpr double kMargin = 14;
constexpr double kPlotWidth = 312;
constexpr double kPlotHeight = 218;
constexpr double kParamsWidth = 196;
constexpr double kParamsHeight = 236;
constexpr double kParamsRow = 18;
constexpr double kLegendWidth = 300;
constexpr double kLegendHeight = 50;
// Below this scale text is too small to read: panels of small frames take more of the frame instead.
constexpr double kLeastScale = 0.72;

constexpr Panel kAll[] = {Panel::params, Panel::barrier, Panel::convergence,
                          Panel::series, Panel::legend,  Panel::difference};

bool* flag(OverlayOptions& options, Panel panel) {
  switch (panel) {
    case Panel::params:
      return &options.params;
    case Panel::barrier:
      return &options.barrier;
    case Panel::convergence:
      return &options.convergence;
    case Panel::series:
      return &options.series;
    case Panel::legend:
      return &options.legend;
    case Panel::joints:
      return &options.joints;
    case Panel::difference:
      return &options.difference;
  }
  return nullptr;
}

Rect snapped(double x, double y, double w, double h) {
  const double x0 = std::round(x), y0 = std::round(y);
  return {x0, y0, std::round(x + w) - x0, std::round(y + h) - y0};
}

}  // namespace

const char* to_string(Panel panel) {
  switch (panel) {
    case Panel::params:
      return "params";
    case Panel::barrier:
      return "barrier";
    case Panel::convergence:
      return "convergence";
    case Panel::series:
      return "series";
    case Panel::legend:
      return "legend";
    case Panel::joints:
      return "joints";
    case Panel::difference:
      return "difference";
  }
  return "?";
}

bool OverlayOptions::shows(Panel panel) const {
  OverlayOptions copy = *this;
  return *flag(copy, panel);
}

bool enable_panel(OverlayOptions& options, const std::string& name) {
  if (name == "plots") {
    options.barrier = options.convergence = options.series = true;
    return true;
  }
  for (const Panel panel : kAll) {
    if (name == to_string(panel)) {
      *flag(options, panel) = true;
      return true;
    }
  }
  return false;
}

std::string panel_names() { return "params, barrier, convergence, series, legend, difference, plots"; }

OverlayOptions parse_panels(const std::string& list) {
  OverlayOptions options;
  if (list.empty() || list == "none") return options;
  if (list == "all") return {true, true, true, true, true, false, 0, false};
  for (std::size_t i = 0; i <= list.size();) {
    const std::size_t end = std::min(list.find(',', i), list.size());
    const std::string name = list.substr(i, end - i);
    if (!enable_panel(options, name)) {
      throw Error(
          ExitCode::bad_input,
          fmt::format("overlay '{}': no such panel; expected some of {}, or all, none", name, panel_names()));
    }
    i = end + 1;
  }
  return options;
}

PanelLayout layout_panels(const OverlayOptions& options, int width, int height) {
  PanelLayout layout;
  const int plots =
      int{options.barrier} + int{options.convergence} + int{options.series} + int{options.difference};
  const int legends = int{options.legend} + int{options.joints};
  const double left = legends > 0 ? kLegendWidth : options.params ? kParamsWidth : 0;
  const double params_height = kParamsHeight + kParamsRow * options.joint_rows;
  const double needed_width = left + (plots > 0 ? kPlotWidth : 0) + 3 * kMargin;
  const double needed_height =
      std::max((options.params ? params_height + kMargin : 0) + legends * (kLegendHeight + kMargin) + kMargin,
               plots * (0.62 * kPlotHeight + 0.6 * kMargin) + 2 * kMargin);
  double s = std::max(kLeastScale, std::min(width / 1280.0, height / 720.0));
  s = std::min({s, width / needed_width, height / needed_height});
  layout.scale = s;

  const double margin = kMargin * s;
  if (options.params) {
    layout.panels.push_back({Panel::params, snapped(margin, margin, kParamsWidth * s, params_height * s)});
  }
  double column = width;
  if (plots > 0) {
    const double gap = 0.6 * margin;
    const double h = std::min(kPlotHeight * s, (height - 2 * margin - (plots - 1) * gap) / plots);
    column = width - margin - kPlotWidth * s;
    double y = margin;
    for (const Panel panel : {Panel::barrier, Panel::convergence, Panel::series, Panel::difference}) {
      if (!options.shows(panel)) continue;
      layout.panels.push_back({panel, snapped(column, y, kPlotWidth * s, h)});
      y += h + gap;
    }
    column -= margin;
  }
  double bottom = height;
  for (const Panel panel : {Panel::legend, Panel::joints}) {
    if (!options.shows(panel)) continue;
    bottom -= (bottom == height ? 1 : 0.6) * margin + kLegendHeight * s;
    layout.panels.push_back({panel, snapped(margin, bottom, kLegendWidth * s, kLegendHeight * s)});
  }
  if (legends > 0) bottom -= margin;

  // Candidates: beside the parameters, or below them; above the legend or beside it.
  const double beside = options.params ? 2 * margin + kParamsWidth * s : 0;
  const double below = options.params ? 2 * margin + params_height * s : 0;
  for (const Rect& candidate :
       {Rect{beside, 0, column - beside, bottom}, Rect{0, below, column, bottom - below}}) {
    if (candidate.w > 0 && candidate.h > 0 && candidate.w * candidate.h > layout.free.w * layout.free.h) {
      layout.free = candidate;
    }
  }
  return layout;
}

}  // namespace pabd
