// A plot as data: what is drawn, not how. Painters: ImGui draw list, SVG, CSV.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pabd {

struct Axis {
  std::string label;  // with unit: "d [m]"
  bool log = false;
  // Range; lo == hi: fitted to the data.
  double lo = 0;
  double hi = 0;
};

enum class SeriesStyle : std::uint8_t { line, dashed, markers, level };  // level: one horizontal line at y[0]

struct Series {
  std::string name;  // for the legend; empty: not listed
  std::vector<double> x;
  std::vector<double> y;  // non-finite values break the line
  SeriesStyle style = SeriesStyle::line;
  int color = -1;      // index into the palette; -1: next
  bool right_axis = false;
};

struct Plot {
  std::string title;
  Axis x;
  Axis y;
  Axis y_right;  // used when a series asks for it
  std::vector<Series> series;
};

// Plots side by side (columns) under one title: a figure.
struct Figure {
  std::string title;
  std::string caption;  // one or two lines under the plots: parameters and what is to be seen
  std::vector<Plot> plots;
  int columns = 1;
};

}  // namespace pabd
