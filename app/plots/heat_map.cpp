// SPDX-License-Identifier: MIT
// See heat_map.h.
#include "app/plots/heat_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "sim/base/srgb.h"

namespace pabd {
namespace {

constexpr double kBar = 16;  // width of the bar, px at scale 1
constexpr double kHeatWidth = 84, kHeatHeight = 54;
constexpr int kBarSteps = 96;

std::size_t columns_of(const HeatMap& map) { return std::max<std::size_t>(1, map.x_names.size()); }
std::size_t rows_of(const HeatMap& map) { return std::max<std::size_t>(1, map.y_names.size()); }

// Panels in rows that are about as wide as high, three at most.
int panel_columns(const HeatMap& map) {
  const int n = static_cast<int>(map.panels.size());
  return n <= 3 ? std::max(1, n) : n == 4 ? 2 : 3;
}
int panel_rows(const HeatMap& map) {
  const int n = std::max(1, static_cast<int>(map.panels.size()));
  return (n + panel_columns(map) - 1) / panel_columns(map);
}

double widest(const std::vector<std::string>& names, const FontMetrics& font, double size) {
  double width = 0;
  for (const std::string& name : names) width = std::max(width, text_width(font, name, size));
  return width;
}

AxisScale scale_of(const HeatMap& map, double height, const PlotStyle& style) {
  DataRange range;
  for (const HeatPanel& panel : map.panels) {
    for (const double value : panel.values) range.add(value, map.log);
  }
  const int ticks = std::clamp(static_cast<int>(height / (3.2 * style.tick)), 2, 8);
  return fit_axis({.label = {}, .log = map.log}, range, ticks, 0);
}

Color empty_cell(const PlotTheme& theme) {
  Color grey = theme.reference;
  grey.a = 46;
  return grey;
}

double luminance(Color c) {
  return 0.2126 * linear_from_srgb(c.r / 255.0) + 0.7152 * linear_from_srgb(c.g / 255.0) +
         0.0722 * linear_from_srgb(c.b / 255.0);
}

// Every so many names are written, so that they do not touch.
std::size_t stride_for(double room, double size) {
  return room >= size ? 1 : static_cast<std::size_t>(std::ceil(size / std::max(room, 1e-6)));
}

}  // namespace

bool wants_log(const std::vector<double>& values) {
  DataRange range;
  for (const double value : values) {
    if (value <= 0) return false;
    range.add(value, true);
  }
  return !range.empty && range.hi > 30 * range.lo;
}

Color ink_on(Color background) {
  // (1.05 / (L + 0.05) against (L + 0.05) / 0.05: equal at L = 0.179 (WCAG 2.1).
  return luminance(background) > 0.179 ? Color{17, 22, 28, 255} : Color{255, 255, 255, 255};
}

Color color_of(const HeatMap& map, const HeatLayout& layout, double value) {
  if (!std::isfinite(value)) return empty_cell(layout.style.theme);
  const double place = map.log && value <= 0 ? 0 : layout.scale.unit(value);
  return map.color ? map.color(std::clamp(place, 0.0, 1.0)) : layout.style.theme.palette[0];
}

PictureSize default_size(const HeatMap& map) {
  const int columns = panel_columns(map), rows = panel_rows(map);
  const double w =
      std::clamp(kHeatWidth * static_cast<double>(columns_of(map)), 300.0, columns > 1 ? 620.0 : 1200.0);
  const double h =
      std::clamp(kHeatHeight * static_cast<double>(rows_of(map)), 220.0, rows > 1 ? 420.0 : 800.0);
  return {static_cast<int>(columns * (w + 110) + 150), static_cast<int>(rows * (h + 100) + 110)};
}

HeatLayout layout_heat_map(const HeatMap& map, double width, double height, const FontMetrics& font,
                           const PlotTheme& theme) {
  HeatLayout layout;
  const PictureSize best = default_size(map);
  const double scale = std::clamp(std::min(width / best.width, height / best.height), 0.7, 3.0);
  layout.style = figure_style().scaled(scale);
  layout.style.theme = theme;
  const PlotStyle& style = layout.style;
  const double margin = 1.6 * style.tick, line = FontMetrics::line * style.tick;
  double top = margin, bottom = height - margin;
  if (!map.title.empty()) top += 2.2 * style.title;
  if (!map.caption.empty()) {
    layout.caption = wrap_text(font, map.caption, style.tick, width - 4 * margin);
    bottom -= static_cast<double>(layout.caption.size()) * line + style.tick;
  }
  // The bar, its ticks and its label stand to the right of everything.
  layout.scale = scale_of(map, bottom - top, style);
  std::vector<std::string> ticks;
  for (const Tick& tick : layout.scale.ticks) ticks.push_back(tick.label);
  const double bar = kBar / 11.5 * style.tick;
  const double right = width - margin - 1.5 * style.label - style.gap - widest(ticks, font, style.tick) -
                       style.tick_length - style.gap - bar;
  // Every panel has its names and labels.
  const bool titles =
      std::any_of(map.panels.begin(), map.panels.end(), [](const HeatPanel& p) { return !p.title.empty(); });
  const double above = titles ? 1.7 * style.label : 0;
  layout.room_left = style.gap + widest(map.y_names, font, style.tick) +
                     (map.y_label.empty() ? 0 : style.gap + FontMetrics::line * style.label);
  const int columns = panel_columns(map), rows = panel_rows(map);
  const double gap = 1.4 * style.tick;
  const double w = (right - gap - margin) / columns - gap - layout.room_left;
  const double names = widest(map.x_names, font, style.tick);
  layout.vertical = names > w / static_cast<double>(columns_of(map)) - 0.4 * style.tick;
  layout.room_below = style.gap + (layout.vertical ? names : style.tick) +
                      (map.x_label.empty() ? 0 : style.gap + FontMetrics::line * style.label);
  const double h = (bottom - top) / rows - above - layout.room_below - (rows > 1 ? gap : 0);
  for (std::size_t i = 0; i < map.panels.size(); ++i) {
    const double column = static_cast<double>(static_cast<int>(i) % columns),
                 row = static_cast<double>(static_cast<int>(i) / columns);
    layout.panels.push_back({margin + column * (w + layout.room_left + gap) + layout.room_left,
                             top + row * (bottom - top) / rows + above, std::max(w, 1.0), std::max(h, 1.0)});
  }
  const double foot = bottom - layout.room_below;
  layout.bar = {right, top + above, bar, std::max(1.0, foot - top - above)};
  return layout;
}

Rect cell_rect(const HeatMap& map, const HeatLayout& layout, std::size_t panel, std::size_t column,
               std::size_t row) {
  const Rect& inner = layout.panels[panel];
  // Whole pixels with one between, so that cells have sharp edges.
  const auto x = [&](std::size_t i) {
    return std::round(inner.x + inner.w * static_cast<double>(i) / static_cast<double>(columns_of(map)));
  };
  const auto y = [&](std::size_t i) {
    return std::round(inner.bottom() - inner.h * static_cast<double>(i) / static_cast<double>(rows_of(map)));
  };
  return {x(column), y(row + 1), std::max(1.0, x(column + 1) - x(column) - 1),
          std::max(1.0, y(row) - y(row + 1) - 1)};
}

void paint_heat_axes(const HeatMap& map, const HeatLayout& layout, std::size_t panel, Canvas& canvas) {
  const PlotStyle& style = layout.style;
  const Rect& inner = layout.panels[panel];
  const double w = inner.w / static_cast<double>(columns_of(map)),
               h = inner.h / static_cast<double>(rows_of(map));
  const double line = FontMetrics::line * style.tick;
  const TextStyle tick{style.tick, style.theme.text};
  const std::size_t every =
      stride_for(w, layout.vertical ? line : widest(map.x_names, canvas.font(), style.tick));
  for (std::size_t i = 0; i < map.x_names.size(); i += every) {
    TextStyle text = tick;
    text.vertical = layout.vertical;
    text.x = layout.vertical ? AlignX::right : AlignX::center;
    text.y = layout.vertical ? AlignY::middle : AlignY::top;
    canvas.text({inner.x + (static_cast<double>(i) + 0.5) * w, inner.bottom() + style.gap}, map.x_names[i],
                text);
  }
  for (std::size_t i = 0; i < map.y_names.size(); i += stride_for(h, line)) {
    TextStyle text = tick;
    text.x = AlignX::right;
    text.y = AlignY::middle;
    canvas.text({inner.x - style.gap, inner.bottom() - (static_cast<double>(i) + 0.5) * h}, map.y_names[i],
                text);
  }
  if (!map.x_label.empty()) {
    canvas.text({inner.x + 0.5 * inner.w, inner.bottom() + layout.room_below}, map.x_label,
                {style.label, style.theme.text, AlignX::center, AlignY::bottom});
  }
  if (!map.y_label.empty()) {
    canvas.text({inner.x - layout.room_left, inner.y + 0.5 * inner.h}, map.y_label,
                {.size = style.label,
                 .color = style.theme.text,
                 .x = AlignX::center,
                 .y = AlignY::top,
                 .vertical = true});
  }
}

void paint_heat_sign(const Rect& cell, HeatSign sign, const PlotTheme& theme, double width, Canvas& canvas) {
  if (sign == HeatSign::none) return;
  const double r = 0.28 * std::min(cell.w, cell.h);
  const Point c{cell.x + 0.5 * cell.w, cell.y + 0.5 * cell.h};
  if (sign == HeatSign::dot) return canvas.fill_circle(c, 0.5 * r, theme.muted);
  const Point up[] = {{c.x - r, c.y + r}, {c.x + r, c.y - r}},
              down[] = {{c.x - r, c.y - r}, {c.x + r, c.y + r}};
  canvas.polyline(up, {theme.muted, width});
  if (sign == HeatSign::cross) canvas.polyline(down, {theme.muted, width});
}

void paint_heat_cell(const HeatMap& map, const HeatLayout& layout, std::size_t panel, std::size_t index,
                     Canvas& canvas) {
  const PlotStyle& style = layout.style;
  const std::size_t columns = columns_of(map);
  const Rect cell = cell_rect(map, layout, panel, index % columns, index / columns);
  const HeatPanel& data = map.panels[panel];
  const double value =
      index < data.values.size() ? data.values[index] : std::numeric_limits<double>::quiet_NaN();
  const Color color = color_of(map, layout, value);
  canvas.fill_rect(cell, color);
  const Point middle{cell.x + 0.5 * cell.w, cell.y + 0.5 * cell.h};
  const auto fits = [&](const std::string& text) {
    return text_width(canvas.font(), text, style.tick) <= cell.w - 6 && cell.h >= 1.5 * style.tick;
  };
  if (std::isfinite(value)) {
    for (const int digits : {3, 2, 1}) {
      const std::string text = format_value(value, digits);
      if (!fits(text)) continue;
      canvas.text(middle, text, {style.tick, ink_on(color), AlignX::center, AlignY::middle});
      break;
    }
  } else if (index < data.marks.size()) {
    const HeatMark& mark = data.marks[index];
    if (!mark.word.empty() && fits(mark.word)) {
      canvas.text(middle, mark.word, {style.tick, style.theme.muted, AlignX::center, AlignY::middle});
    } else {
      paint_heat_sign(cell, mark.sign, style.theme, 1.5 * style.grid, canvas);
    }
  }
}

void paint_color_bar(const Rect& bar, const AxisScale& scale, const std::function<Color(double)>& color,
                     const std::string& label, const PlotStyle& style, Canvas& canvas) {
  for (int i = 0; i < kBarSteps; ++i) {
    const double y0 = std::round(bar.bottom() - bar.h * (i + 1) / kBarSteps),
                 y1 = std::round(bar.bottom() - bar.h * i / kBarSteps);
    canvas.fill_rect({bar.x, y0, bar.w, y1 - y0}, color((i + 0.5) / kBarSteps));
  }
  double widest_label = 0;
  for (const Tick& tick : scale.ticks) {
    const double y = bar.bottom() - bar.h * scale.unit(tick.value);
    canvas.horizontal(bar.right(), bar.right() + (tick.major ? 1 : 0.6) * style.tick_length, y,
                      style.theme.axis, style.grid);
    if (tick.label.empty()) continue;
    widest_label = std::max(widest_label, text_width(canvas.font(), tick.label, style.tick));
    canvas.text({bar.right() + style.tick_length + 0.6 * style.gap, y}, tick.label,
                {style.tick, style.theme.text, AlignX::left, AlignY::middle});
  }
  const std::string words = scale.factor.empty() ? label : label + " " + scale.factor;
  canvas.text({bar.right() + style.tick_length + 1.6 * style.gap + widest_label, bar.y + 0.5 * bar.h}, words,
              {.size = style.label,
               .color = style.theme.text,
               .x = AlignX::center,
               .y = AlignY::top,
               .vertical = true});
}

void paint_heat_map(const HeatMap& map, double width, double height, Canvas& canvas, const PlotTheme& theme) {
  const HeatLayout layout = layout_heat_map(map, width, height, canvas.font(), theme);
  const PlotStyle& style = layout.style;
  const double margin = 1.6 * style.tick;
  paint_title(map.title, width, margin, style, canvas);
  for (std::size_t panel = 0; panel < map.panels.size(); ++panel) {
    const Rect& inner = layout.panels[panel];
    if (!map.panels[panel].title.empty()) {
      canvas.text({inner.x + 0.5 * inner.w, inner.y - style.gap}, map.panels[panel].title,
                  {style.label, theme.text, AlignX::center, AlignY::bottom});
    }
    for (std::size_t i = 0; i < columns_of(map) * rows_of(map); ++i)
      paint_heat_cell(map, layout, panel, i, canvas);
    paint_heat_axes(map, layout, panel, canvas);
  }
  if (map.color) paint_color_bar(layout.bar, layout.scale, map.color, map.value_label, style, canvas);
  const double lines = static_cast<double>(layout.caption.size());
  paint_caption(layout.caption, width, height - margin - lines * FontMetrics::line * style.tick, style,
                canvas);
}

Picture heat_map_picture(HeatMap map, const PlotTheme& theme) {
  const auto shared = std::make_shared<const HeatMap>(std::move(map));
  return [shared, theme](Canvas& canvas, double width, double height) {
    paint_heat_map(*shared, width, height, canvas, theme);
  };
}

}  // namespace pabd
