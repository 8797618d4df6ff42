// SPDX-License-Identifier: MIT
// The barrier of the contacts: curves, a marker for each contact, their distribution over d/d̂, numbers, advice.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/gui/barrier_plot.h"
#include "app/gui/number_input.h"
#include "app/gui/panel_plots.h"
#include "app/gui/panels.h"
#include "app/gui/plot_reading.h"
#include "app/gui/widgets.h"
#include "app/overlay/font_atlas.h"
#include "app/overlay/imgui_canvas.h"
#include "app/overlay/overlay_panels.h"
#include "app/plots/axis_ticks.h"
#include "app/session/contact_advice.h"
#include "sim/scene/tuning.h"
#include "sim/scene/typed_number.h"

namespace pabd {
namespace {

constexpr double kGripReach = 8;                 // of a grip, px of an ordinary screen
constexpr int kLinger = 40;                      // frames for which room for warnings stays
constexpr double kTall = 430;                    // from here on there is room for everything
constexpr double kLeastPlot = 96;                // height, the same
constexpr double kFullControls = 352;            // width
constexpr double kStrip = 30, kHistogram = 150;  // heights, the same

bool in_force(const Params& params, const Advice& advice) {
  const std::string now = tuned_value(params, advice.key);
  const auto a = number_of_text(now), b = number_of_text(advice.value);
  return a && b ? std::abs(*a - *b) <= 1e-9 * std::abs(*b) : now == advice.value;
}

class BarrierPanelView final : public GuiPanel {
 public:
  void draw(GuiFrame& f) override {
    const bool tall = ImGui::GetContentRegionAvail().y > f.px(kTall);
    update(f, tall);
    warned_ = advice_.empty() ? std::max(0, warned_ - 1) : kLinger;
    controls(f);
    const float room = ImGui::GetContentRegionAvail().y, gap = ImGui::GetStyle().ItemSpacing.y;
    // The strip belongs to an axis of d; against other quantities there is only the histogram.
    const bool by_gap = f.ui.barrier.against == kBarrierAbscissas[0].name;
    const bool histogram = f.ui.barrier.histogram && (tall || by_gap);
    const float numbers = 2 * ImGui::GetTextLineHeightWithSpacing();
    const float least = box_height(f, tall);
    float rest = numbers + least + gap;
    if (histogram) rest += f.px(tall ? kHistogram : kStrip) + gap;
    // Where all has too little room the plot has all of it, and the rest is scrolled to.
    const float plot = room - rest - gap;
    draw_plot(f, plot >= f.px(kLeastPlot) ? plot : std::max(f.px(kLeastPlot), room - gap));
    if (histogram && tall) {
      plot_widget(f, "histogram", histogram_.plot, {ImGui::GetContentRegionAvail().x, f.px(kHistogram)});
    } else if (histogram) {
      draw_contact_strip(f, strip_, layout_, f.px(kStrip));
    }
    draw_numbers(f);
    draw_advice(f, tall);
  }

 private:
  // Once per snapshot.
  void update(const GuiFrame& f, bool tall) {
    const RunView& run = f.sim.a;
    const bool same = serial_ == f.sim.serial && view_ == f.ui.barrier && held_ == drag_.active() &&
                      tall_ == tall && zoom_ == f.ui.zoom_of(barrier_tab.name);
    if (same) return;
    tall_ = tall;
    zoom_ = f.ui.zoom_of(barrier_tab.name);
    view_ = f.ui.barrier;
    held_ = drag_.active();
    std::optional<PlotRange> x = zoom_.x, y = zoom_.y;
    if (held_) {
      x = drag_.x();
      y = drag_.y();
    }
    panel_ = barrier_panel_of(f.sim, view_, x, y);
    panel_.plot.title.clear();  // the tab says it
    if (!tall && view_.histogram &&
        view_.against == kBarrierAbscissas[0].name) {  // the strip below says both
      panel_.plot.x.label.clear();
      for (Series& series : panel_.plot.series) {
        if (series.crowd) series.name.clear();
      }
    }
    if (view_.against == kBarrierAbscissas[0].name)
      strip_ = contact_strip(panel_.plot.x.lo, run.params.contact.d_hat, run.report.contact_reports);
    if (serial_ == f.sim.serial) return;
    serial_ = f.sim.serial;
    histogram_ = contact_histogram(run.params.contact, run.report.contact_reports, contact_ink);
    if (model_ != run.model) {
      model_ = run.model;
      masses_ = mass_range(*model_);
    }
    // Numbers use the present parameters, advice those of the step that was made.
    StepReport report = run.report;
    report.kappa = run.kappa;
    numbers_ = contact_numbers(*model_, masses_, run.params, *run.state, report);
    const std::span<const StepSummary> history = run.history;
    if (!held_)
      advice_ = contact_advice(*model_, run.made_with, *run.state, run.report,
                               history.first(run.cursor + 1).last(run.alike));
  }

  void controls(GuiFrame& f) {
    command::BarrierView view = f.ui.barrier;
    bool changed = false;
    const bool full = ImGui::GetWindowContentRegionMax().x >= f.px(kFullControls);
    static constexpr const char* kPlain[] = {"B", "B′", "B″"};
    for (const Choice& c : kBarrierQuantities) {
      const std::size_t i = place_in(kBarrierQuantities, c.name);
      if (i > 0) ImGui::SameLine(0, f.px(2));
      if (toggle_button(f, view.energy ? c.label : kPlain[i], view.quantity == c.name, c.help)) {
        view.quantity = c.name;
        changed = true;
      }
    }
    ImGui::SameLine(0, f.px(full ? 12 : 2));
    const auto toggle = [&](const char* text, bool& on, const char* help) {
      if (toggle_button(f, text, on, help)) {
        on = !on;
        changed = true;
      }
      ImGui::SameLine(0, f.px(2));
    };
    toggle("log", view.log, "Logarithmic height");
    bool plain = !view.energy;
    toggle("/ κ", plain, "B_N = Ψ/κ, the bare polynomial, in place of energies and forces");
    view.energy = !plain;
    toggle("d/d̂", view.histogram, "How the contacts are spread over d/d̂, below the plot");
    if (ImGui::Button(full ? "Curves…" : "+")) ImGui::OpenPopup("curves");
    tooltip("Other barriers beside the one in use");
    if (ImGui::BeginPopup("curves")) {
      muted_label(f, "beside the one in use");
      const auto check = [&](const char* text, bool& on) {
        changed = ImGui::Checkbox(ui_text(text).c_str(), &on) || changed;
      };
      check("printed formula, ε = 0", view.printed);
      check("with onset ε", view.onset);
      check("even orders only", view.even);
      check("log barrier", view.log_barrier);
      ImGui::EndPopup();
    }
    ImGui::SameLine(0, f.px(2));
    if (const char* against =
            choice_combo("##against", kBarrierAbscissas, view.against, f.px(40),
                         "Against the distance d; or what a change of d̂, N or κ does at the gaps "
                         "that occur")) {
      view.against = against;
      changed = true;
    }
    if (changed) f.out.send(ViewCommand(view));
    export_button(f, barrier_tab.name, path_);
  }

  void draw_plot(GuiFrame& f, float height) {
    const ImVec2 mouse = ImGui::GetMousePos();
    const auto grip = [&](const PlotLayout& layout) {
      const Point at{static_cast<double>(mouse.x), static_cast<double>(mouse.y)};
      return barrier_grip(panel_, layout, at, f.px(kGripReach));
    };
    const bool grips = drag_.active() || grip(layout_) != BarrierGrip::none;
    const PlotTouch touch =
        panel_plot(f, barrier_tab.name, panel_.plot, {ImGui::GetContentRegionAvail().x, height}, grips);
    layout_ = touch.layout;
    const BarrierGrip under = touch.hovered ? grip(layout_) : BarrierGrip::none;
    if (touch.pressed && under != BarrierGrip::none)
      drag_.begin(under, panel_, f.sim.a.kappa, touch.layout, touch.mouse);
    if (drag_.active() && touch.held) {
      if (auto set = drag_.move(touch.layout, touch.mouse)) f.out.send(Command(std::move(*set)));
    }
    if (drag_.active() && !touch.held) drag_.end();
    mark_grip(f, drag_.active() ? drag_.grip() : under);
  }

  void mark_grip(GuiFrame& f, BarrierGrip grip) const {
    if (grip == BarrierGrip::none) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 ink = ImGui::GetColorU32(ImGuiCol_SliderGrabActive);
    const ContactParams& contact = f.sim.a.params.contact;
    std::string text;
    if (grip == BarrierGrip::d_hat) {
      const auto x = static_cast<float>(layout_.map(panel_.d_hat, panel_.plot.y.hi).x);
      list.AddRectFilled({x - f.px(1.5), static_cast<float>(layout_.inner.y)},
                         {x + f.px(1.5), static_cast<float>(layout_.inner.bottom())}, ink);
      ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
      text = fmt::format("d̂ = {} m", format_value(contact.d_hat));
    } else {
      const Point at = layout_.map(panel_.kappa->d, panel_.kappa->y);
      list.AddCircle({static_cast<float>(at.x), static_cast<float>(at.y)}, f.px(9), ink, 24, f.px(2));
      ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
      text = fmt::format("κ = {} {}", format_value(f.sim.a.kappa), kappa_unit(contact.barrier));
    }
    ImGui::BeginTooltip();
    label(text + (drag_.active() ? "" : ", drag to change"));
    ImGui::EndTooltip();
  }

  void draw_numbers(GuiFrame& f) const {
    const ContactParams& contact = f.sim.a.params.contact;
    const auto value = [](double v, const char* unit) {
      return std::isfinite(v) ? format_value(v, 3) + unit : std::string("none");
    };
    std::string gap = "–", where = "There is no gravity, or nothing that moves.";
    bool deep = false;
    if (numbers_.rest) {
      const RestGap& rest = *numbers_.rest;
      gap = value(rest.gap / contact.d_hat, " d̂");
      deep = !(rest.gap > 0);
      where = fmt::format(
          "Gap at which the barrier carries the heaviest resting body, {}: {} on each of {} "
          "contacts{}",
          model_->name[static_cast<std::size_t>(rest.body)], value(rest.load, " N"), rest.contacts,
          rest.assumed ? " (assumed: nothing rests yet)" : "");
    }
    const float half = std::floor(0.5f * (ImGui::GetContentRegionAvail().x - f.px(14)));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float line = ImGui::GetTextLineHeightWithSpacing();
    cell(f, at, half, "rest gap", gap, where, deep);
    cell(f, {at.x + half + f.px(14), at.y}, half, "largest force",
         f.sim.a.report.contact_reports.empty() ? "–" : value(numbers_.largest_force, " N"),
         "Largest normal force of a contact in this step", false);
    const std::string stiffness =
        "κ h²/(m d̂²), contact stiffness against inertia over one step: well above 1 a contact is stiffer "
        "than what a step can resolve, well below it is soft";
    cell(f, {at.x, at.y + line}, half, "κh²/md̂²", value(numbers_.stiffness_median, ""),
         stiffness + ". For the median mass.", false);
    cell(f, {at.x + half + f.px(14), at.y + line}, half, "of heaviest",
         value(numbers_.stiffness_heaviest, ""), stiffness + ". For the heaviest body.", false);
    ImGui::SetCursorScreenPos({at.x, at.y + 2 * line});
  }

  static void cell(const GuiFrame& f, ImVec2 at, float width, const std::string& name,
                   const std::string& value, const std::string& help, bool warn) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::string text = ui_text(value);
    list.AddText(at, packed(f.theme().muted), ui_text(name).c_str());
    list.AddText({at.x + width - ImGui::CalcTextSize(text.c_str()).x, at.y},
                 packed(warn ? f.theme().color(1) : f.theme().text), text.c_str());
    ImGui::SetCursorScreenPos(at);
    ImGui::Dummy({width, ImGui::GetTextLineHeight()});
    tooltip(help);
  }

  float box_height(const GuiFrame& f, bool tall) const {
    const int lines = tall ? 5 : warned_ > 0 ? 3 : 1;
    return static_cast<float>(lines) * ImGui::GetTextLineHeight() + f.px(lines > 1 ? 10 : 2);
  }

  void draw_advice(GuiFrame& f, bool tall) {
    ImGui::BeginChild("##advice", {0, 0});
    const auto& reports = f.sim.a.report.contact_reports;
    if (advice_.empty()) {
      muted_label(f, f.sim.a.report.step == 0 ? "No contacts yet: press play (space)."
                     : !reports.empty()       ? "No warnings: nothing overlaps."
                     : f.sim.a.poses && f.sim.a.report.contacts > 0
                         ? "The contacts of so many bodies stay on the GPU."
                     : f.sim.a.report.contacts > 0 ? "The contacts of this step were not kept."
                                                   : "No contacts in this step.");
    }
    for (std::size_t i = 0; i < advice_.size(); ++i) {
      ImGui::PushID(static_cast<int>(i));
      advice_box(f, advice_[i], tall);
      ImGui::PopID();
    }
    ImGui::EndChild();
  }

  void advice_box(GuiFrame& f, const Advice& advice, bool tall) const {
    const float pad = f.px(6), width = ImGui::GetContentRegionAvail().x;
    const bool done = in_force(f.sim.a.params, advice);
    const std::string button = done ? "at the next step"
                                    : ui_text(fmt::format("{} = {}", symbol_of(*find_parameter(advice.key)),
                                                          short_number(advice.value, 3)));
    const float bw = ImGui::CalcTextSize(button.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
    const float wrap = width - bw - 3.5f * pad;
    const std::string what = ui_text(advice.what), why = ui_text(advice.why);
    const ImVec2 size = ImGui::CalcTextSize(what.c_str(), nullptr, false, wrap);
    const float more = tall ? ImGui::CalcTextSize(why.c_str(), nullptr, false, wrap).y + f.px(2) : 0;
    const float height = std::max(size.y + more + 1.4f * pad, ImGui::GetFrameHeight() + pad);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end = {at.x + width, at.y + height};
    list.AddRectFilled(at, end, ImGui::GetColorU32(ImGuiCol_FrameBg), f.px(4));
    list.AddRectFilled(at, {at.x + f.px(3), end.y}, packed(f.theme().color(1)), f.px(2));
    ImGui::Dummy({width - bw - pad, height});
    tooltip(advice.why);
    ImFont* font = ImGui::GetFont();
    list.AddText(font, ImGui::GetFontSize(), {at.x + 1.5f * pad, at.y + 0.7f * pad}, packed(f.theme().text),
                 what.c_str(), nullptr, wrap);
    if (tall)
      list.AddText(font, ImGui::GetFontSize(), {at.x + 1.5f * pad, at.y + 0.7f * pad + size.y + f.px(2)},
                   packed(f.theme().muted), why.c_str(), nullptr, wrap);
    ImGui::SetCursorScreenPos({end.x - bw - 0.7f * pad, at.y + 0.5f * (height - ImGui::GetFrameHeight())});
    ImGui::BeginDisabled(done);
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    if (ImGui::Button(button.c_str())) f.out.send(command::Set{advice.key, advice.value});
    ImGui::PopStyleColor();
    ImGui::EndDisabled();
    tooltip(done ? "" : "Set it: " + advice.key + " = " + advice.value + ". " + advice.why);
    ImGui::SetCursorScreenPos({at.x, end.y + f.px(4)});
  }

  std::uint64_t serial_ = 0;
  command::BarrierView view_;
  bool held_ = false, tall_ = false;
  PlotZoom zoom_;
  BarrierPanel panel_;
  ContactHistogram histogram_;
  ContactStrip strip_;
  std::shared_ptr<const Model> model_;
  MassRange masses_;
  ContactNumbers numbers_;
  std::vector<Advice> advice_;
  int warned_ = 0;  // frames for which the room for advice stays
  PlotLayout layout_;
  BarrierDrag drag_;
  std::string path_;  // of the last export
};

}  // namespace

const WindowPanel barrier_tab = {
    .name = "barrier",
    .title = "Barrier",
    .help = "Ψ, Ψ′ and Ψ″ against the distance d, with a marker for every contact; drag d̂ and κ",
    .slot = Slot::right_top,
    .make = make_panel<BarrierPanelView>,
    .contacts = true};

}  // namespace pabd
