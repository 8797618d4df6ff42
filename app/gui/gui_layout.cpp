// SPDX-License-Identifier: MIT
// See gui_layout.h.
#include "app/gui/gui_layout.h"

#include <algorithm>
#include <cmath>

namespace pabd {
namespace {

// Pixels of an ordinary screen.
constexpr double kToolbar = 38, kTimeline = 74, kLeft = 332, kRight = 388;
constexpr double kLeastView = 320, kWide = 1.35;  // columns grow up to this on wide windows

// The one that was asked for last, of those that are open.
Slot front_slot(const UiState& ui) {
  if (ui.open[ui.front]) return ui.front;
  return *std::find_if(std::begin(kSlots), std::end(kSlots), [&](Slot slot) { return ui.open[slot]; });
}

void join(GuiLayout& out, Slot front, double w, double middle, double top, double unit) {
  if (w < middle) {
    const double view = std::round(0.45 * middle);
    out.view = {0, top, w, view};
    out.slots[front] = {0, top + view, w, middle - view};
  } else {
    const double column = std::round(std::min(kRight * unit, 0.55 * w));
    out.slots[front] = {0, top, column, middle};
    out.view = {column, top, w - column, middle};
  }
}

}  // namespace

GuiLayout layout_gui(const UiState& ui, int width, int height, double unit, bool two) {
  GuiLayout out;
  const double w = width, h = height;
  if (ui.hidden) {
    out.view = {0, 0, w, h};
  } else {
    const double grow = std::clamp(w / unit / 1280, 1.0, kWide);
    const double toolbar = std::round(kToolbar * unit), timeline = std::round(kTimeline * unit);
    const double left = ui.open[Slot::left] ? std::round(kLeft * grow * unit) : 0;
    const bool top = ui.open[Slot::right_top], bottom = ui.open[Slot::right_bottom];
    const double right = top || bottom ? std::round(kRight * grow * unit) : 0;
    const double middle = std::max(0.0, h - toolbar - timeline);
    out.toolbar = {0, 0, w, toolbar};
    out.timeline = {0, h - timeline, w, timeline};
    if (left + right > 0 && w - left - right < kLeastView * unit) {
      out.joined = true;
      join(out, front_slot(ui), w, middle, toolbar, unit);
    } else {
      out.view = {left, toolbar, w - left - right, middle};
      out.slots[Slot::left] = {0, toolbar, left, left > 0 ? middle : 0};
      if (right > 0) {
        const double split = top && bottom ? std::round(0.58 * middle) : top ? middle : 0;
        if (top) out.slots[Slot::right_top] = {w - right, toolbar, right, split};
        if (bottom) out.slots[Slot::right_bottom] = {w - right, toolbar + split, right, middle - split};
      }
    }
  }
  out.views[0] = out.view;
  if (two) {
    const double half = std::floor(0.5 * out.view.w);
    out.views[0].w = half;
    out.views[1] = {out.view.x + half, out.view.y, out.view.w - half, out.view.h};
  }
  return out;
}

}  // namespace pabd
