// SPDX-License-Identifier: MIT
// Quantities over time, what happened on the way, and the present moment; a click or a drag goes to a step.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/gui/panels.h"
#include "app/gui/plot_reading.h"
#include "app/plots/axis_ticks.h"
#include "app/plots/figures/time_panel.h"
#include "app/plots/figures/time_series.h"

namespace pabd {
namespace {

constexpr const char* kWords[] = {"overview",    "gap",      "penetration", "energies",
                                  "joint error", "contacts", "iterations",  "ms a step"};
static_assert(std::size(kWords) == std::size(kSeriesViews));

constexpr std::size_t kMostPoints = 1600;  // of a curve
constexpr double kNear =
    0.02;  // part of the time axis: changes of κ closer than that are one, as of a slider

std::size_t shown(const UiState& ui) {
  const auto it = std::find(std::begin(kSeriesViews), std::end(kSeriesViews), ui.series);
  return it == std::end(kSeriesViews) ? 0 : static_cast<std::size_t>(it - std::begin(kSeriesViews));
}

// Where κ changed, as the reports have it.
std::vector<TimeMark> kappa_marks(const Reports& history) {
  struct Change {
    double time, from, to;
  };
  std::vector<Change> changes;
  const double span = history.empty() ? 0 : history.back().time - history.front().time;
  for (std::size_t i = 1; i < history.size(); ++i) {
    const double from = history[i - 1].kappa, to = history[i].kappa, time = history[i - 1].time;
    if (!(from > 0) || from == to) continue;
    if (!changes.empty() && time - changes.back().time < kNear * span) {
      changes.back().to = to;
    } else {
      changes.push_back({time, from, to});
    }
  }
  std::vector<TimeMark> marks;
  for (const Change& c : changes) {
    marks.push_back({c.time, fmt::format("κ {} → {}", format_value(c.from, 3), format_value(c.to, 3)),
                     MarkKind::parameter});
  }
  return marks;
}

class SeriesPanel final : public GuiPanel {
 public:
  void draw(GuiFrame& f) override {
    const std::size_t now = shown(f.ui);
    if (const auto i =
            word_combo("##what", kWords, std::size(kWords), now, f.px(112), "What of every step is plotted"))
      f.out.send(ViewCommand(command::SeriesView{std::string(kSeriesViews[*i])}));
    ImGui::SameLine();
    hint(f);
    update(f);
    const PlotTouch touch = plot_widget(f, "series", plot_, ImGui::GetContentRegionAvail());
    const auto pick = read_time(f, plot_, touch, names_);
    if (!touch.held) asked_ = -1;
    if (!pick || !touch.held) return;
    if (pick->x != asked_) f.out.send(Command(command::Seek{pick->x}));
    asked_ = pick->x;
  }

 private:
  static void hint(const GuiFrame& f) {
    const Reports& history = f.sim.a.history;
    if (history.size() < 2) {
      muted_label(f, "No step yet: press play (space).");
    } else if (f.sim.b) {
      muted_label(f, shown(f.ui) == 0 ? "A (choose a quantity to see B)" : "A solid, B dashed");
    } else if (f.sim.a.left && !f.sim.a.left->empty()) {
      muted_label(f, shown(f.ui) == 0 ? "choose a quantity: run before" : "dashed: the run before");
    } else {
      muted_label(f, "click or drag: go to that step");
    }
  }

  void update(const GuiFrame& f) {
    const std::size_t what = shown(f.ui);
    if (serial_ == f.sim.serial && what_ == what) return;
    serial_ = f.sim.serial;
    what_ = what;
    const RunView& a = f.sim.a;
    const double d_hat = a.params.contact.d_hat;
    TimePanelOptions options;
    options.cursor = a.state.time;
    options.d_hat = d_hat;
    options.marks = marks(f.sim);
    if (f.sim.b) {
      options.other = f.sim.b->history;
      options.name = std::string("A");
      options.other_name = std::string("B");
    } else if (a.left) {
      options.other = *a.left;
      options.name = std::string("now");
      options.other_name = std::string("before");
    }
    if (what == 0) {
      plot_ = time_series_plot(a.history, d_hat, !a.model->joints.empty());
      // Cursor and marks as the other plots have them.
      options.other = {};
      options.d_hat = 0;
      for (Series& s : time_panel({}, TimeQuantity::contacts, options).series) {
        if (s.style == SeriesStyle::level_x) plot_.series.push_back(std::move(s));
      }
    } else {
      plot_ = time_panel(a.history, static_cast<TimeQuantity>(what - 1), options);
    }
    plot_.title.clear();  // the list says it
    shorten_legend();
    thin_lines(plot_, kMostPoints);
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

  static std::vector<TimeMark> marks(const Snapshot& sim) {
    std::vector<TimeMark> out = kappa_marks(sim.a.history);
    if (const auto& parting = sim.a.parting) {
      out.push_back({parting->time, "branch", MarkKind::branch});
      if (parting->parted) out.push_back({*parting->parted, "parts by d̂", MarkKind::divergence});
    }
    std::stable_sort(out.begin(), out.end(),
                     [](const TimeMark& a, const TimeMark& b) { return a.time < b.time; });
    return out;
  }

  std::uint64_t serial_ = 0;
  std::size_t what_ = 0;
  Plot plot_;
  std::vector<std::string> names_;  // of its series, whole
  double asked_ = -1;               // time that a drag asked for last; s
};

}  // namespace

const WindowPanel series_tab = {
    .name = "series",
    .title = "Over time",
    .help = "Penetration, energies and errors over time; a click goes to that step",
    .slot = Slot::right_bottom,
    .make = make_panel<SeriesPanel>};

}  // namespace pabd
