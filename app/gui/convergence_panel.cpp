// SPDX-License-Identifier: MIT
// How the solver converged in the step that led to the present state, beside curves that are held.
#include <fmt/format.h>

#include <algorithm>

#include "app/gui/panel_plots.h"
#include "app/gui/panels.h"
#include "app/gui/plot_reading.h"
#include "app/plots/axis_ticks.h"
#include "sim/base/counted.h"

namespace pabd {
namespace {

constexpr double kLeastOfSeveral = 90;  // of a plot among several, px of an ordinary screen
constexpr const char* kMethods[] = {"sissm", "descent", "newton"};

class ConvergencePanel final : public GuiPanel {
 public:
  void draw(GuiFrame& f) override {
    controls(f);
    export_button(f, convergence_tab.name, path_);
    status(f);
    update(f);
    draw_plots(f);
  }

 private:
  void controls(GuiFrame& f) const {
    if (const char* what = choice_combo("##what", kConvergenceViews, f.ui.convergence, f.px(112),
                                        "What of every iteration is plotted"))
      f.out.send(command::ConvergenceView{what});
    ImGui::SameLine();
    const bool any = f.sim.a.report.step > 0 && !f.sim.a.report.records.empty();
    ImGui::BeginDisabled(!any);
    if (ImGui::Button("Hold")) hold(f, "");
    tooltip("Keeps this curve, to compare it with those of other parameters and solvers");
    ImGui::SameLine();
    if (ImGui::Button("Hold as…")) ImGui::OpenPopup("as");
    tooltip("Solves this very step with another method, and keeps its curve");
    ImGui::EndDisabled();
    if (ImGui::BeginPopup("as")) {
      muted_label(f, "this step solved by");
      for (const char* method : kMethods) {
        if (ImGui::Selectable(method)) hold(f, method);
      }
      ImGui::EndPopup();
    }
    if (f.sim.held.empty()) return;
    ImGui::SameLine();
    if (ImGui::Button(fmt::format("Drop {}", f.sim.held.size()).c_str())) f.out.send(command::DropHeld{});
    tooltip("Forgets the curves that are kept");
  }

  // Curves are compared quantity by quantity.
  static void hold(GuiFrame& f, const char* method) {
    f.out.send(command::Hold{method});
    if (f.ui.convergence == kConvergenceViews[0].name) f.out.send(command::ConvergenceView{"residual"});
  }

  static void status(const GuiFrame& f) {
    const StepReport& r = f.sim.a.report;
    if (r.step == 0 || r.records.empty()) {
      wrapped_muted_label(f, why_no_curve(r, !f.sim.a.device.name.empty()));
      return;
    }
    const bool limit = r.status == StepStatus::iteration_limit && f.sim.a.made_with.solver.tolerance > 0;
    const std::string how = r.status == StepStatus::non_finite ? "left the numbers"
                            : limit ? fmt::format("stopped at the limit of {}", r.iterations)
                            : r.status == StepStatus::converged
                                ? fmt::format("converged in {}", r.iterations)
                                : counted(r.iterations, "iteration") + ", as asked";
    muted_label(f, fmt::format("step {}, {}:", r.step, to_string(r.method)));
    ImGui::SameLine(0, f.px(4));
    const bool warn = limit || r.status == StepStatus::non_finite;
    ImGui::PushStyleColor(ImGuiCol_Text, im_color(warn ? f.theme().color(1) : f.theme().text));
    label(how);
    ImGui::PopStyleColor();
    tooltip(limit ? "The step ended before it was settled: more iterations, another solver, or a larger "
                    "tolerance"
                  : "Every body moved by less than the tolerance in the last iteration");
    // As far as there is room.
    const auto add = [&](const std::string& text) {
      const float end = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x;
      if (end + ImGui::CalcTextSize(text.c_str()).x > ImGui::GetContentRegionMax().x) return false;
      ImGui::SameLine(0, 0);
      muted_label(f, text);
      return true;
    };
    if (r.halved_bodies > 0 && add(fmt::format(", in up to {} parts", 1 << r.halvings)))
      tooltip("The step was made again in halves; the plot shows how it went as a whole");
    add(", residual " + format_value(r.residual, 2));
  }

  // Above each other, as many as there is room for.
  void draw_plots(GuiFrame& f) const {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float gap = ImGui::GetStyle().ItemSpacing.y;
    const auto most =
        static_cast<std::size_t>(std::max(1.0f, (room.y + gap) / (f.px(kLeastOfSeveral) + gap)));
    const std::size_t count = std::min(plots_.size(), most);
    const auto parts = static_cast<float>(count);
    const ImVec2 size(room.x, (room.y - (parts - 1) * gap) / parts);
    for (std::size_t i = 0; i < count; ++i) {
      const PlotTouch touch =
          i == 0 ? panel_plot(f, convergence_tab.name, plots_[i], size)
                 : plot_widget(f, fmt::format("{}{}", convergence_tab.name, i).c_str(), plots_[i], size);
      read_point(f, plots_[i], touch, "iteration");
    }
  }

  void update(const GuiFrame& f) {
    const PlotZoom& zoom = f.ui.zoom_of(convergence_tab.name);
    if (serial_ == f.sim.serial && what_ == f.ui.convergence && zoom_ == zoom) return;
    serial_ = f.sim.serial;
    zoom_ = zoom;
    what_ = f.ui.convergence;
    plots_ = convergence_panels_of(f.sim, f.ui);
    for (Plot& plot : plots_) thin_lines(plot, 2000);
  }

  std::uint64_t serial_ = 0;
  std::string what_;
  PlotZoom zoom_;
  std::vector<Plot> plots_;
  std::string path_;  // of the last export
};

}  // namespace

const WindowPanel convergence_tab = {
    .name = "convergence",
    .title = "Convergence",
    .help = "Energy, residual, penetration and joint error of every iteration of the step",
    .slot = Slot::right_bottom,
    .make = make_panel<ConvergencePanel>,
    .iterations = true};

}  // namespace pabd
