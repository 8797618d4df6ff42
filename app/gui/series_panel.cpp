// SPDX-License-Identifier: MIT
// Quantities over time, what happened on the way, and the present moment; a click or a drag goes to a step.
#include <algorithm>
#include <string>
#include <vector>

#include "app/gui/panel_plots.h"
#include "app/gui/panels.h"
#include "app/gui/plot_reading.h"

namespace pabd {
namespace {

class SeriesPanel final : public GuiPanel {
 public:
  void draw(GuiFrame& f) override {
    if (const char* what =
            choice_combo("##what", kSeriesViews, f.ui.series, f.px(112), "What of every step is plotted"))
      send(f, what, f.ui.series_x, f.ui.series_y);
    ImGui::SameLine();
    const bool chosen = f.ui.series == kChosenSeries;
    if (!chosen) hint(f);
    const bool own_line = chosen && !fit_beside(f);
    if (chosen && !own_line) choose(f, 0.5f * (room_beside(f) - f.px(4)));
    export_button(f, series_tab.name, path_);
    if (own_line) choose(f, 0.5f * (ImGui::GetContentRegionAvail().x - f.px(4)));
    update(f);
    const PlotTouch touch = panel_plot(f, series_tab.name, plot_, ImGui::GetContentRegionAvail());
    if (chosen && f.ui.series_x != "time") {
      go_to_point(f, touch);
      return;
    }
    const auto pick = read_time(f, plot_, touch, names_);
    if (!touch.held) asked_ = -1;
    if (!pick || !touch.held) return;
    if (pick->x != asked_) f.out.send(command::Seek{pick->x});
    asked_ = pick->x;
  }

 private:
  static void send(GuiFrame& f, const std::string& what, const std::string& x, const std::string& y) {
    f.out.send(command::SeriesView{what, x, y});
  }

  static float longest(const GuiFrame& f) {
    const auto width = [](const std::string& key) {
      return combo_width(quantity_choices()[place_in(quantity_choices(), key)].label);
    };
    return std::max(width(f.ui.series_x), width(f.ui.series_y));
  }
  // For the two lists, between what is plotted and the button at the end of the line.
  static float room_beside(const GuiFrame& f) {
    return ImGui::GetContentRegionAvail().x - export_width(f) - f.px(10);
  }
  static bool fit_beside(const GuiFrame& f) { return 2 * longest(f) + f.px(4) <= room_beside(f); }

  // Any number of a step against any other; below each other where `width` is too little for one of them.
  static void choose(GuiFrame& f, float width) {
    const bool below = width < longest(f);
    if (below) width = ImGui::GetContentRegionAvail().x;
    if (const char* y = choice_combo("##y", quantity_choices(), f.ui.series_y, width, "What stands upwards"))
      send(f, f.ui.series, f.ui.series_x, y);
    if (!below) ImGui::SameLine(0, f.px(4));
    if (const char* x =
            choice_combo("##x", quantity_choices(), f.ui.series_x, width, "What stands to the right"))
      send(f, f.ui.series, x, f.ui.series_y);
  }

  // A click on a point of a path goes to its step.
  void go_to_point(GuiFrame& f, const PlotTouch& touch) const {
    const auto pick = read_point(f, plot_, touch, plot_.x.label.c_str());
    const Reports& history = f.sim.a.history;
    const bool own = pick && plot_.series[pick->series].style == SeriesStyle::line;
    if (own && touch.pressed && pick->index < history.size())
      f.out.send(command::Seek{history[pick->index].time});
  }

  static void hint(const GuiFrame& f) {
    const Reports& history = f.sim.a.history;
    if (history.size() < 2) {
      muted_label(f, "No step yet: press play (space).");
    } else if (f.sim.b) {
      muted_label(f, "A solid, B dashed");
    } else if (f.sim.a.left && !f.sim.a.left->empty()) {
      muted_label(f, "dashed: the run before");
    } else {
      muted_label(f, "click or drag: go to that step");
    }
  }

  void update(const GuiFrame& f) {
    const std::string what = f.ui.series + ' ' + f.ui.series_x + ' ' + f.ui.series_y;
    const PlotZoom& zoom = f.ui.zoom_of(series_tab.name);
    if (serial_ == f.sim.serial && what_ == what && zoom_ == zoom) return;
    serial_ = f.sim.serial;
    zoom_ = zoom;
    what_ = what;
    plot_ = series_panel_of(f.sim, f.ui);
    plot_.title.clear();  // the list says it
    shorten_legend();
    // Of a path every point is one that can be gone to.
    if (f.ui.series != kChosenSeries || f.ui.series_x == "time") thin_lines(plot_, kMostCurvePoints);
  }

  // Several curves of two runs: the line above says which of them is dashed.
  void shorten_legend() {
    names_.clear();
    for (const Series& s : plot_.series) names_.push_back(s.name);
    for (Series& s : plot_.series) {
      const std::size_t comma = s.name.rfind(", ");
      if (comma == s.name.npos) continue;
      s.name = s.style == SeriesStyle::dashed ? std::string() : s.name.substr(0, comma);
    }
  }

  std::uint64_t serial_ = 0;
  std::string what_;
  PlotZoom zoom_;
  Plot plot_;
  std::vector<std::string> names_;  // of its series, whole
  std::string path_;                // of the last export
  double asked_ = -1;               // time that a drag asked for last; s
};

}  // namespace

const WindowPanel series_tab = {.name = "series",
                                .title = "Over time",
                                .help =
                                    "Penetration, energies and errors over time, or any of them against "
                                    "another; a click goes to that step",
                                .slot = Slot::right_bottom,
                                .make = make_panel<SeriesPanel>};

}  // namespace pabd
