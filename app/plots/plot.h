// SPDX-License-Identifier: MIT
// A plot as data: what is drawn, not how. Painters: ImGui draw list, SVG, CSV.
// Texts are rich text (rich_text.h): "B_{N}" has a subscript.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace pabd {

// 8 bits a channel, sRGB, straight alpha.
struct Color {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  bool operator==(const Color&) const = default;
};

struct Axis {
  std::string label;  // with unit: "d [m]"
  bool log = false;
  // Range; lo == hi: fitted to the data.
  double lo = 0;
  double hi = 0;
  // A fitted linear range is at least this wide: rounding noise is not blown up to full height.
  double min_span = 0;
  bool integer = false;  // ticks at whole numbers only (iterations, steps)
};

// level: one horizontal line at y[0]; level_x: one vertical line at x[0]. Both are references and do not
// widen the fitted range of the other axis. bars: from 0 (from the foot of a log axis) to y, centred at x.
// strip: bars again, in a band of their own between the curves and the horizontal axis, with the name in it:
// how many there are at x, where markers would hide each other.
enum class SeriesStyle : std::uint8_t { line, dashed, markers, level, level_x, bars, strip };

// Patterns of lines: solid, dashed, dotted, long dashes.
inline constexpr int kDashes = 4;

struct Series {
  std::string name;  // for the legend; empty: not listed
  std::vector<double> x;
  std::vector<double> y;  // non-finite values break the line
  SeriesStyle style = SeriesStyle::line;
  int color = -1;  // index into the palette; -1: next
  int ramp = 0;  // of a list in order: how many values it has, and `color` is the place of this one; 0: none
  int dash = 0;  // of a line: which pattern, 0 … kDashes − 1; `dashed` is pattern 1
  bool right_axis = false;
  std::vector<Color> marker_colors;  // one a point or bar; empty: the colour of the series
  double weight = 1;                 // multiplies the width of the line, the size of the markers
  bool crowd = false;                // markers: below the curves, one where many would touch (CrowdMarker)
  double bar_width = 0;              // in units of x
  std::string quantity;              // in CSV after the name, where it is not that of the axis: "B/d̂² [1]"
  std::string tag;                   // written beside a level, a level_x or the last marker
};

// A reference line across the plot at y, or upright at x.
inline Series horizontal_line(double y, std::string tag = {}) {
  Series series;
  series.style = SeriesStyle::level;
  series.y = {y};
  series.tag = std::move(tag);
  return series;
}
inline Series vertical_line(double x, std::string tag = {}) {
  Series series;
  series.style = SeriesStyle::level_x;
  series.x = {x};
  series.tag = std::move(tag);
  return series;
}

// One marker.
inline Series marker(double x, double y, int color, std::string tag = {}) {
  Series series;
  series.style = SeriesStyle::markers;
  series.color = color;
  series.x = {x};
  series.y = {y};
  series.tag = std::move(tag);
  return series;
}

// A curve with one point per element of `data`: (x(element), y(element)).
template <class Data, class X, class Y>
Series curve(std::string name, int color, const Data& data, const X& x, const Y& y) {
  Series series;
  series.name = std::move(name);
  series.color = color;
  series.x.reserve(data.size());
  series.y.reserve(data.size());
  for (const auto& element : data) {
    series.x.push_back(x(element));
    series.y.push_back(y(element));
  }
  return series;
}

// An entry of a legend that names a property of curves and not one curve: "N = 3" is a colour.
struct PlotKey {
  std::string name;
  int color;
  int dash = 0;
  int ramp = 0;
};

struct Plot {
  std::string title;
  Axis x;
  Axis y;
  Axis y_right;  // used when a series asks for it
  std::vector<Series> series;
  std::vector<PlotKey> keys;     // the legend in place of the names of the series, where there are any
  std::string none = "no data";  // said where there is nothing to draw
  std::string caption;           // small, below: what it is of
};

// Said by plots of a run that has not begun.
inline constexpr const char* kBeforeSteps = "begins with the first step";

struct PlotRange {
  double lo, hi;
  bool operator==(const PlotRange&) const = default;
};

// Plots side by side (columns) under one title: a figure.
struct Figure {
  std::string title;
  std::string caption;  // one or two lines under the plots: parameters and what is to be seen
  std::vector<Plot> plots;
  int columns = 1;
};

}  // namespace pabd
