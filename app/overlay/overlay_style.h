// SPDX-License-Identifier: MIT
// What panels share: colours, sizes, and plots.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/overlay/overlay.h"
#include "app/overlay/overlay_panel_table.h"
#include "app/plots/plot.h"
#include "app/plots/theme.h"
#include "sim/math/types.h"

namespace pabd::overlay_style {

inline constexpr std::uint8_t kOpaque = 232, kRimOpaque = 26;  // alpha of boxes and of their rims
// px at scale 1
inline constexpr double kPad = 10;
inline constexpr double kTitle = 12, kText = 10.5;
inline constexpr double kLegendWidth = 300, kLegendHeight = 50;

// Linear light as the screen shows it, sRGB.
Color screen_ink(const Vec4f& color);

// The inks of panels: light ones on a dark picture.
const PlotTheme& inks_of(const OverlayData& data);

// A translucent box of the paper of `inks` with a rim; the radius of its corners is 5 px at scale 1.
void paint_box(const Rect& rect, double scale, const PlotTheme& inks, Canvas& canvas);

// Which scene and step it is of, and the parameters; the scene's name comes from `data`.
std::string caption_of(const OverlayData& data);

void paint_small_plot(const Plot& plot, const Rect& rect, double scale, const PlotTheme& inks,
                      Canvas& canvas);
// OverlayPanel::paint of a panel that is a plot.
template <Plot (*plot_of)(const OverlayData& data)>
void paint_plot_of(const Rect& rect, double scale, const OverlayData& data, Canvas& canvas) {
  paint_small_plot(plot_of(data), rect, scale, inks_of(data), canvas);
}

// A name, and at its right a bar whose colour at a part of its width (0 … 1) `color_at` says, with numbers below.
struct ScaleMark {
  double at;  // part of the bar's width
  std::string text;
};
void paint_color_scale(const Rect& rect, double scale, const std::string& name,
                       const std::vector<ScaleMark>& marks, const std::function<Color(double)>& color_at,
                       const PlotTheme& inks, Canvas& canvas);
// The same for value_color() over a range.
void paint_value_scale(const Rect& rect, double scale, const std::string& name, const ValueRange& range,
                       const PlotTheme& inks, Canvas& canvas);

// Joints of the model that is shown.
std::size_t joints_of(const OverlayData& data);

// Over the whole video, where its time is known.
void hold_time(const OverlayData& data, Plot& plot);

// Of a plot whose data is not there.
Plot empty_plot(const std::string& title);

}  // namespace pabd::overlay_style
