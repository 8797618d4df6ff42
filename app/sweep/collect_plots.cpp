// SPDX-License-Identifier: MIT
// See collect_plots.h.
#include "app/sweep/collect_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "app/plots/axis_ticks.h"
#include "render/visual/value_map.h"
#include "sim/base/srgb.h"

namespace pabd {
namespace {

constexpr std::size_t kTagged = 8;  // points of a front that are labelled
constexpr PictureSize kScatter{1000, 640};

HeatMark mark_of(const SweptTask& task) {
  if (task.status == SweptStatus::done) return {"–", HeatSign::none};
  const HeatSign sign = task.status == SweptStatus::diverged  ? HeatSign::cross
                        : task.status == SweptStatus::refused ? HeatSign::stroke
                                                              : HeatSign::dot;
  return {std::string(status_word(task.status)), sign};
}

std::vector<double> finite(const Criterion& criterion) {
  std::vector<double> out;
  for (const auto& size : criterion.sizes) {
    if (size) out.push_back(*size);
  }
  return out;
}

std::string caption_of(const CollectedSweep& sweep, const TaskGrid& grid) {
  std::string caption = counts_words(sweep);
  if (const std::string signs = signs_words(sweep); !signs.empty()) caption += "; " + signs;
  if (grid.slices.size() > kMostSlices)
    caption += fmt::format("; the first {} of {} slices", kMostSlices, grid.slices.size());
  return caption;
}

// The axes of a sample: the two varied parameters with the most values, numbers only.
std::vector<std::size_t> scatter_axes(const CollectedSweep& sweep) {
  std::vector<std::size_t> axes;
  for (const std::size_t p : varied_parameters(sweep)) {
    const auto number = [&](const SweptTask& t) {
      return t.parameters[p].absent() || t.parameters[p].number;
    };
    if (std::all_of(sweep.tasks.begin(), sweep.tasks.end(), number)) axes.push_back(p);
  }
  return most_varied(sweep, std::move(axes), 2);
}

Axis plot_axis_of(const CollectedSweep& sweep, std::size_t parameter) {
  std::vector<double> values;
  for (const SweptValue& value : values_of(sweep, parameter)) values.push_back(*value.number);
  return {.label = sweep.parameters[parameter].label(), .log = wants_log(values)};
}

Series series(std::string name, SeriesStyle style, int color = -1) {
  Series out;
  out.name = std::move(name);
  out.style = style;
  out.color = color;
  return out;
}

SizedPicture scatter_picture(const CollectedSweep& sweep, const Criterion& criterion) {
  const std::vector<std::size_t> axes = scatter_axes(sweep);
  if (axes.size() < 2) return {};
  struct Scatter {
    Plot plot;
    AxisScale scale;
    std::string label;
  };
  auto scatter = std::make_shared<Scatter>();
  scatter->scale = color_scale_of(criterion, 7);
  scatter->label = criterion.quantity.label();
  Plot& plot = scatter->plot;
  plot.title = criterion.quantity.words;
  plot.x = plot_axis_of(sweep, axes[0]);
  plot.y = plot_axis_of(sweep, axes[1]);
  plot.caption = counts_words(sweep);
  Series points = series({}, SeriesStyle::markers);
  points.weight = 1.8;
  Series others = series("without a result", SeriesStyle::markers, 6);
  others.weight = 0.8;
  for (std::size_t i = 0; i < sweep.tasks.size(); ++i) {
    const auto &x = sweep.tasks[i].parameters[axes[0]].number, &y = sweep.tasks[i].parameters[axes[1]].number;
    if (!x || !y) continue;
    Series& series = criterion.sizes[i] ? points : others;
    series.x.push_back(*x);
    series.y.push_back(*y);
    if (criterion.sizes[i])
      series.marker_colors.push_back(sweep_color(scatter->scale.unit(*criterion.sizes[i])));
  }
  plot.series.push_back(std::move(points));
  if (!others.x.empty()) plot.series.push_back(std::move(others));
  const Picture picture = [scatter](Canvas& canvas, double width, double height) {
    const PlotStyle style = figure_style().scaled(std::max(0.7, width / kScatter.width));
    const double margin = 1.6 * style.tick, bar = 10 * style.tick;
    const Rect area{margin, margin, width - 2 * margin - bar, height - 2 * margin};
    const PlotLayout layout = layout_plot(scatter->plot, area, style, canvas.font());
    paint_plot(scatter->plot, layout, style, canvas);
    paint_color_bar({area.right() + margin, layout.inner.y, 1.4 * style.tick, layout.inner.h}, scatter->scale,
                    sweep_color, scatter->label, style, canvas);
  };
  return {picture, kScatter};
}

}  // namespace

Color sweep_color(double place) {
  const Vec4f linear = value_color(place);
  return {srgb_byte(static_cast<double>(linear[0])), srgb_byte(static_cast<double>(linear[1])),
          srgb_byte(static_cast<double>(linear[2])), 255};
}

AxisScale color_scale_of(const Criterion& criterion, int ticks) {
  const std::vector<double> sizes = finite(criterion);
  const bool log = wants_log(sizes);
  DataRange range;
  for (const double size : sizes) range.add(size, log);
  return fit_axis({.label = {}, .log = log}, range, ticks, 0);
}

std::string signs_words(const CollectedSweep& sweep) {
  const auto any = [&](SweptStatus status) { return sweep.count(status) > 0; };
  std::vector<std::string> words;
  if (any(SweptStatus::diverged)) words.emplace_back("× diverged");
  if (any(SweptStatus::refused)) words.emplace_back("/ refused");
  if (any(SweptStatus::unfinished) || any(SweptStatus::damaged))
    words.emplace_back("• unfinished or damaged");
  return fmt::format("{}", fmt::join(words, ", "));
}

HeatMap heat_map_of(const CollectedSweep& sweep, const TaskGrid& grid, const Criterion& criterion) {
  HeatMap map;
  map.title = criterion.quantity.words;
  map.value_label = criterion.quantity.label();
  map.caption = caption_of(sweep, grid);
  map.x_label = grid.x.label;
  map.y_label = grid.y.label;
  map.x_names = grid.x.names;
  map.y_names = grid.y.names;
  map.log = wants_log(finite(criterion));
  map.color = sweep_color;
  for (std::size_t s = 0; s < std::min(grid.slices.size(), kMostSlices); ++s) {
    HeatPanel panel{grid.slices[s].name, {}, {}};
    for (const auto& task : grid.slices[s].tasks) {
      panel.values.push_back(task && criterion.sizes[*task] ? *criterion.sizes[*task]
                                                            : std::numeric_limits<double>::quiet_NaN());
      panel.marks.push_back(task ? mark_of(sweep.tasks[*task]) : HeatMark{});
    }
    map.panels.push_back(std::move(panel));
  }
  return map;
}

SizedPicture criterion_picture(const CollectedSweep& sweep, const TaskGrid& grid,
                               const Criterion& criterion) {
  if (grid.scattered) return scatter_picture(sweep, criterion);
  HeatMap map = heat_map_of(sweep, grid, criterion);
  const PictureSize size = default_size(map);
  return {heat_map_picture(std::move(map)), size};
}

Figure pareto_figure(const CollectedSweep& sweep, std::span<const Criterion> criteria) {
  Figure figure;
  const Criterion* cost = cost_of(criteria);
  if (!cost) return figure;
  figure.title = "error against " + cost->quantity.words;
  for (const Criterion& error : criteria) {
    if (error.cost) continue;
    std::vector<std::size_t> tasks;
    std::vector<double> points, xs, ys;
    for (std::size_t i = 0; i < sweep.tasks.size(); ++i) {
      if (!cost->sizes[i] || !error.sizes[i]) continue;
      tasks.push_back(i);
      xs.push_back(*cost->sizes[i]);
      ys.push_back(*error.sizes[i]);
      points.insert(points.end(), {xs.back(), ys.back()});
    }
    if (tasks.empty()) continue;
    std::vector<std::size_t> front = pareto_front(points, 2);
    std::stable_sort(front.begin(), front.end(), [&](std::size_t a, std::size_t b) { return xs[a] < xs[b]; });
    Plot plot;
    plot.title = error.quantity.words;
    plot.x = {.label = cost->quantity.label(), .log = wants_log(xs)};
    plot.y = {.label = error.quantity.label(), .log = wants_log(ys)};
    Series all = series("tasks", SeriesStyle::markers, 6);
    all.x = xs;
    all.y = ys;
    Series line = series("Pareto front", SeriesStyle::line, 1);
    for (const std::size_t i : front) {
      line.x.push_back(xs[i]);
      line.y.push_back(ys[i]);
    }
    plot.series = {std::move(all)};
    if (front.size() > 1) plot.series.push_back(std::move(line));  // one point has its own label
    for (std::size_t k = 0; k < front.size(); ++k) {
      const std::size_t i = front[k];
      const std::int64_t index = sweep.tasks[tasks[i]].index;
      Series mark = series({}, SeriesStyle::markers, 1);
      mark.x = {xs[i]};
      mark.y = {ys[i]};
      if (k < kTagged && index >= 0) mark.tag = std::to_string(index);
      plot.series.push_back(std::move(mark));
    }
    figure.plots.push_back(std::move(plot));
  }
  figure.columns = figure.plots.size() > 1 ? 2 : 1;
  figure.caption =
      "Numbers are indices of tasks on the front: none is at most as much in both and less in one.";
  return figure;
}

}  // namespace pabd
