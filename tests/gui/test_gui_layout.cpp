// SPDX-License-Identifier: MIT
// Where the window's parts are, at every size: nothing overlaps, and every panel can be had.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "app/gui/gui_layout.h"

namespace pabd::test_gui_layout {

namespace {

std::vector<Rect> parts_of(const GuiLayout& layout) {
  std::vector<Rect> out = {layout.toolbar, layout.timeline, layout.view};
  for (const Slot slot : kSlots)
    if (layout.slots[slot].w > 0) out.push_back(layout.slots[slot]);
  return out;
}

void check_apart(const GuiLayout& layout, int width, int height) {
  const std::vector<Rect> parts = parts_of(layout);
  const Rect window{0, 0, static_cast<double>(width), static_cast<double>(height)};
  double area = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    CHECK(window.contains(parts[i]));
    for (std::size_t k = 0; k < i; ++k) CHECK_FALSE(parts[i].overlaps(parts[k]));
    area += parts[i].w * parts[i].h;
  }
  CHECK(area == static_cast<double>(width) * height);  // and nothing is between them
  for (const LayoutBorder& border : layout.borders) {
    double covered = 0;  // by panels
    for (const Slot slot : kSlots) {
      const Rect &a = layout.slots[slot], &b = border.rect;
      covered += std::max(0.0, std::min(a.right(), b.right()) - std::max(a.x, b.x)) *
                 std::max(0.0, std::min(a.bottom(), b.bottom()) - std::max(a.y, b.y));
    }
    CHECK(covered == border.rect.w * border.rect.h);
    CHECK(window.contains(border.rect));
  }
}

const LayoutBorder& border_of(const GuiLayout& layout, Border what) {
  for (const LayoutBorder& border : layout.borders)
    if (border.what == what) return border;
  FAIL("there is no such border");
  return layout.borders.front();
}

}  // namespace

TEST_CASE("nothing overlaps, and the picture keeps its room") {
  for (const int width : {200, 360, 500, 768, 800, 1000, 1039, 1040, 1280, 1920, 3840}) {
    for (const int height : {300, 400, 640, 800, 1024, 1280, 2160}) {
      for (const double unit : {1.0, 1.5, 2.0}) {
        CAPTURE(width, height, unit);
        const GuiLayout layout = layout_gui({}, width, height, unit, false);
        check_apart(layout, width, height);
        CHECK(layout.view.w >= 0.45 * std::min(width, static_cast<int>(320 * unit)));
        CHECK(layout.view.h >= std::floor(0.4 * (height - std::round(38 * unit) - std::round(74 * unit))));
      }
    }
  }
}

TEST_CASE("every panel is reachable in a window of any size, and then has room there") {
  for (const auto& [width, height, unit] : {std::tuple{360, 640, 1.0},
                                            {360, 800, 1.0},
                                            {640, 360, 1.0},
                                            {800, 600, 1.0},
                                            {720, 1280, 1.0},
                                            {768, 1024, 1.0},
                                            {1000, 700, 1.0},
                                            {1280, 480, 1.0},
                                            {1280, 720, 1.0},
                                            {1920, 1080, 1.0},
                                            {1080, 1920, 1.0},
                                            {3840, 2160, 1.0},
                                            {3840, 2160, 2.0},
                                            {720, 1280, 2.0}}) {
    UiState ui;
    ui.sweep.folder = "/some/where";  // its tab is offered
    for (const WindowPanel* panel : window_panels()) {
      CAPTURE(width, height, unit, panel->name);
      // A tab of a place that is seen.
      const GuiLayout before = layout_gui(ui, width, height, unit, false);
      int tabs = 0;
      for (const Slot slot : kSlots) {
        if (before.slots[slot].w <= 0) continue;
        for (const WindowPanel* tab : tabs_of(before, ui, slot)) tabs += tab == panel ? 1 : 0;
      }
      CHECK(tabs == 1);
      // What the tab does.
      ui.bring(*panel);
      const GuiLayout layout = layout_gui(ui, width, height, unit, false);
      check_apart(layout, width, height);
      CHECK(ui.shows(*panel));
      CHECK(layout.place[panel->slot] == panel->slot);
      CHECK(layout.slots[panel->slot].w >= 280 * unit);
      CHECK(layout.slots[panel->slot].h >= 190 * unit);
    }
  }
}

TEST_CASE("places without room for two show what was asked for last, of what is open") {
  UiState ui;
  const auto shown = [&](int width, int height) {
    const GuiLayout layout = layout_gui(ui, width, height, 1, false);
    std::string out;
    for (const Slot slot : kSlots)
      if (layout.slots[slot].w > 0)
        out += fmt::format(" {}:{}", slot_name(slot), tabs_of(layout, ui, slot).size());
    return out;
  };
  CHECK(shown(1280, 720) == " left:3 right_top:2 right_bottom:2");
  CHECK(shown(1000, 700) == " left:3 right_top:2 right_bottom:2");
  CHECK(shown(720, 1280) == " left:3 right_top:2 right_bottom:2");  // below the picture
  CHECK(shown(1280, 480) == " left:3 right_top:4");
  CHECK(shown(800, 600) == " right_top:7");
  ui.bring(convergence_tab);
  CHECK(shown(1280, 480) == " left:3 right_bottom:4");
  CHECK(shown(360, 800) == " right_bottom:7");
  ui.bring(parameters_tab);
  CHECK(shown(1280, 480) == " left:3 right_bottom:4");  // that side stays as it is
  CHECK(shown(360, 800) == " left:7");
  ui.open[Slot::left] = false;
  CHECK(shown(800, 600) == " right_top:2 right_bottom:2");  // which leaves the picture its room
  CHECK(shown(600, 480) == " right_bottom:7");
  ui.open[Slot::right_bottom] = false;
  CHECK(shown(800, 600) == " right_top:4");
  ui.open[Slot::right_top] = false;
  CHECK(shown(360, 800).empty());
  // Below the picture of a portrait window, else at its right.
  const GuiLayout portrait = layout_gui({}, 360, 800, 1, false),
                  landscape = layout_gui({}, 800, 600, 1, false);
  CHECK(portrait.slots[Slot::right_top].w == 360);
  CHECK(portrait.slots[Slot::right_top].y == portrait.view.bottom());
  CHECK(landscape.slots[Slot::right_top].x == landscape.view.right());
}

TEST_CASE("a border that is dragged goes with the mouse, as far as the others have room") {
  for (const auto& [width, height, unit] : {std::tuple{360, 640, 1.0},
                                            {800, 600, 1.0},
                                            {720, 1280, 1.0},
                                            {1000, 700, 1.0},
                                            {1280, 720, 1.0},
                                            {3840, 2160, 1.0},
                                            {3840, 2160, 2.0}}) {
    UiState ui;
    const GuiLayout start = layout_gui(ui, width, height, unit, false);
    CHECK_FALSE(start.borders.empty());
    for (const LayoutBorder& border : start.borders) {
      for (const double moved : {-5000.0, -400.0, -20.0, 20.0, 400.0, 5000.0}) {
        CAPTURE(width, height, unit, static_cast<int>(border.what), moved);
        ui.sizes = {};
        const double at = border.upright ? border.rect.x : border.rect.y;
        const double to = at + moved;
        ui.sizes[border.what] = border.size_at({to, to});
        const SizeRange range = size_range(border.what);
        CHECK(ui.sizes[border.what] >= range.least);  // that the command takes
        CHECK(ui.sizes[border.what] <= range.most);
        const GuiLayout layout = layout_gui(ui, width, height, unit, false);
        check_apart(layout, width, height);
        CHECK(layout.view.w >= std::min(360 * unit, start.view.w) - 1);
        CHECK(layout.view.h >= 0.19 * start.view.h);
        const Rect& now = border_of(layout, border.what).rect;
        const double reached = border.upright ? now.x : now.y;
        // It is at the mouse, or where it can go no farther.
        const double grip = border.what == Border::left ? border.rect.w : 0;
        const double size = ui.sizes[border.what];
        if (size > border.least && size < border.most) {
          CHECK(std::abs(reached + grip - to) <= 1);
        } else {
          CHECK((reached - at) * moved >= 0);
        }
      }
    }
  }
}

TEST_CASE("widths that were chosen in a wide window give way in a narrow one") {
  UiState ui;
  ui.sizes[Border::left] = 600;
  ui.sizes[Border::right] = 700;
  const GuiLayout wide = layout_gui(ui, 1920, 1080, 1, false), narrow = layout_gui(ui, 1000, 700, 1, false),
                  tall = layout_gui(ui, 720, 1280, 1, false), phone = layout_gui(ui, 360, 640, 1, false);
  CHECK(wide.slots[Slot::left].w == 600);
  CHECK(wide.slots[Slot::right_top].w == 700);
  CHECK(narrow.view.w >= 360);
  CHECK(narrow.slots[Slot::left].w >= 280);
  CHECK(narrow.slots[Slot::right_top].w >= 320);
  CHECK(tall.slots[Slot::right_top].w == 320);
  CHECK(phone.slots[Slot::right_top].w == 360);
}

TEST_CASE("a bar leaves out what is ranked last, and the wider it is the more it has") {
  const std::vector<BarItem> items = {{60, 0}, {130, 5, true}, {70, 2}, {50, 3}, {150, 4}, {25, 1}};
  constexpr double kGap = 7, kMenu = 27;
  std::vector<bool> before(items.size(), false);
  for (double room = 0; room < 600; room += 1) {
    CAPTURE(room);
    const std::vector<bool> shown = bar_items(items, room, kGap, kMenu);
    double used = -kGap;
    bool menu = false;
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (shown[i]) used += items[i].width + kGap;
      menu = menu || (!shown[i] && !items[i].spare);
      CHECK((shown[i] || !before[i]));
    }
    if (menu) used += kGap + kMenu;
    if (room >= kMenu) CHECK(used <= room);
    before = shown;
  }
  CHECK(before == std::vector<bool>(items.size(), true));
  // All but the name, which is in no menu: there is none.
  CHECK(bar_items(items, 60 + 70 + 50 + 150 + 25 + 4 * kGap, kGap, kMenu) ==
        std::vector<bool>{true, false, true, true, true, true});
}

}  // namespace pabd::test_gui_layout
