// SPDX-License-Identifier: MIT
// A figure laid out and painted; CSV.
#include "app/plots/figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/plots/theme.h"

namespace pabd {
namespace {

constexpr double kReferenceHeight = 700;  // of figure_style
constexpr double kCellWidth = 620;        // below this width of a plot the texts shrink too

int row_count(const Figure& figure) {
  const int columns = std::max(1, figure.columns);
  return (static_cast<int>(figure.plots.size()) + columns - 1) / columns;
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

std::string csv_number(double v) { return std::isnan(v) ? "nan" : fmt::format("{}", v); }

// Of a figure: what a small one leaves out.
struct Parts {
  bool title, caption;
  std::size_t plots;  // the first so many
};

// Whether curves have room beside titles, labels and ticks.
bool is_readable(const Figure& figure, const FigureLayout& layout, const FontMetrics& font) {
  const double tick = layout.style.tick;
  for (std::size_t i = 0; i < layout.cells.size(); ++i) {
    const Rect& cell = layout.cells[i];
    if (cell.w < 14 * tick || cell.h < 9 * tick) return false;
    const Rect inner = layout_plot(figure.plots[i], cell, layout.style, font).inner;
    if (inner.w < 8 * tick || inner.h < 4 * tick) return false;
  }
  return true;
}

// Size of the letters of a figure's title; 0: no room.
double title_size(const std::string& title, double width, const PlotStyle& style, const FontMetrics& font) {
  return fitted_size(font, title, 1.15 * style.title, style.tick, width - style.tick);
}

FigureLayout layout_parts(const Figure& figure, const Parts& parts, double width, double height,
                          const FontMetrics& font, const PlotTheme& theme) {
  FigureLayout layout;
  const auto count = static_cast<int>(parts.plots);
  const int columns = std::clamp(figure.columns, 1, std::max(1, count));
  const int rows = std::max(1, (count + columns - 1) / columns);
  const double scale = std::min(height / (100 + rows * (rows > 2 ? 430 : kReferenceHeight - 100)),
                                width / (columns * kCellWidth));
  layout.style = figure_style().scaled(std::max(scale, 0.6) * 1.25);
  layout.style.theme = theme;
  const PlotStyle& style = layout.style;
  const double margin = std::min(1.6 * style.tick, 0.04 * std::min(width, height));
  double top = margin, bottom = height - margin;
  if (parts.title && !figure.title.empty() && title_size(figure.title, width, style, font) > 0) {
    layout.title = {margin, top, width - 2 * margin, 1.2 * style.title};
    top += 2.2 * style.title;
  }
  if (parts.caption && !figure.caption.empty()) {
    double wrap = width - 4 * margin;
    layout.caption_lines = wrap_text(font, figure.caption, style.tick, wrap);
    // Lines of about equal length: no single word on the last one.
    for (auto lines = layout.caption_lines;
         lines.size() == layout.caption_lines.size() && lines.size() > 1 && wrap > 0.5 * width;) {
      layout.caption_lines = lines;
      wrap *= 0.96;
      lines = wrap_text(font, figure.caption, style.tick, wrap);
    }
    const double lines = static_cast<double>(layout.caption_lines.size());
    layout.caption = {2 * margin, bottom - lines * FontMetrics::line * style.tick, width - 4 * margin,
                      lines * FontMetrics::line * style.tick};
    bottom = layout.caption.y - 1.1 * style.tick;
  }
  const double gap = 2.4 * style.tick;
  const double w = (width - 2 * margin - (columns - 1) * gap) / columns;
  const double h = (bottom - top - (rows - 1) * gap) / rows;
  for (int i = 0; i < count; ++i)
    layout.cells.push_back({margin + i % columns * (w + gap), top + i / columns * (h + gap), w, h});
  return layout;
}

}  // namespace

PictureSize default_size(const Figure& figure) {
  const int columns = std::max(1, figure.columns);
  const int rows = std::max(1, row_count(figure));
  const int height = rows > 2 ? 430 : 600;  // of a row
  return {columns == 1 ? 1000 : columns * 800 - (columns > 2 ? 150 * columns : 0), 100 + rows * height};
}

FigureLayout layout_figure(const Figure& figure, double width, double height, const FontMetrics& font,
                           const PlotTheme& theme) {
  // In this order, as long as the plots are too small to be read.
  Parts parts{true, true, figure.plots.size()};
  FigureLayout layout = layout_parts(figure, parts, width, height, font, theme);
  while (!is_readable(figure, layout, font) && (parts.caption || parts.title || parts.plots > 1)) {
    if (parts.caption) {
      parts.caption = false;
    } else if (parts.title) {
      parts.title = false;
    } else {
      --parts.plots;
    }
    layout = layout_parts(figure, parts, width, height, font, theme);
  }
  return layout;
}

void paint_title(const std::string& title, double width, double y, const PlotStyle& style, Canvas& canvas) {
  const double size = title_size(title, width, style, canvas.font());
  if (title.empty() || size == 0) return;
  canvas.text({0.5 * width, y}, title, {size, style.theme.text, AlignX::center, AlignY::top});
}

void paint_caption(const std::vector<std::string>& lines, double width, double y, const PlotStyle& style,
                   Canvas& canvas) {
  for (const std::string& line : lines) {
    canvas.text({0.5 * width, y}, line, {style.tick, style.theme.muted, AlignX::center, AlignY::top});
    y += FontMetrics::line * style.tick;
  }
}

Picture figure_picture(Figure figure, const PlotTheme& theme) {
  const auto shared = std::make_shared<const Figure>(std::move(figure));
  return [shared, theme](Canvas& canvas, double width, double height) {
    const FigureLayout layout = layout_figure(*shared, width, height, canvas.font(), theme);
    const PlotStyle& style = layout.style;
    if (layout.title.h > 0) paint_title(shared->title, width, layout.title.y, style, canvas);
    for (std::size_t i = 0; i < layout.cells.size(); ++i) {
      const Plot& plot = shared->plots[i];
      paint_plot(plot, layout_plot(plot, layout.cells[i], style, canvas.font()), style, canvas);
    }
    paint_caption(layout.caption_lines, width, layout.caption.y, style, canvas);
  };
}

std::string figure_to_svg(const Figure& figure, int width, int height, const PlotTheme& theme) {
  return picture_to_svg(figure_picture(figure, theme), width, height, theme.paper);
}

std::string figure_to_csv(const Figure& figure) {
  std::string out = "plot,series,x,y\n";
  for (std::size_t p = 0; p < figure.plots.size(); ++p) {
    const Plot& plot = figure.plots[p];
    const std::string title = !plot.title.empty()        ? plot.title
                              : figure.plots.size() == 1 ? figure.title
                                                         : std::to_string(p + 1);
    const std::string plot_name = csv_field(plain_text(title));
    for (std::size_t s = 0; s < plot.series.size(); ++s) {
      const Series& series = plot.series[s];
      const std::string& label = series.right_axis ? plot.y_right.label : plot.y.label;
      std::string text = series.name.empty() ? label : series.name;
      if (!series.quantity.empty())
        text = series.name.empty() ? series.quantity : text + ", " + series.quantity;
      const std::string name = csv_field(plain_text(text));
      const auto row = [&](const std::string& x, const std::string& y) {
        out += plot_name + ',' + name + ',' + x + ',' + y + '\n';
      };
      if (series.style == SeriesStyle::level) {
        if (!series.y.empty()) row("", csv_number(series.y[0]));
      } else if (series.style == SeriesStyle::level_x) {
        if (!series.x.empty()) row(csv_number(series.x[0]), "");
      } else {
        for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
          row(csv_number(series.x[i]), csv_number(series.y[i]));
        }
      }
    }
  }
  return out;
}

}  // namespace pabd
