// SPDX-License-Identifier: MIT
// A sweep: its runs over two parameters, as pictures of their ends and as colours of a metric.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/gui/actions.h"
#include "app/gui/panels.h"
#include "app/gui/plot_reading.h"
#include "app/gui/sweep_cells.h"
#include "app/gui/widgets.h"
#include "app/overlay/imgui_canvas.h"
#include "app/sweep/collect_plots.h"
#include "app/sweep/collect_sheet.h"
#include "sim/base/counted.h"

namespace pabd {
namespace {

constexpr int kBarSteps = 64;

class SweepPanel : public GuiPanel {
 public:
  void draw(GuiFrame& f) override {
    if (!update(f)) return;
    head(f);
    choices(f);
    const float below = 3.4f * ImGui::GetTextLineHeightWithSpacing();
    const ImVec2 room{ImGui::GetContentRegionAvail().x,
                      std::max(f.px(60), ImGui::GetContentRegionAvail().y - below)};
    const float top = ImGui::GetCursorPosY();
    ImGui::BeginChild("##cells", room, false, ImGuiWindowFlags_HorizontalScrollbar);
    cells(f);
    ImGui::EndChild();
    // The scale is close to what it is of.
    if (cells_.width <= static_cast<double>(room.x) && cells_.height < static_cast<double>(room.y))
      ImGui::SetCursorPosY(top + static_cast<float>(cells_.height) + f.px(8));
    foot(f);
  }

 private:
  // False: there are no cells, and why was said.
  bool update(GuiFrame& f) {
    const OpenedSweep& sweep = f.ui.sweep;
    if (sweep.folder.empty()) {
      wrapped_muted_label(
          f,
          "A sweep is a scene with many sets of parameters: pabd sweep PLAN -o DIR makes one. Open its "
          "folder "
          "to see all runs over two parameters, or drop it on the window.");
      if (ImGui::Button("Open a sweep…")) carry_out(f, "open_sweep");
      return false;
    }
    if (!sweep.read) {
      read_.reset();
      title(f, sweep.folder);
      wrapped_muted_label(f, sweep.reading ? "reading…" : sweep.problem);
      return false;
    }
    if (read_ != sweep.read || view_ != sweep.view) {
      read_ = sweep.read;
      view_ = sweep.view;
      shown_ = shown_of(*read_, view_);
      width_ = 0;
    }
    return true;
  }

  // The name of the folder, and what is done with all of it.
  static void title(GuiFrame& f, const std::string& name) {
    const float right = ImGui::GetContentRegionMax().x, side = ImGui::GetFrameHeight() * 1.15f;
    const float button = ImGui::CalcTextSize("Open…").x + 2 * ImGui::GetStyle().FramePadding.x;
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    ImGui::AlignTextToFramePadding();
    const float room = right - side - button - 2 * gap - ImGui::GetCursorPosX();
    label(shortened(name, room));
    tooltip(f.ui.sweep.folder);
    ImGui::SameLine(right - side - button - gap);
    action_button(f, "open_sweep");
    ImGui::SameLine();
    if (icon_button(f, "reset", "Read the folder again: a sweep that goes on has more tasks then"))
      f.out.send(command::OpenSweep{f.ui.sweep.folder});
  }

  void head(GuiFrame& f) const {
    title(f, read_->title);
    wrapped_muted_label(f, counts_words(*read_) + (f.ui.sweep.reading ? "; reading…" : ""));
    if (read_->notes.empty()) return;
    muted_label(f, counted(read_->notes.size(), "note") + " on what is missing or damaged");
    std::string all;
    for (std::size_t i = 0; i < std::min<std::size_t>(read_->notes.size(), 12); ++i)
      all += (i == 0 ? "" : "\n") + read_->notes[i];
    tooltip(all);
  }

  // A list of words; sends the view that `change` makes of the one that is chosen.
  template <class Change>
  void choose(GuiFrame& f, const char* id, const std::vector<std::string>& words, std::size_t now,
              float width, const char* help, Change&& change) const {
    std::vector<const char*> list;
    for (const std::string& word : words) list.push_back(word.c_str());
    const auto chosen = word_combo(id, list.data(), list.size(), now, width, help);
    if (!chosen) return;
    command::SweepView view = view_;
    change(view, *chosen);
    f.out.send(ViewCommand(view));
  }

  void choices(GuiFrame& f) const {
    const auto toggle = [&](const char* text, bool on, const char* help) {
      if (toggle_button(f, text, view_.pictures == on, help)) {
        command::SweepView view = view_;
        view.pictures = on;
        f.out.send(ViewCommand(view));
      }
      ImGui::SameLine(0, f.px(2));
    };
    toggle("Pictures", true, "How every run ended, and the metric as a bar below");
    toggle("Colours", false, "The metric as the colour of a cell, with its number where there is room");
    std::vector<std::string> metrics;
    for (const Criterion& criterion : shown_.criteria) metrics.push_back(criterion.quantity.label());
    if (!metrics.empty())
      choose(f, "##metric", metrics, shown_.criterion, ImGui::GetContentRegionAvail().x,
             "What the colours say; less is better",
             [&](command::SweepView& view, std::size_t i) { view.metric = shown_.criteria[i].quantity.key; });
    else
      ImGui::NewLine();
    axes(f);
    if (shown_.grid.slices.size() < 2) return;
    std::vector<std::string> slices;
    for (const GridSlice& slice : shown_.grid.slices) slices.push_back(slice.name);
    choose(f, "##slice", slices, shown_.slice, ImGui::GetContentRegionAvail().x,
           "Which values the other parameters have",
           [](command::SweepView& view, std::size_t i) { view.slice = static_cast<int>(i); });
  }

  // The parameters along x and y, where there is something to choose.
  void axes(GuiFrame& f) const {
    const std::vector<std::size_t> varied = varied_parameters(*read_);
    if (shown_.grid.scattered) {
      muted_label(f, "a sample: in lines, by their index");
      return;
    }
    if (varied.size() < 2) return;
    std::vector<std::string> words;
    std::size_t x = varied.size(), y = varied.size();
    for (std::size_t i = 0; i < varied.size(); ++i) {
      words.push_back(read_->parameters[varied[i]].words);
      if (shown_.grid.x.parameter == varied[i]) x = i;
      if (shown_.grid.y.parameter == varied[i]) y = i;
    }
    const auto key = [&](std::size_t i) { return i < varied.size() ? read_->parameters[varied[i]].key : ""; };
    // Both are kept; the one that is chosen for the other axis changes places with it.
    const auto put = [&](command::SweepView& view, std::size_t to_x, std::size_t to_y) {
      view.x = key(to_x);
      view.y = key(to_y);
      view.slice = 0;
    };
    const float letters = ImGui::CalcTextSize("x").x + 2 * f.px(4);
    const float width = 0.5f * ImGui::GetContentRegionAvail().x - letters - f.px(2);
    ImGui::AlignTextToFramePadding();
    muted_label(f, "x");
    ImGui::SameLine(0, f.px(4));
    choose(f, "##x", words, x, width, "What goes from left to right",
           [&](command::SweepView& view, std::size_t i) { put(view, i, i == y ? x : y); });
    ImGui::SameLine(0, f.px(8));
    muted_label(f, "y");
    ImGui::SameLine(0, f.px(4));
    choose(f, "##y", words, y, ImGui::GetContentRegionAvail().x, "What goes from bottom to top",
           [&](command::SweepView& view, std::size_t i) { put(view, i == x ? y : x, i); });
  }

  void cells(GuiFrame& f) {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const double scroll = static_cast<double>(ImGui::GetStyle().ScrollbarSize);
    if (width_ != room.x || height_ != room.y || unit_ != f.unit || dark_ != f.ui.dark) {
      width_ = room.x;
      height_ = room.y;
      unit_ = f.unit;
      dark_ = f.ui.dark;
      PlotStyle style = panel_style().scaled(f.unit);
      style.theme = f.theme();
      const auto fit = [&](double width) {
        cells_ = sweep_cells(*read_, shown_, view_.pictures, width, static_cast<double>(room.y), style,
                             f.unit, f.metrics);
      };
      fit(static_cast<double>(room.x));
      // Its bar takes some of the width.
      if (cells_.height > static_cast<double>(room.y) && ImGui::GetScrollMaxY() == 0)
        fit(static_cast<double>(room.x) - scroll);
    }
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool clicked =
        ImGui::InvisibleButton("##grid", {std::max(1.0f, static_cast<float>(cells_.width)),
                                          std::max(1.0f, static_cast<float>(cells_.height))});
    const ImVec2 mouse = ImGui::GetMousePos();
    const bool is_over = ImGui::IsItemHovered();

    ImGuiCanvas canvas(f.metrics, f.fonts, *ImGui::GetWindowDrawList());
    HeatLayout placed = cells_.layout;
    placed.panels[0].x += static_cast<double>(at.x);
    placed.panels[0].y += static_cast<double>(at.y);
    const ImVec2 lo = ImGui::GetWindowDrawList()->GetClipRectMin(),
                 hi = ImGui::GetWindowDrawList()->GetClipRectMax();
    const Rect seen{lo.x, lo.y, hi.x - lo.x, hi.y - lo.y};
    const auto rect_of = [&](std::size_t i) {
      return cell_rect(cells_.map, placed, 0, i % cells_.columns(), i / cells_.columns());
    };
    for (std::size_t i = 0; i < cells_.tasks.size(); ++i) {
      if (rect_of(i).overlaps(seen)) paint(f, placed, i, rect_of(i), canvas);
    }
    paint_heat_axes(cells_.map, placed, 0, canvas);
    for (std::size_t i = 0; f.ui.sweep.loaded && i < cells_.tasks.size(); ++i) {
      if (cells_.tasks[i] == f.ui.sweep.loaded) mark_loaded(f, rect_of(i), canvas);
    }
    const auto hovered =
        cell_at(cells_, {static_cast<double>(mouse.x - at.x), static_cast<double>(mouse.y - at.y)});
    if (!is_over || !hovered || !cells_.tasks[*hovered]) return;
    canvas.stroke_rect(rect_of(*hovered).inset(-f.unit), f.theme().text, 2 * f.unit);
    const SweptTask& task = read_->tasks[*cells_.tasks[*hovered]];
    sweep_tooltip(f, *read_, shown_, task, f.ui.sweep.loaded == cells_.tasks[*hovered], rect_of(*hovered));
    if (clicked && task.index >= 0) load(f, static_cast<int>(task.index));
  }

  void paint(GuiFrame& f, const HeatLayout& placed, std::size_t i, const Rect& cell, Canvas& canvas) const {
    const auto task = cells_.tasks[i];
    if (!task && shown_.grid.scattered) return;
    const SweepPicture picture =
        task && cells_.pictures ? f.sweeps.picture(read_->tasks[*task], false) : SweepPicture{};
    if (picture.status != SweepPicture::Status::there) {
      paint_heat_cell(cells_.map, placed, 0, i, canvas);
      return;
    }
    const double value = cells_.map.panels[0].values[i], bar = std::round(4 * f.unit);
    const Rect room{cell.x, cell.y, cell.w, cell.h - bar};
    canvas.fill_rect(cell, color_of(cells_.map, placed, std::nan("")));
    draw_inside(*ImGui::GetWindowDrawList(), picture, room);
    canvas.fill_rect({cell.x, cell.bottom() - bar, cell.w, bar}, color_of(cells_.map, placed, value));
    const HeatSign sign = cells_.map.panels[0].marks[i].sign;
    if (read_->tasks[*task].status == SweptStatus::done || sign == HeatSign::none) return;
    // A sign in a chip, and a frame: not by colour alone.
    const double side = std::min(std::round(18 * f.unit), 0.6 * room.h);
    const Rect chip{cell.right() - side, cell.y, side, side};
    canvas.stroke_rect(room.inset(0.5 * f.unit), status_color(read_->tasks[*task].status), 2 * f.unit);
    canvas.fill_rect(chip, f.theme().paper);
    paint_heat_sign(chip, sign, f.theme(), 1.6 * f.unit, canvas);
  }

  // A frame that no other cell has, with a corner.
  static void mark_loaded(const GuiFrame& f, const Rect& cell, Canvas& canvas) {
    const Color accent = f.theme().color(0);
    canvas.stroke_rect(cell.inset(-f.unit), accent, 3 * f.unit);
    const double side = std::min(12 * f.unit, 0.5 * cell.h);
    const Point corner[] = {{cell.x, cell.y}, {cell.x + side, cell.y}, {cell.x, cell.y + side}};
    canvas.fill_polygon(corner, accent);
  }

  static void load(GuiFrame& f, int task) {
    const bool end = ImGui::GetIO().KeyShift;
    if (f.sim.at_stake.empty()) {
      f.out.send(command::LoadRun{task, end ? "end" : "start", false});
    } else {
      f.out.send(command::Ask{end ? "load_end" : "load_run", std::to_string(task)});
    }
  }

  // The scale of the colours, and what the signs mean.
  void foot(GuiFrame& f) const {
    if (shown_.criterion < shown_.criteria.size()) {
      muted_label(f, shown_.criteria[shown_.criterion].quantity.label() +
                         (cells_.layout.scale.factor.empty() ? "" : " " + cells_.layout.scale.factor));
      const ImVec2 at = ImGui::GetCursorScreenPos();
      const float width = ImGui::GetContentRegionAvail().x, high = f.px(7);
      ImGui::Dummy({width, high + ImGui::GetTextLineHeight()});
      color_strip(f, {at.x, at.y, width, high});
    }
    const std::string signs = signs_words(*read_);
    if (!signs.empty()) wrapped_muted_label(f, signs);
  }

  void color_strip(GuiFrame& f, const Rect& bar) const {
    ImGuiCanvas painter(f.metrics, f.fonts, *ImGui::GetWindowDrawList());
    Canvas& canvas = painter;
    const PlotStyle& style = cells_.layout.style;
    const auto x = [&](double place) { return std::round(bar.x + bar.w * place); };
    for (int i = 0; i < kBarSteps; ++i) {
      const double from = x(static_cast<double>(i) / kBarSteps), to = x((i + 1.0) / kBarSteps);
      canvas.fill_rect({from, bar.y, to - from, bar.h}, sweep_color((i + 0.5) / kBarSteps));
    }
    double free = bar.x - 1;
    for (const Tick& tick : cells_.layout.scale.ticks) {
      const double at = x(cells_.layout.scale.unit(tick.value));
      canvas.vertical(at, bar.bottom(), bar.bottom() + style.tick_length, style.theme.axis, style.grid);
      const double w = text_width(f.metrics, tick.label, style.tick);
      const double left = std::clamp(at - 0.5 * w, bar.x, bar.right() - w);
      if (tick.label.empty() || left < free) continue;
      canvas.text({left, bar.bottom() + style.tick_length + 0.5 * style.gap}, tick.label,
                  {style.tick, style.theme.muted, AlignX::left, AlignY::top});
      free = left + w + style.tick;
    }
  }

  std::shared_ptr<const CollectedSweep> read_;
  command::SweepView view_;
  ShownSweep shown_;
  SweepCells cells_;
  float width_ = 0, height_ = 0;
  double unit_ = 0;
  bool dark_ = false;
};

}  // namespace

const WindowPanel sweep_tab = {.name = "sweep",
                               .title = "Sweep",
                               .help = "Many runs of a scene over two of its parameters",
                               .slot = Slot::left,
                               .make = make_panel<SweepPanel>,
                               .offered = [](const UiState& ui) { return !ui.sweep.folder.empty(); }};

}  // namespace pabd
