// SPDX-License-Identifier: MIT
// Where everything of a plot goes, in pixels: computed once from the data and the sizes of the texts, then
// painted by any canvas.
//
//   inner    the rectangle of the data
//   map      (x, y) in data units → pixel
#pragma once

#include <string>
#include <vector>

#include "app/plots/axis_ticks.h"
#include "app/plots/canvas.h"
#include "app/plots/plot.h"
#include "app/plots/theme.h"

namespace pabd {

// Sizes in pixels. `scaled` multiplies all of them.
struct PlotStyle {
  double title = 15;
  double label = 13;
  double tick = 11.5;
  double line = 2.0;
  double grid = 1.0;
  double marker = 3.4;     // radius
  double tick_length = 4;  // outwards
  double gap = 6;          // between texts and what they name
  // Panels over a picture: the labels of both vertical axes stand above them, the legend in rows under the
  // title.
  bool compact = false;
  PlotTheme theme = light_theme();

  PlotStyle scaled(double s) const;
};
PlotStyle panel_style();   // compact, at 720 px frame height
PlotStyle figure_style();  // for figures of 1600 × 700

inline constexpr double kCaption = 0.84;  // size of a caption's letters, in tick labels

struct LegendEntry {
  std::string name;
  SeriesStyle style;
  int dash;
  Color color;
  double weight;
  Point at;  // left end of its sample line, on the middle of its text
};

struct Legend {
  std::vector<LegendEntry> entries;
  Rect box;            // empty without entries
  bool boxed = false;  // over the data: drawn on a background
  double sample = 0;   // length of the sample lines
};

// A short text beside a reference line or a marker.
struct PlotTag {
  std::string text;
  Rect box;  // of the text
  Color color;
};

struct PlotLayout {
  Rect area;
  Rect inner;
  double title = 0;  // size of the title's letters; 0: none, or no room for it
  Rect strip;        // between the inside and the horizontal axis; without height: none
  AxisScale x, y, y_right;
  bool has_right = false;
  bool empty = false;         // nothing to draw: "no data"
  std::vector<Color> colors;  // one a series
  Color left_ink,
      right_ink;  // colours of the vertical axes: those of their series when they have one each
  std::vector<Color> left_chips,
      right_chips;  // of two axes: the colours of one that has several, to stand beside its label
  Legend legend;
  std::vector<PlotTag> tags;
  std::vector<std::string> caption;  // lines; the last one ends at the bottom of `area`

  double foot() const { return strip.h > 0 ? strip.bottom() : inner.bottom(); }  // of the horizontal axis
  // NaN coordinates for what the axes cannot show.
  Point map(double px, double py, bool right_axis = false) const;
  // The inverse: data units at a pixel. Outside of `inner` the axes go on; NaN there with `only_inside`.
  Point unmap(const Point& pixel, bool right_axis = false, bool only_inside = false) const;
};

// Whether anything of a series is seen: a log axis shows no zero, a given range not all values.
bool is_drawn(const Series& series, const Plot& plot);

// Gives both plots the axes that hold the data of both, as two pictures side by side need it.
void share_axes(Plot& a, Plot& b);

PlotLayout layout_plot(const Plot& plot, const Rect& area, const PlotStyle& style, const FontMetrics& font);

inline constexpr double kStripWords = 1.2;  // height of the line above a strip, in tick labels

// The bar number `index` of a strip: as high as the band where it is the highest one.
Rect strip_bar(const PlotLayout& layout, const Series& series, std::size_t index);

// The pixels of a line or of markers: runs between breaks, thinned so that a run has a bounded number of
// points a pixel column (first, lowest, highest, last of each column), far-off points pulled in.
std::vector<std::vector<Point>> pixel_runs(const PlotLayout& layout, const Series& series);

// The rectangle of bar `index`, cut off at the inside; its width or height is 0 when nothing of it is seen.
Rect bar_rect(const PlotLayout& layout, const Series& series, std::size_t index);

// Many markers in one place: thousands of contacts on a curve leave the curve in sight.
inline constexpr double kCrowdSpacing = 3.2;  // between those that are drawn, in radii

// A marker that stands for itself and for those that would touch it.
struct CrowdMarker {
  std::size_t index;  // of the point that it is drawn for
  Point at;           // px
  std::size_t count;  // of points, itself included
};

// The markers of a series inside of the plot, in its order: a point less than `spacing` px from one before it
// is counted there and not drawn. All points are in one of the counts.
std::vector<CrowdMarker> thin_crowd(const PlotLayout& layout, const Series& series, double spacing);

// How much larger a marker is that stands for `count`: 1, and at most half of the spacing, so that they do not
// touch.
double crowd_size(std::size_t count);

void paint_plot(const Plot& plot, const PlotLayout& layout, const PlotStyle& style, Canvas& canvas);

}  // namespace pabd
