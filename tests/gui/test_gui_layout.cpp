// SPDX-License-Identifier: MIT
// Where the window's parts are, at every size: nothing overlaps, and every panel can be had.
#include <catch2/catch.hpp>

#include "app/gui/gui_layout.h"

namespace pabd::test_gui_layout {

namespace {

std::vector<Rect> parts_of(const GuiLayout& layout) {
  std::vector<Rect> out = {layout.toolbar, layout.timeline, layout.view};
  for (const Slot slot : kSlots)
    if (layout.slots[slot].w > 0) out.push_back(layout.slots[slot]);
  return out;
}

}  // namespace

TEST_CASE("nothing overlaps, and the picture keeps its room") {
  for (const int width : {200, 360, 500, 768, 800, 1000, 1039, 1040, 1280, 1920, 3840}) {
    for (const int height : {300, 400, 800, 1024, 2160}) {
      for (const double unit : {1.0, 1.5, 2.0}) {
        CAPTURE(width, height, unit);
        const GuiLayout layout = layout_gui({}, width, height, unit, false);
        const std::vector<Rect> parts = parts_of(layout);
        const Rect window{0, 0, static_cast<double>(width), static_cast<double>(height)};
        for (std::size_t i = 0; i < parts.size(); ++i) {
          CHECK(window.contains(parts[i]));
          for (std::size_t k = 0; k < i; ++k) CHECK_FALSE(parts[i].overlaps(parts[k]));
        }
        CHECK(parts.size() == (layout.joined ? 4 : 6));
        CHECK(layout.joined == (width < 1040 * unit));
        CHECK(layout.view.w >= 0.45 * std::min(width, static_cast<int>(320 * unit)));
      }
    }
  }
}

TEST_CASE("where there is room for one place, it shows what was asked for last, of what is open") {
  UiState ui;
  const auto shown = [&](int width, int height) {
    const GuiLayout layout = layout_gui(ui, width, height, 1, false);
    std::string out = layout.joined ? "joined:" : "";
    for (const Slot slot : kSlots)
      if (layout.slots[slot].w > 0) out += " " + std::string(slot_name(slot));
    return out;
  };
  CHECK(shown(1280, 720) == " left right_top right_bottom");
  CHECK(shown(800, 600) == "joined: left");
  ui.front = Slot::right_bottom;
  CHECK(shown(800, 600) == "joined: right_bottom");
  CHECK(shown(360, 800) == "joined: right_bottom");
  ui.open[Slot::right_bottom] = false;
  CHECK(shown(800, 600) == "joined: left");
  ui.open[Slot::left] = false;
  CHECK(shown(800, 600) == " right_top");  // which leaves the picture its room
  CHECK(shown(600, 600) == "joined: right_top");
  ui.open[Slot::right_top] = false;
  CHECK(shown(360, 800).empty());
  // Below the picture of a portrait window, else at its left.
  const GuiLayout portrait = layout_gui({}, 360, 800, 1, false),
                  landscape = layout_gui({}, 800, 600, 1, false);
  CHECK(portrait.slots[Slot::left].w == 360);
  CHECK(portrait.slots[Slot::left].y == portrait.view.bottom());
  CHECK(landscape.slots[Slot::left].right() == landscape.view.x);
}

}  // namespace pabd::test_gui_layout
