// SPDX-License-Identifier: MIT
// What a table says of a panel is found by its tab's slot, by commands and by their help.
#include <catch2/catch.hpp>
#include <set>

#include "app/gui/panel.h"
#include "sim/base/error.h"

namespace pabd::test_window_panel {

using Catch::Matchers::Contains;

TEST_CASE("every panel is found by its name and has one tab") {
  std::set<std::string> names;
  std::size_t tabs = 0;
  for (const WindowPanel* panel : window_panels()) {
    CHECK(&find_panel(panel->name) == panel);
    names.insert(panel->name);
  }
  for (const Slot slot : kSlots) tabs += panels_of(slot).size();
  CHECK(names.size() == window_panels().size());
  CHECK(tabs == window_panels().size());
  CHECK(panel_words() == "parameters, inspector, scenes, sweep, barrier, convergence, series or compare");
  // What the window begins with fits its slots.
  const UiState ui;
  for (const Slot slot : kSlots) CHECK(ui.shown[slot]->slot == slot);
}

TEST_CASE("a made-up panel in a table is found by command, help and tabs") {
  const WindowPanel clock = {.name = "clock",
                             .title = "Clock",
                             .help = "The time",
                             .slot = Slot::right_top,
                             .make = nullptr,
                             .contacts = true};
  std::vector<const WindowPanel*> table(window_panels().begin(), window_panels().end());
  table.push_back(&clock);
  CHECK(&find_panel("clock", table) == &clock);
  CHECK_THROWS_WITH(find_panel("clock"), Contains("\"clock\" is not one of \"parameters\""));
  CHECK_THROWS_WITH(find_panel("clocks", table), Contains("\"compare\" or \"clock\""));
  CHECK_THAT(panel_words(table), Contains("series, compare or clock"));
  CHECK(panels_of(Slot::right_top, table).back() == &clock);
  CHECK(panels_of(Slot::left, table).size() == panels_of(Slot::left).size());

  UiState ui;
  CHECK_FALSE(ui.shows(clock));
  ui.shown[clock.slot] = &clock;
  CHECK(ui.shows(clock));
  ui.open[clock.slot] = false;
  CHECK_FALSE(ui.shows(clock));
  ui.open[clock.slot] = true;
  ui.hidden = true;
  CHECK_FALSE(ui.shows(clock));
}

TEST_CASE("the tab of a sweep is there while one is open") {
  UiState ui;
  REQUIRE(sweep_tab.offered != nullptr);
  CHECK_FALSE(sweep_tab.offered(ui));
  ui.sweep.folder = "/some/where";
  CHECK(sweep_tab.offered(ui));
}

}  // namespace pabd::test_window_panel
