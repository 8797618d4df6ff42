// SPDX-License-Identifier: MIT
// See gui_layout.h.
#include "app/gui/gui_layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pabd {
namespace {

// Pixels of an ordinary screen.
constexpr double kToolbar = 38, kTimeline = 74;
constexpr double kLeft = 332, kRight = 388, kWide = 1.35;  // columns, which grow up to this on wide windows
constexpr double kLeastLeft = 280, kLeastRight = 320, kLeastView = 360;
constexpr double kPortrait = 1.2;                  // width over height of the room for picture and panels
constexpr double kLeastPlace = 190;                // height of two places above each other
constexpr double kGripAcross = 8, kGripAlong = 6;  // of a border, within the panel's padding
constexpr double kColumn = 0.55;                   // most of the width that one column has by itself
// Parts of the height.
constexpr double kUpper = 0.58, kBelow = 0.55, kBelowNarrow = 0.6, kLeastPart = 0.2, kMostPart = 0.8;

class Arranger {
 public:
  Arranger(const UiState& ui, double width, double unit, GuiLayout& out)
      : ui_(ui), unit_(unit), grow_(std::clamp(width / unit / 1280, 1.0, kWide)), out_(out) {
    left_ = ui.open[Slot::left];
    right_ = ui.open[Slot::right_top] || ui.open[Slot::right_bottom];
  }

  void arrange(const Rect& room) {
    out_.view = room;
    if (!left_ && !right_) return;
    if (room.w < kPortrait * room.h) {
      below(room);
    } else if (fits(room.w)) {
      columns(room);
    } else {
      column(room);
    }
  }

 private:
  double px(double ordinary) const { return std::round(ordinary * unit_); }
  double wanted(Border border) const {
    if (ui_.sizes[border] != 0) return px(ui_.sizes[border]);
    return px((border == Border::left ? kLeft : kRight) * grow_);
  }
  double part(Border border, double usual) const {
    const double size = ui_.sizes[border];
    return size == 0 ? usual : std::clamp(size, kLeastPart, kMostPart);
  }
  double least_left() const { return left_ ? px(kLeastLeft) : 0; }
  double least_right() const { return right_ ? px(kLeastRight) : 0; }
  bool fits(double width) const { return least_left() + least_right() + px(kLeastView) <= width; }

  void add_border(Border what, const Rect& rect, bool upright, double zero, double scale, double least,
                  double most) {
    out_.borders.push_back({what, rect, upright, zero, scale, least, std::max(least, most)});
  }

  // The picture in the middle. Where it has too little room the column at the right gives way first.
  void columns(const Rect& room) {
    const double both = room.w - px(kLeastView);
    const double left = left_ ? std::clamp(wanted(Border::left), least_left(), both - least_right()) : 0;
    const double right = right_ ? std::clamp(wanted(Border::right), least_right(), both - left) : 0;
    out_.view = {room.x + left, room.y, room.w - left - right, room.h};
    if (left_) {
      out_.slots[Slot::left] = {room.x, room.y, left, room.h};
      left_border(out_.slots[Slot::left], both - least_right());
    }
    if (!right_) return;
    const Rect column{room.right() - right, room.y, right, room.h};
    right_slots(column);
    right_border(column, least_right(), both - left);
  }

  void left_border(const Rect& column, double most) {
    const double grip = px(kGripAcross);
    add_border(Border::left, {column.right() - grip, column.y, grip, column.h}, true, column.x, unit_,
               kLeastLeft, most / unit_);
  }
  void right_border(const Rect& column, double least, double most) {
    add_border(Border::right, {column.x, column.y, px(kGripAcross), column.h}, true, column.right(), -unit_,
               least / unit_, most / unit_);
  }

  // One column at the right.
  void column(const Rect& room) {
    const double least = std::min(px(kLeastRight), std::round(kColumn * room.w));
    const double most = std::max(least, room.w - px(kLeastView));
    const double width = ui_.sizes[Border::right] == 0
                             ? std::min(wanted(Border::right), std::round(kColumn * room.w))
                             : std::clamp(wanted(Border::right), least, most);
    const Rect at{room.right() - width, room.y, width, room.h};
    out_.view = {room.x, room.y, room.w - width, room.h};
    one_place(at, {Slot::left, Slot::right_top, Slot::right_bottom});
    right_border(at, least, most);
  }

  void below(const Rect& room) {
    const bool two = left_ && right_ && least_left() + least_right() <= room.w;
    const double height = std::round(part(Border::below, two ? kBelow : kBelowNarrow) * room.h);
    const Rect at{room.x, room.bottom() - height, room.w, height};
    out_.view = {room.x, room.y, room.w, room.h - height};
    if (two) {
      const double share = wanted(Border::left) / (wanted(Border::left) + wanted(Border::right));
      const double asked = ui_.sizes[Border::left] == 0 ? std::round(share * room.w) : wanted(Border::left);
      const double left = std::clamp(asked, least_left(), room.w - least_right());
      out_.slots[Slot::left] = {at.x, at.y, left, at.h};
      right_slots({at.x + left, at.y, at.w - left, at.h});
      left_border(out_.slots[Slot::left], room.w - least_right());
    } else {
      one_place(at, {Slot::left, Slot::right_top, Slot::right_bottom});
    }
    add_border(Border::below, {at.x, at.y, at.w, px(kGripAlong)}, false, room.bottom(), -room.h, kLeastPart,
               kMostPart);
  }

  void right_slots(const Rect& at) {
    const double least = px(kLeastPlace) / at.h;
    if (!ui_.open[Slot::right_top] || !ui_.open[Slot::right_bottom] || least > 0.5)
      return one_place(at, {Slot::right_top, Slot::right_bottom});
    const double upper = std::round(std::clamp(part(Border::upper, kUpper), least, 1 - least) * at.h);
    out_.slots[Slot::right_top] = {at.x, at.y, at.w, upper};
    out_.slots[Slot::right_bottom] = {at.x, at.y + upper, at.w, at.h - upper};
    const double part = std::max(least, kLeastPart);
    add_border(Border::upper, {at.x, at.y + upper, at.w, px(kGripAlong)}, false, at.y, at.h, part, 1 - part);
  }

  // The slot that was asked for last, of those that are open, with the tabs of the others.
  void one_place(const Rect& at, std::initializer_list<Slot> slots) {
    const auto has = [&](Slot slot) { return std::find(slots.begin(), slots.end(), slot) != slots.end(); };
    const Slot front = *std::find_if(ui_.front.begin(), ui_.front.end(),
                                     [&](Slot slot) { return has(slot) && ui_.open[slot]; });
    out_.slots[front] = at;
    for (const Slot slot : slots) out_.place[slot] = front;
  }

  const UiState& ui_;
  double unit_, grow_;
  bool left_, right_;  // columns with something open
  GuiLayout& out_;
};

}  // namespace

double LayoutBorder::size_at(const Point& mouse) const {
  return std::clamp(((upright ? mouse.x : mouse.y) - zero) / scale, least, most);
}

GuiLayout layout_gui(const UiState& ui, int width, int height, double unit, bool two) {
  GuiLayout out;
  const double w = width, h = height;
  for (const Slot slot : kSlots) out.place[slot] = slot;
  if (ui.hidden) {
    out.view = {0, 0, w, h};
  } else {
    const double toolbar = std::round(kToolbar * unit), timeline = std::round(kTimeline * unit);
    out.toolbar = {0, 0, w, toolbar};
    out.timeline = {0, h - timeline, w, timeline};
    Arranger(ui, w, unit, out).arrange({0, toolbar, w, std::max(0.0, h - toolbar - timeline)});
  }
  out.views[0] = out.view;
  if (two) {
    const double half = std::floor(0.5 * out.view.w);
    out.views[0].w = half;
    out.views[1] = {out.view.x + half, out.view.y, out.view.w - half, out.view.h};
  }
  return out;
}

std::vector<const WindowPanel*> tabs_of(const GuiLayout& layout, const UiState& ui, Slot place) {
  std::vector<const WindowPanel*> out;
  for (const WindowPanel* panel : window_panels()) {
    if (layout.place[panel->slot] != place) continue;
    if (panel == ui.shown[panel->slot] || !panel->offered || panel->offered(ui)) out.push_back(panel);
  }
  return out;
}

std::vector<bool> bar_items(std::span<const BarItem> items, double room, double gap, double menu) {
  std::vector<bool> out(items.size(), true);
  std::vector<std::size_t> order(items.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return items[a].rank < items[b].rank; });
  double used = -gap;
  for (const BarItem& item : items) used += item.width + gap;
  double more = 0;  // for the menu, as soon as something is in it
  for (; !order.empty() && used + more > room; order.pop_back()) {
    const BarItem& last = items[order.back()];
    out[order.back()] = false;
    used -= last.width + gap;
    if (!last.spare) more = gap + menu;
  }
  return out;
}

}  // namespace pabd
