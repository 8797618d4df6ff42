// SPDX-License-Identifier: MIT
// Two parameter sets on one scene: what differs, the distance between the runs, and how they are shown.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/gui/actions.h"
#include "app/gui/number_input.h"
#include "app/gui/panel_plots.h"
#include "app/gui/panels.h"
#include "app/gui/plot_reading.h"
#include "app/overlay/imgui_canvas.h"
#include "app/plots/axis_ticks.h"
#include "app/plots/figures/difference.h"
#include "app/session/joint_settings.h"
#include "sim/math/types.h"
#include "sim/scene/tuning.h"
#include "sim/scene/typed_number.h"

namespace pabd {
namespace {

constexpr int kDifferingRows = 3;  // of the table before it scrolls

std::string key_of(const char* name) { return fmt::format("{}.{}", kJointSettings, name); }

class ComparePanel final : public GuiPanel {
 public:
  void draw(GuiFrame& f) override {
    if (!f.sim.b) {
      offer(f);
      return;
    }
    update(f);
    controls(f);
    joint_law(f);
    table(f);
    now(f);
    const PlotTouch touch = plot_widget(f, "difference", plot_, ImGui::GetContentRegionAvail());
    const auto pick = read_time(f, plot_, touch);
    if (pick && touch.pressed) f.out.send(command::Seek{pick->x});
  }

 private:
  static void offer(GuiFrame& f) {
    ImGui::Dummy({0, f.px(4)});
    wrapped_muted_label(
        f,
        "Compare two parameter sets on the same scene. B is a second simulation that runs in step with A, "
        "shown as a ghost or side by side. It starts with A's parameters: change them under Parameters, B" +
            std::string(f.sim.a.model->joints.empty() ? "." : ", and the law of its joints here."));
    ImGui::Dummy({0, f.px(4)});
    if (ImGui::Button("Compare from here")) f.out.send(command::Compare{});
    tooltip("B starts at this moment, where A is now");
    same_line_if_room(button_width("Compare from the beginning"));
    if (ImGui::Button("Compare from the beginning")) {
      f.out.send(command::Restart{});
      f.out.send(command::Compare{});
    }
    tooltip("A starts again with its present parameters, and B with it");
  }

  void controls(GuiFrame& f) {
    action_toggle(f, "ghost", !f.ui.side_by_side);
    ImGui::SameLine(0, f.px(2));
    action_toggle(f, "side", f.ui.side_by_side);
    const float end = button_width("End"), take = button_width("Take B's");
    const float both = end + take + ImGui::GetStyle().ItemSpacing.x;
    same_line_if_room(both);
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - both);
    command::SetAll all;
    for (const Difference& d : differing_) {
      if (!is_joint_setting(d.key)) all.values.push_back(d.key + "=" + d.b);
    }
    const bool joints = all.values.size() < differing_.size();
    ImGui::BeginDisabled(all.values.empty());
    if (ImGui::Button("Take B's")) f.out.send(Command(std::move(all)));
    ImGui::EndDisabled();
    tooltip(std::string("Gives A the parameters of B; one step of undo") +
            (joints ? ". The law of A's joints stays that of the scene" : ""));
    ImGui::SameLine();
    if (ImGui::Button("End")) f.out.send(command::EndCompare{});
    tooltip("Ends the comparison: B goes, A stays as it is");
  }

  // The law of B's joints, on as many lines as it needs.
  void joint_law(GuiFrame& f) {
    const RunView& b = *f.sim.b;
    if (b.model->joints.empty()) return;
    const BondLaw& law = b.scene->joint_law;
    const bool hard = law.potential == BondPotential::hard;
    ImGui::AlignTextToFramePadding();
    label("B's joints");
    tooltip(
        "The law of all joints of B that say nothing of their own (joints_default). B goes on with it from "
        "this "
        "moment");
    const float combo = combo_width("hard");
    same_line_if_room(combo);
    static constexpr Choice kPotentials[] = {{"soft"}, {"hard"}};
    if (const char* word =
            choice_combo("##potential", kPotentials, hard ? "hard" : "soft", combo,
                         "soft: ½ κ d²; hard: the even terms of the contacts' polynomial. Another "
                         "one has its κ found anew (auto)"))
      f.out.send(command::Set{key_of("potential"), word, Side::b});
    field(f, "κ", key_of("kappa"), fmt::format("{:.4g} {}", law.kappa, hard ? "J" : "N/m"), 120,
          fmt::format("Stiffness of the joints: a number in {}, or auto. {}", hard ? "J" : "N/m",
                      "Exact value: " + joint_settings(law)[1].second));
    if (hard) {
      field(f, "d̂", key_of("d_hat"), fmt::format("{:.5g} m", law.d_hat), 66,
            "Length over which the potential of the joints rises; m");
      field(f, "N", key_of("N"), fmt::format("{}", law.N), 34,
            "Highest order of the potential of the joints");
    }
    if (same_law(law, f.sim.scene->joint_law)) return;
    same_line_if_room(ImGui::GetFrameHeight());
    if (icon_button(f, "reset", "The law of the scene"))
      f.out.send(command::ResetParams{std::string(kJointSettings), Side::b});
  }

  void field(GuiFrame& f, const char* name, const std::string& key, const std::string& shown, double width,
             const std::string& help) {
    const float named = ImGui::CalcTextSize(ui_text(name).c_str()).x + ImGui::GetStyle().ItemInnerSpacing.x;
    same_line_if_room(named + f.px(width));
    ImGui::AlignTextToFramePadding();
    muted_label(f, name);
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::PushID(key.c_str());
    const auto space = shown.find(' ');
    const std::string unit = space == std::string::npos ? "" : shown.substr(space + 1);
    if (const auto text = field_.draw(key, shown, f.px(width)))
      f.out.send(command::Set{key, typed_number(*text, unit), Side::b});
    ImGui::PopID();
    tooltip(help);
  }

  void table(GuiFrame& f) const {
    if (differing_.empty()) {
      wrapped_muted_label(
          f, "A and B have the same parameters. Choose B in the Parameters panel and change one.");
      return;
    }
    const float line = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y;
    const int rows = std::min(static_cast<int>(differing_.size()), kDifferingRows);
    const auto flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp;
    if (!ImGui::BeginTable("##differing", 3, flags, {0, line * static_cast<float>(rows + 1) + f.px(2)}))
      return;
    ImGui::TableSetupColumn("parameter", 0, 2.2f);
    ImGui::TableSetupColumn("A", 0, 1);
    ImGui::TableSetupColumn("B", 0, 1);
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableNextRow();
    for (const char* text : {"parameter", "A", "B"}) {
      ImGui::TableNextColumn();
      muted_label(f, text);
    }
    for (const Difference& d : differing_) {
      ImGui::TableNextRow();
      for (const std::string* text : {&d.key, &d.a, &d.b}) {
        ImGui::TableNextColumn();
        label(short_number(*text, 4));
        tooltip(*text);
      }
    }
    ImGui::EndTable();
  }

  void now(GuiFrame& f) {
    if (const char* what = choice_combo("##what", kDifferenceViews, f.ui.difference, f.px(104),
                                        "What of B − A is plotted over time"))
      f.out.send(command::DifferenceView{what});
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    if (distance_.body < 0 || distance_.position == 0) {
      muted_label(f, "now: the same to the last bit");
      return;
    }
    label(fmt::format("now {} m", format_value(distance_.position, 3)));
    const double late = 1e3 * (f.sim.a.state->time - f.sim.b->state->time);
    tooltip("Largest distance between the places of a body in A and in B, at this moment" +
            (std::abs(late) < 1e-6 ? std::string()
                                   : fmt::format("; B's steps end at other times, now {:.3g} ms {}",
                                                 std::abs(late), late > 0 ? "earlier" : "later")));
    const std::string where =
        fmt::format("{}, {}°", f.sim.a.model->name[static_cast<std::size_t>(distance_.body)],
                    format_value(distance_.angle * 180 / kPi, 2));
    same_line_if_room(ImGui::CalcTextSize(ui_text(where).c_str()).x, f.px(5));
    muted_label(f, where);
    tooltip("The body that is farthest away, and the largest angle between a body's two attitudes");
  }

  void update(const GuiFrame& f) {
    const std::size_t what = place_in(kDifferenceViews, f.ui.difference);
    if (serial_ == f.sim.serial && what_ == what) return;
    const bool numbers = serial_ != f.sim.serial;
    serial_ = f.sim.serial;
    what_ = what;
    const RunView &a = f.sim.a, &b = *f.sim.b;
    if (numbers) {
      differing_.clear();
      for (const auto& [key, value] : differences(a.params, b.params))
        differing_.push_back({key, tuned_value(a.params, key), value});
      const auto of_a = joint_settings(a.scene->joint_law);
      for (const auto& [key, value] : joint_differences(a.scene->joint_law, b.scene->joint_law)) {
        const auto same = [&, &name = key](const auto& one) { return one.first == name; };
        const auto it = std::find_if(of_a.begin(), of_a.end(), same);
        differing_.push_back({key, it == of_a.end() ? "" : it->second, value});
      }
      distance_ = state_distance(*a.state, *b.state);
    }
    std::vector<DistancePoint> distances;
    for (const RunDistance& d : f.sim.distances) distances.push_back({d.time, d.position, 0});
    plot_ = difference_series_plot(a.history, b.history, static_cast<DifferenceQuantity>(what), distances);
    plot_.y.label = what == 0 ? "largest distance [m]" : plot_.y.label;
    plot_.title.clear();
    if (what == 0) {
      plot_.series[0].name.clear();
      if (distances.size() < 2) plot_.none = "no step to a common time yet: press play";
    }
    thin_lines(plot_, kMostCurvePoints);
    Series cursor;
    cursor.style = SeriesStyle::level_x;
    cursor.x = {a.state->time};
    cursor.weight = 2;
    plot_.series.push_back(std::move(cursor));
  }

  struct Difference {
    std::string key, a, b;
  };

  std::uint64_t serial_ = 0;
  std::size_t what_ = 0;
  std::vector<Difference> differing_;
  StateDistance distance_;
  TypedField field_;  // of the law of joints
  Plot plot_;
};

}  // namespace

const WindowPanel compare_tab = {.name = "compare",
                                 .title = "A/B",
                                 .help = "Two parameter sets on the same scene, in step",
                                 .slot = Slot::right_top,
                                 .make = make_panel<ComparePanel>,
                                 .contacts = true};

void draw_compare_labels(GuiFrame& f, const GuiLayout& layout) {
  if (!f.sim.b) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const auto tag = [&](const Rect& view, const std::string& text) {
    const std::string shown_text = ui_text(text);
    const ImVec2 size = ImGui::CalcTextSize(shown_text.c_str());
    const ImVec2 at = {static_cast<float>(view.x) + f.px(10), static_cast<float>(view.y) + f.px(10)};
    list.AddRectFilled(at, {at.x + size.x + f.px(14), at.y + size.y + f.px(8)},
                       ImGui::GetColorU32(ImGuiCol_PopupBg, 0.85f), f.px(4));
    list.AddText({at.x + f.px(7), at.y + f.px(4)}, packed(f.theme().text), shown_text.c_str());
  };
  if (!f.ui.side_by_side) {
    tag(layout.view, "A, and B as a ghost");
    return;
  }
  tag(layout.views[0], "A");
  tag(layout.views[1], "B");
  const auto x = static_cast<float>(layout.views[1].x);
  list.AddRectFilled({x - f.px(1), static_cast<float>(layout.view.y)},
                     {x + f.px(1), static_cast<float>(layout.view.bottom())},
                     ImGui::GetColorU32(ImGuiCol_Separator));
}

}  // namespace pabd
