// SPDX-License-Identifier: MIT
// A number over two quantities that take a few values each, as colours of cells; several of them side by side
// share one scale.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/plots/figure.h"
#include "app/plots/plot_layout.h"

namespace pabd {

// What stands in a cell without a value where its word has no room.
enum class HeatSign : std::uint8_t { none, cross, stroke, dot };

struct HeatMark {
  std::string word;
  HeatSign sign = HeatSign::none;
};

struct HeatPanel {
  std::string title;            // empty: none
  std::vector<double> values;   // columns × rows, the lowest row first; not finite: no value
  std::vector<HeatMark> marks;  // of the cells without value; empty: no words
};

struct HeatMap {
  std::string title, caption;
  std::string x_label, y_label, value_label;  // with units
  std::vector<std::string> x_names, y_names;  // of the columns and rows
  std::vector<HeatPanel> panels;
  bool log = false;                          // the scale of the colours; values ≤ 0 then get its lowest
  std::function<Color(double place)> color;  // 0 … 1 along the scale
};

struct HeatLayout {
  PlotStyle style;
  AxisScale scale;                       // of the colours
  std::vector<Rect> panels;              // the cells of each
  Rect bar;                              // of the colours
  bool vertical = false;                 // names of columns read upwards
  double room_left = 0, room_below = 0;  // for the names and labels of a panel
  std::vector<std::string> caption;
};

PictureSize default_size(const HeatMap& map);
HeatLayout layout_heat_map(const HeatMap& map, double width, double height, const FontMetrics& font,
                           const PlotTheme& theme = light_theme());
Rect cell_rect(const HeatMap& map, const HeatLayout& layout, std::size_t panel, std::size_t column,
               std::size_t row);
// The colour of a value; of what is none the grey of empty cells.
Color color_of(const HeatMap& map, const HeatLayout& layout, double value);

// A cell by its index, with its value, word or sign; names and labels of a panel; the sign in a cell alone.
void paint_heat_cell(const HeatMap& map, const HeatLayout& layout, std::size_t panel, std::size_t index,
                     Canvas& canvas);
void paint_heat_axes(const HeatMap& map, const HeatLayout& layout, std::size_t panel, Canvas& canvas);
void paint_heat_sign(const Rect& cell, HeatSign sign, const PlotTheme& theme, double width, Canvas& canvas);
void paint_heat_map(const HeatMap& map, double width, double height, Canvas& canvas,
                    const PlotTheme& theme = light_theme());
Picture heat_map_picture(HeatMap map, const PlotTheme& theme = light_theme());

// Black or white, whichever can be read on it.
Color ink_on(Color background);

// The scale of colours by itself: a bar with its ticks and its label, which reads upwards, to the right of it.
void paint_color_bar(const Rect& bar, const AxisScale& scale, const std::function<Color(double)>& color,
                     const std::string& label, const PlotStyle& style, Canvas& canvas);

// Whether a logarithmic scale suits the values: all positive, and over more than a decade and a half.
bool wants_log(const std::vector<double>& values);

}  // namespace pabd
