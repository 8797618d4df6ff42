// SPDX-License-Identifier: MIT
// Draws a laid-out plot on a canvas.
#include <algorithm>
#include <cmath>

#include "app/plots/plot_layout.h"

namespace pabd {
namespace {

Stroke series_stroke(SeriesStyle style, Color color, double width) {
  Stroke stroke{color, width, 0, 0};
  if (style == SeriesStyle::dashed) {
    stroke.dash_on = 3.2 * width;
    stroke.dash_off = 2.2 * width;
  }
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

void paint_grid(const PlotLayout& layout, const PlotStyle& style, Canvas& canvas) {
  const Rect& in = layout.inner;
  for (const bool major : {false, true}) {
    const Color color = major ? style.theme.grid : style.theme.minor_grid;
    for (const Tick& tick : layout.x.ticks) {
      if (tick.major == major)
        canvas.vertical(in.x + layout.x.unit(tick.value) * in.w, in.y, in.bottom(), color, style.grid);
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
    canvas.vertical(in.x + layout.x.unit(0) * in.w, in.y, in.bottom(), style.theme.zero_line, style.grid);
  }
}

void paint_vertical_axis(const AxisScale& axis, const std::string& label, bool right, Color color,
                         const PlotLayout& layout, const PlotStyle& style, Canvas& canvas) {
  const Rect& in = layout.inner;
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
    canvas.text({right ? layout.area.right() : layout.area.x, above}, head, text);
    return;
  }
  text.x = right ? AlignX::right : AlignX::left;
  if (!axis.factor.empty()) canvas.text({edge, above}, axis.factor, text);
  if (label.empty()) return;
  text.size = style.label;
  text.vertical = true;
  text.x = AlignX::center;
  text.y = right ? AlignY::bottom : AlignY::top;
  canvas.text({right ? layout.area.right() : layout.area.x, in.y + 0.5 * in.h}, label, text);
}

void paint_horizontal_axis(const Plot& plot, const PlotLayout& layout, const PlotStyle& style,
                           Canvas& canvas) {
  const Rect& in = layout.inner;
  TextStyle text{style.tick, style.theme.text, AlignX::center, AlignY::top};
  for (const Tick& tick : layout.x.ticks) {
    const double x = in.x + layout.x.unit(tick.value) * in.w;
    canvas.vertical(x, in.bottom(), in.bottom() + style.tick_length * (tick.major ? 1 : 0.55),
                    style.theme.axis, style.grid);
    if (tick.major) canvas.text({x, in.bottom() + style.tick_length + style.gap}, tick.label, text);
  }
  canvas.horizontal(in.x, in.right() + 1, in.bottom(), style.theme.axis, style.grid);
  const double below =
      in.bottom() + style.tick_length + style.gap + FontMetrics::cap * style.tick + 0.55 * style.label;
  text.size = style.label;
  if (!plot.x.label.empty()) canvas.text({in.x + 0.5 * in.w, below}, plot.x.label, text);
  if (!layout.x.factor.empty()) {
    text.size = style.tick;
    text.x = AlignX::right;
    canvas.text({in.right(), below}, layout.x.factor, text);
  }
}

void paint_series(const Series& series, Color color, const PlotLayout& layout, const PlotStyle& style,
                  Canvas& canvas) {
  const Rect& in = layout.inner;
  const Stroke stroke = series_stroke(series.style, color, style.line * series.weight);
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
    const std::size_t count = std::min(series.x.size(), series.y.size());
    const double radius = style.marker * series.weight;
    for (std::size_t i = 0; series.crowd && i < count; ++i) {
      const Point p = layout.map(series.x[i], series.y[i], series.right_axis);
      if (in.inset(-1).contains(p)) canvas.fill_circle(p, 1.35 * radius, style.theme.rim);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const Point p = layout.map(series.x[i], series.y[i], series.right_axis);
      if (!in.inset(-1).contains(p)) continue;
      if (series.crowd) {
        canvas.fill_circle(p, radius, i < series.marker_colors.size() ? series.marker_colors[i] : color);
        continue;
      }
      paint_marker(p, radius, i < series.marker_colors.size() ? series.marker_colors[i] : color, style,
                   canvas);
    }
    return;
  }
  for (const std::vector<Point>& run : pixel_runs(layout, series)) {
    if (run.size() == 1) {
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
      canvas.polyline(ends, series_stroke(entry.style, entry.color, style.line * entry.weight));
    }
    const double gap = (style.compact ? 0.4 : 0.6) * style.tick;
    canvas.text({entry.at.x + legend.sample + gap, entry.at.y}, entry.name,
                {style.tick, style.theme.text, AlignX::left, AlignY::middle});
  }
}

}  // namespace

void paint_plot(const Plot& plot, const PlotLayout& layout, const PlotStyle& style, Canvas& canvas) {
  const Rect& in = layout.inner;
  if (!plot.title.empty()) {
    const TextStyle title{style.title, style.theme.text, style.compact ? AlignX::left : AlignX::center,
                          AlignY::top};
    canvas.text({style.compact ? layout.area.x : in.x + 0.5 * in.w, layout.area.y}, plot.title, title);
  }
  if (layout.empty) {
    canvas.stroke_rect(in, style.theme.grid, style.grid);
    canvas.text({in.x + 0.5 * in.w, in.y + 0.5 * in.h}, plot.none,
                {style.label, style.theme.muted, AlignX::center, AlignY::middle});
    return;
  }
  paint_grid(layout, style, canvas);
  canvas.push_clip(in);
  for (const bool markers : {false, true}) {
    if (markers) canvas.pop_clip();  // markers at the edge are shown whole
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
      if ((plot.series[i].style == SeriesStyle::markers) == markers) {
        paint_series(plot.series[i], layout.colors[i], layout, style, canvas);
      }
    }
  }
  paint_horizontal_axis(plot, layout, style, canvas);
  paint_vertical_axis(layout.y, plot.y.label, false, layout.left_ink, layout, style, canvas);
  if (layout.has_right) {
    paint_vertical_axis(layout.y_right, plot.y_right.label, true, layout.right_ink, layout, style, canvas);
  }
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
