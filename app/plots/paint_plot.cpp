// SPDX-License-Identifier: MIT
// Draws a laid-out plot on a canvas.
#include <algorithm>
#include <cmath>

#include "app/plots/plot_layout.h"

namespace pabd {
namespace {

Stroke series_stroke(SeriesStyle style, int dash, Color color, double width) {
  static constexpr double kPatterns[kDashes][2] = {{0, 0}, {3.2, 2.2}, {1.1, 1.7}, {7.5, 2.4}};
  const double* pattern = kPatterns[style == SeriesStyle::dashed ? 1 : std::clamp(dash, 0, kDashes - 1)];
  Stroke stroke{color, width, pattern[0] * width, pattern[1] * width};
  if (style == SeriesStyle::level || style == SeriesStyle::level_x) {
    stroke.width = 0.7 * width;
    stroke.dash_on = 1.2 * width;
    stroke.dash_off = 1.4 * width;
  }
  return stroke;
}

void paint_marker(const Point& at, double radius, Color color, const PlotStyle& style, Canvas& canvas) {
  canvas.fill_circle(at, radius + 0.35 * radius, style.theme.rim);
  canvas.fill_circle(at, radius, color);
}

// Where something `length` long starts that should start at `at` but stay between lo and hi.
double within(double at, double length, double lo, double hi) {
  return std::clamp(at, lo, std::max(lo, hi - length));
}

// The label of an axis, shrunk where it is too long; size 0 where it does not fit.
double label_size(const std::string& label, double room, const PlotStyle& style, const Canvas& canvas) {
  return fitted_size(canvas.font(), label, style.label, 0.8 * style.tick, room);
}

void paint_grid(const PlotLayout& layout, const PlotStyle& style, Canvas& canvas) {
  const Rect& in = layout.inner;
  for (const bool major : {false, true}) {
    const Color color = major ? style.theme.grid : style.theme.minor_grid;
    for (const Tick& tick : layout.x.ticks) {
      if (tick.major == major)
        canvas.vertical(in.x + layout.x.unit(tick.value) * in.w, in.y, layout.foot(), color, style.grid);
    }
    for (const Tick& tick : layout.y.ticks) {
      if (tick.major == major) {
        canvas.horizontal(in.x, in.right(), in.bottom() - layout.y.unit(tick.value) * in.h, color,
                          style.grid);
      }
    }
  }
  // The zero lines of linear axes, when inside.
  if (!layout.y.log && layout.y.lo < 0 && layout.y.hi > 0) {
    canvas.horizontal(in.x, in.right(), in.bottom() - layout.y.unit(0) * in.h, style.theme.zero_line,
                      style.grid);
  }
  if (!layout.x.log && layout.x.lo < 0 && layout.x.hi > 0) {
    canvas.vertical(in.x + layout.x.unit(0) * in.w, in.y, layout.foot(), style.theme.zero_line, style.grid);
  }
}

// Short samples of the curves of an axis: at most one a colour, from x on to the right, or upwards from y.
double paint_chips(const std::vector<Color>& chips, const Point& at, bool upright, const PlotStyle& style,
                   Canvas& canvas) {
  const double length = 0.9 * style.tick, pitch = 1.15 * style.tick;
  double way = 0;
  for (const Color& color : chips) {
    const Point ends[] = {upright ? Point{at.x, at.y - way} : Point{at.x + way, at.y},
                          upright ? Point{at.x, at.y - way - length} : Point{at.x + way + length, at.y}};
    canvas.polyline(ends, {color, 1.4 * style.line, 0, 0});
    way += pitch;
  }
  return way;
}

void paint_vertical_axis(const AxisScale& axis, const std::string& label, bool right,
                         const PlotLayout& layout, const PlotStyle& style, Canvas& canvas) {
  const Rect& in = layout.inner;
  const Color color = right ? layout.right_ink : layout.left_ink;
  const std::vector<Color>& chips = right ? layout.right_chips : layout.left_chips;
  const double edge = right ? in.right() : in.x;
  const double out = right ? 1 : -1;
  const bool tinted = !(color == style.theme.axis);
  TextStyle text{style.tick, tinted ? color : style.theme.text, right ? AlignX::left : AlignX::right,
                 AlignY::middle};
  for (const Tick& tick : axis.ticks) {
    const double y = in.bottom() - axis.unit(tick.value) * in.h;
    const double length = style.tick_length * (tick.major ? 1 : 0.55);
    canvas.horizontal(std::min(edge, edge + out * length), std::max(edge, edge + out * length), y, color,
                      style.grid);
    if (tick.major) canvas.text({edge + out * (style.tick_length + style.gap), y}, tick.label, text);
  }
  canvas.vertical(edge, in.y, in.bottom(), color, style.grid);

  const double above = in.y - FontMetrics::cap * style.tick;
  text.y = AlignY::baseline;
  if (style.compact) {
    const std::string head = axis.factor.empty() ? label
                             : label.empty()     ? axis.factor
                                                 : label + "  " + axis.factor;
    text.size = style.label;
    text.x = right ? AlignX::right : AlignX::left;
    const double middle = above - 0.5 * FontMetrics::cap * style.label;
    const double all = 1.15 * style.tick * static_cast<double>(chips.size());
    const double start =
        right ? layout.area.right() - text_width(canvas.font(), head, style.label) - all : layout.area.x;
    paint_chips(chips, {start, middle}, false, style, canvas);
    canvas.text({right ? layout.area.right() : layout.area.x + all, above}, head, text);
    return;
  }
  text.x = right ? AlignX::right : AlignX::left;
  if (!axis.factor.empty()) canvas.text({edge, above}, axis.factor, text);
  text.size = label_size(label, layout.area.h, style, canvas);
  if (label.empty() || text.size == 0) return;
  text.vertical = true;
  text.x = AlignX::center;
  text.y = right ? AlignY::bottom : AlignY::top;
  const double x = right ? layout.area.right() : layout.area.x;
  const double length = text_width(canvas.font(), label, text.size);
  const double end = within(in.y + 0.5 * (in.h - length), length, layout.area.y, layout.area.bottom());
  canvas.text({x, end + 0.5 * length}, label, text);
  const double along = x + (right ? -0.5 : 0.5) * FontMetrics::cap * style.label;
  paint_chips(chips, {along, end - 0.5 * style.tick}, true, style, canvas);
}

void paint_horizontal_axis(const Plot& plot, const PlotLayout& layout, const PlotStyle& style,
                           Canvas& canvas) {
  const Rect& in = layout.inner;
  TextStyle text{style.tick, style.theme.text, AlignX::center, AlignY::top};
  const double foot = layout.foot();
  for (const Tick& tick : layout.x.ticks) {
    const double x = in.x + layout.x.unit(tick.value) * in.w;
    canvas.vertical(x, foot, foot + style.tick_length * (tick.major ? 1 : 0.55), style.theme.axis,
                    style.grid);
    if (tick.major) canvas.text({x, foot + style.tick_length + style.gap}, tick.label, text);
  }
  canvas.horizontal(in.x, in.right() + 1, foot, style.theme.axis, style.grid);
  const double below =
      foot + style.tick_length + style.gap + FontMetrics::cap * style.tick + 0.55 * style.label;
  text.size = label_size(plot.x.label, layout.area.w, style, canvas);
  if (!plot.x.label.empty() && text.size > 0) {
    const double length = text_width(canvas.font(), plot.x.label, text.size);
    const double start = within(in.x + 0.5 * (in.w - length), length, layout.area.x, layout.area.right());
    canvas.text({start + 0.5 * length, below}, plot.x.label, text);
  }
  if (!layout.x.factor.empty()) {
    text.size = style.tick;
    text.x = AlignX::right;
    canvas.text({in.right(), below}, layout.x.factor, text);
  }
}

void paint_strip(const Series& series, Color color, const PlotLayout& layout, const PlotStyle& style,
                 Canvas& canvas) {
  const Rect& band = layout.strip;
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    const Rect bar = strip_bar(layout, series, i);
    if (bar.w > 0) canvas.fill_rect(bar, i < series.marker_colors.size() ? series.marker_colors[i] : color);
  }
  TextStyle text{style.tick, style.theme.muted, AlignX::left, AlignY::top};
  text.halo = 0.16 * style.tick;
  text.halo_color = style.theme.paper;
  canvas.text({band.x + style.gap, band.y - std::round(kStripWords * style.tick)}, series.name, text);
}

void paint_series(const Series& series, Color color, const PlotLayout& layout, const PlotStyle& style,
                  Canvas& canvas) {
  const Rect& in = layout.inner;
  const Stroke stroke = series_stroke(series.style, series.dash, color, style.line * series.weight);
  if (series.style == SeriesStyle::strip) {
    paint_strip(series, color, layout, style, canvas);
    return;
  }
  if (series.style == SeriesStyle::bars) {
    for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
      const Rect bar = bar_rect(layout, series, i);
      const Color fill = i < series.marker_colors.size() ? series.marker_colors[i] : color;
      // Where markers have a rim that shows, bars have one: the darkest are the worst contacts.
      const bool rim = !(style.theme.rim == style.theme.paper) && bar.w > 3 && bar.h > 0;
      if (rim) canvas.fill_rect(bar, style.theme.rim);
      canvas.fill_rect(rim ? Rect{bar.x + 1, bar.y + 1, bar.w - 2, bar.h - 1} : bar, fill);
    }
    return;
  }
  if (series.style == SeriesStyle::level || series.style == SeriesStyle::level_x) {
    const bool across = series.style == SeriesStyle::level;
    if ((across ? series.y : series.x).empty()) return;
    const Point p = across ? layout.map(layout.x.lo, series.y[0], series.right_axis)
                           : layout.map(series.x[0], layout.y.lo);
    const Point ends[] = {across ? Point{in.x, p.y} : Point{p.x, in.bottom()},
                          across ? Point{in.right(), p.y} : Point{p.x, in.y}};
    if (std::isfinite(p.x) && std::isfinite(p.y)) canvas.polyline(ends, stroke);
    return;
  }
  if (series.style == SeriesStyle::markers) {
    const double radius = style.marker * series.weight;
    const auto color_of = [&](std::size_t i) {
      return i < series.marker_colors.size() ? series.marker_colors[i] : color;
    };
    if (series.crowd) {
      for (const CrowdMarker& marker : thin_crowd(layout, series, kCrowdSpacing * radius)) {
        const double r = radius * crowd_size(marker.count);
        canvas.fill_circle(marker.at, r + 0.25 * radius, style.theme.rim);
        canvas.fill_circle(marker.at, r, color_of(marker.index));
      }
      return;
    }
    for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
      const Point p = layout.map(series.x[i], series.y[i], series.right_axis);
      if (in.inset(-1).contains(p)) paint_marker(p, radius, color_of(i), style, canvas);
    }
    return;
  }
  const std::vector<std::vector<Point>> runs = pixel_runs(layout, series);
  for (const std::vector<Point>& run : runs) {
    if (run.size() == 1 && runs.size() == 1) {
      paint_marker(run[0], style.marker, color, style, canvas);  // its value stands beside it: tags
    } else if (run.size() == 1) {
      canvas.fill_circle(run[0], 0.8 * style.line, color);  // a value between two breaks would not be seen
    } else {
      canvas.polyline(run, stroke);
    }
  }
}

void paint_legend(const Legend& legend, const PlotStyle& style, Canvas& canvas) {
  if (legend.entries.empty()) return;
  if (legend.boxed) canvas.fill_rect(legend.box, style.theme.legend, 3);
  for (const LegendEntry& entry : legend.entries) {
    if (entry.style == SeriesStyle::bars) {
      const double side = 0.9 * style.tick;
      canvas.fill_rect({entry.at.x + 0.5 * (legend.sample - side), entry.at.y - 0.5 * side, side, side},
                       entry.color);
    } else if (entry.style == SeriesStyle::markers) {
      paint_marker({entry.at.x + 0.5 * legend.sample, entry.at.y}, 0.9 * style.marker, entry.color, style,
                   canvas);
    } else {
      const Point ends[] = {entry.at, {entry.at.x + legend.sample, entry.at.y}};
      canvas.polyline(ends, series_stroke(entry.style, entry.dash, entry.color, style.line * entry.weight));
    }
    const double gap = (style.compact ? 0.4 : 0.6) * style.tick;
    canvas.text({entry.at.x + legend.sample + gap, entry.at.y}, entry.name,
                {style.tick, style.theme.text, AlignX::left, AlignY::middle});
  }
}

}  // namespace

std::vector<CrowdMarker> thin_crowd(const PlotLayout& layout, const Series& series, double spacing) {
  std::vector<CrowdMarker> out;
  const Rect room = layout.inner.inset(-1);
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    const Point at = layout.map(series.x[i], series.y[i], series.right_axis);
    if (!room.contains(at)) continue;
    double least = spacing;
    CrowdMarker* nearest = nullptr;
    for (CrowdMarker& marker : out) {
      const double distance = std::hypot(marker.at.x - at.x, marker.at.y - at.y);
      if (distance < least) {
        least = distance;
        nearest = &marker;
      }
    }
    if (nearest) {
      ++nearest->count;
    } else {
      out.push_back({i, at, 1});
    }
  }
  return out;
}

double crowd_size(std::size_t count) {
  return std::min(0.45 * kCrowdSpacing,
                  1 + 0.15 * std::log10(static_cast<double>(std::max<std::size_t>(count, 1))));
}

void paint_plot(const Plot& plot, const PlotLayout& layout, const PlotStyle& style, Canvas& canvas) {
  const Rect& in = layout.inner;
  double below = layout.area.bottom() - 0.12 * style.tick;
  for (std::size_t k = layout.caption.size(); k-- > 0; below -= FontMetrics::line * kCaption * style.tick) {
    canvas.text({layout.area.x, below}, layout.caption[k],
                {kCaption * style.tick, style.theme.muted, AlignX::left, AlignY::bottom});
  }
  if (layout.title > 0) {
    const double width = text_width(canvas.font(), plot.title, layout.title);
    const double left = within(in.x + 0.5 * (in.w - width), width, layout.area.x, layout.area.right());
    canvas.text({style.compact ? layout.area.x : left, layout.area.y}, plot.title,
                {layout.title, style.theme.text, AlignX::left, AlignY::top});
  }
  if (layout.empty) {
    canvas.stroke_rect(in, style.theme.grid, style.grid);
    canvas.text({in.x + 0.5 * in.w, in.y + 0.5 * in.h}, plot.none,
                {style.label, style.theme.muted, AlignX::center, AlignY::middle});
    return;
  }
  paint_grid(layout, style, canvas);
  // Crowds of markers lie under the curves, single ones over them; those at the edge are shown whole.
  enum Layer { crowds, curves, markers };
  for (const Layer layer : {crowds, curves, markers}) {
    if (layer == curves) canvas.push_clip(in);
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
      const Series& series = plot.series[i];
      const bool marks = series.style == SeriesStyle::markers || series.style == SeriesStyle::strip;
      if (layer == (!marks ? curves : series.crowd ? crowds : markers))
        paint_series(series, layout.colors[i], layout, style, canvas);
    }
    if (layer == curves) canvas.pop_clip();
  }
  paint_horizontal_axis(plot, layout, style, canvas);
  paint_vertical_axis(layout.y, plot.y.label, false, layout, style, canvas);
  if (layout.has_right) paint_vertical_axis(layout.y_right, plot.y_right.label, true, layout, style, canvas);
  paint_legend(layout.legend, style, canvas);
  for (const PlotTag& tag : layout.tags) {
    TextStyle text{style.tick, tag.color};
    text.y = AlignY::top;
    text.halo = 0.16 * style.tick;
    text.halo_color = style.theme.paper;
    canvas.text({tag.box.x, tag.box.y}, tag.text, text);
  }
}

}  // namespace pabd
