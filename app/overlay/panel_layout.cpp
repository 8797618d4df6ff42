// SPDX-License-Identifier: MIT
// Where the panels are.
#include "app/overlay/panel_layout.h"

#include <algorithm>
#include <cmath>

namespace pabd {
namespace {

constexpr double kMargin = 14;   // px at 1280 × 720
constexpr double kGap = 0.6;     // between panels of one place, in margins
constexpr double kLeast = 0.62;  // plots may be lower than they wish by this factor
// Below this scale text is too small to read: panels of small frames take more of the frame instead.
constexpr double kLeastScale = 0.72;
// What would have to be smaller, or leaves the picture less of the frame, is left out.
constexpr double kReadable = 0.62, kLeastFree = 0.25;
constexpr double kLeastPicture =
    0.52;  // of the height, between panels above and below; or it is three to two

Rect snapped(double x, double y, double w, double h) {
  const double x0 = std::round(x), y0 = std::round(y);
  return {x0, y0, std::round(x + w) - x0, std::round(y + h) - y0};
}

struct Wish {
  const OverlayPanel* panel;
  double width, height;
};

// What panels of one place wish for together.
struct Place {
  std::vector<Wish> wishes;
  double widest = 0, tallest = 0, heights = 0;

  int count() const { return static_cast<int>(wishes.size()); }
  void add(const Wish& wish) {
    wishes.push_back(wish);
    widest = std::max(widest, wish.width);
    tallest = std::max(tallest, wish.height);
    heights += wish.height;
  }
  void drop_last() {
    std::vector<Wish> rest(wishes.begin(), wishes.end() - 1);
    *this = {};
    for (const Wish& wish : rest) add(wish);
  }
};

Place wishes_of(PanelPlace place, const OverlayOptions& options, const OverlayData& data) {
  Place out;
  for (const OverlayPanel* panel : options.shown()) {
    if (panel->place != place || (panel->applies && !panel->applies(data))) continue;
    const double height = panel->height + (panel->more_height ? panel->more_height(data) : 0);
    out.add({panel, panel->width, height});
  }
  return out;
}

// Of texts and lines, so that all of it has its place.
double scale_of(const Place& top, const Place& column, const Place& legends, int width, int height) {
  const double needed_width = std::max(top.widest, legends.widest) + column.widest + 3 * kMargin;
  const double needed_height =
      std::max(top.heights + legends.heights + (top.count() + legends.count() + 1) * kMargin,
               column.count() * (kLeast * column.tallest + kGap * kMargin) + 2 * kMargin);
  const double s = std::max(kLeastScale, std::min(width / 1280.0, height / 720.0));
  return std::min({s, width / needed_width, height / needed_height});
}

// Some at the left, the plots at the right.
PanelLayout place_beside(const Place& top, const Place& column, const Place& legends, int width, int height) {
  PanelLayout layout;
  const double s = scale_of(top, column, legends, width, height);
  layout.scale = s;

  const double margin = kMargin * s, gap = kGap * margin;
  double y = margin;
  for (const Wish& wish : top.wishes) {
    layout.panels.push_back({wish.panel, snapped(margin, y, wish.width * s, wish.height * s)});
    y += wish.height * s + gap;
  }
  double right = width, column_end = 0;
  if (column.count() > 0) {
    const double h =
        std::min(column.tallest * s, (height - 2 * margin - (column.count() - 1) * gap) / column.count());
    right = width - margin - column.widest * s;
    y = margin;
    for (const Wish& wish : column.wishes) {
      layout.panels.push_back({wish.panel, snapped(right, y, column.widest * s, h)});
      y += h + gap;
    }
    right -= margin;
    column_end = y - gap + margin;
  }
  double bottom = height;
  for (const Wish& wish : legends.wishes) {
    bottom -= (bottom == height ? margin : gap) + wish.height * s;
    layout.panels.push_back({wish.panel, snapped(margin, bottom, wish.width * s, wish.height * s)});
  }
  if (legends.count() > 0) bottom -= margin;

  // Candidates: beside the panels at the top, or below them; left of the plots, or below them.
  const bool any = top.count() > 0;
  const double beside = any ? 2 * margin + top.widest * s : 0;
  const double below = any ? 2 * margin + top.heights * s + (top.count() - 1) * gap : 0;
  for (const Rect& candidate :
       {Rect{beside, 0, right - beside, bottom}, Rect{0, below, right, bottom - below},
        Rect{0, std::max(below, column_end), static_cast<double>(width),
             bottom - std::max(below, column_end)}}) {
    if (candidate.w > 0 && candidate.h > 0 && candidate.w * candidate.h > layout.free.w * layout.free.h) {
      layout.free = candidate;
    }
  }
  return layout;
}

// The plots in rows below the picture, all else in a row above it.
PanelLayout place_in_bands(const Place& top, const Place& plots, const Place& legends, double s, int width,
                           int height) {
  PanelLayout layout;
  layout.scale = s;
  const double margin = kMargin * s, gap = kGap * margin, inner = width - 2 * margin;
  double x = margin, y = margin, row = 0;  // height of the row
  for (const Place* place : {&top, &legends}) {
    for (const Wish& wish : place->wishes) {
      if (x > margin && x + wish.width * s > width - margin) {
        x = margin;
        y += row + gap;
        row = 0;
      }
      layout.panels.push_back({wish.panel, snapped(x, y, wish.width * s, wish.height * s)});
      x += wish.width * s + gap;
      row = std::max(row, wish.height * s);
    }
  }
  const double above = row > 0 ? y + row + margin : 0;
  double below = height;
  if (const int count = plots.count(); count > 0) {
    const int fit = static_cast<int>((inner + gap) / (plots.widest * s + gap));
    const int rows = (count + std::max(fit, 1) - 1) / std::max(fit, 1), columns = (count + rows - 1) / rows;
    const double h = plots.tallest * s, start = height - margin - rows * h - (rows - 1) * gap;
    for (int k = 0; k < count; ++k) {
      const int in_row = std::min(columns, count - k / columns * columns);
      const double w = (inner - (in_row - 1) * gap) / in_row;
      const Rect at = snapped(margin + k % columns * (w + gap), start + k / columns * (h + gap), w, h);
      layout.panels.push_back({plots.wishes[static_cast<std::size_t>(k)].panel, at});
    }
    below = start - margin;
  }
  layout.free = {0, above, static_cast<double>(width), below - above};
  return layout;
}

// How wide a picture of three to two finds its place.
double picture_width(const Rect& free) { return std::min(free.w, 1.5 * free.h); }

PanelLayout place(const Place& top, const Place& column, const Place& legends, int width, int height) {
  PanelLayout beside = place_beside(top, column, legends, width, height);
  const double widest = std::max({top.widest, column.widest, legends.widest}) + 2 * kMargin;
  if (width > height || beside.panels.empty()) return beside;
  // As large as in a frame of 1280 × 720 that is as wide as this one is, or as high, as far as the picture keeps its place.
  for (double s = std::min(width, height) / 720.0; s >= kLeastScale; s *= 0.97) {
    if (widest * s > width) continue;
    PanelLayout bands = place_in_bands(top, column, legends, s, width, height);
    if (bands.free.h < std::min(kLeastPicture * height, width / 1.5)) continue;
    return picture_width(bands.free) >= picture_width(beside.free) ? bands : beside;
  }
  return beside;
}

}  // namespace

PanelLayout layout_panels(const OverlayOptions& options, const OverlayData& data, int width, int height) {
  Place top = wishes_of(PanelPlace::top_left, options, data);
  Place column = wishes_of(PanelPlace::column, options, data);
  Place legends = wishes_of(PanelPlace::bottom_left, options, data);
  PanelLayout layout = place(top, column, legends, width, height);
  const auto is_good = [&] {
    return layout.scale >= kReadable && layout.free.w * layout.free.h >= kLeastFree * width * height;
  };
  while (!is_good() && layout.panels.size() > 1) {  // who asks for one gets it
    Place& least = column.count() > 1 || (top.count() == 0 && legends.count() == 0) ? column
                   : legends.count() > 0                                            ? legends
                   : column.count() > 0                                             ? column
                                                                                    : top;
    least.drop_last();
    layout = place(top, column, legends, width, height);
  }
  return layout;
}

}  // namespace pabd
