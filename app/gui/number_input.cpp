// SPDX-License-Identifier: MIT
// See number_input.h.
#include "app/gui/number_input.h"

#include <fmt/format.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/gui/widgets.h"
#include "app/plots/axis_ticks.h"
#include "sim/scene/typed_number.h"

namespace pabd {
namespace {

constexpr double kDecades = 1e-6;  // of a logarithmic bar that begins at 0
constexpr float kLeastMove = 3;    // pixels of an ordinary screen: less is a click

double least(const SliderScale& s) { return s.lo > 0 ? s.lo : kDecades * s.hi; }

}  // namespace

double significant(double x, int digits) {
  if (x == 0 || !std::isfinite(x)) return x;
  const int last =
      static_cast<int>(std::floor(std::log10(std::abs(x)))) - digits + 1;  // power of the last digit
  // Powers of ten up to 1e22 are exact, so that one rounding remains.
  const double power = std::pow(10.0, std::abs(last));
  return last < 0 ? std::round(x * power) / power : std::round(x / power) * power;
}

std::string short_number(const std::string& text, int digits) {
  const auto value = number_of_text(text);
  return value ? format_value(*value, digits) : text;
}

double SliderScale::place(double v) const {
  if (!(hi > lo)) return 0;
  if (!logarithmic) return std::clamp((v - lo) / (hi - lo), 0.0, 1.0);
  if (!(v > least(*this))) return 0;
  return std::clamp(std::log(v / least(*this)) / std::log(hi / least(*this)), 0.0, 1.0);
}

double SliderScale::value(double at) const {
  at = std::clamp(at, 0.0, 1.0);
  if (at == 1) return hi;
  if (!logarithmic) return lo + at * (hi - lo);
  return at == 0 ? lo : least(*this) * std::pow(hi / least(*this), at);
}

double SliderDrag::move(double by, bool fine) {
  place_ += fine ? kFine * by : by;
  return std::clamp(place_, 0.0, 1.0);
}

SliderTouch value_slider(const GuiFrame& f, const char* id, double place, const std::string& text,
                         float width) {
  SliderTouch touch;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size = {std::max(f.px(20), width), ImGui::GetFrameHeight()};
  ImGui::InvisibleButton(id, size);
  const bool held = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  const ImGuiIO& io = ImGui::GetIO();
  const float most = io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left];
  const bool moves = most > f.px(kLeastMove) * f.px(kLeastMove);
  touch.began = ImGui::IsItemActivated();
  touch.fine = io.KeyShift;
  if (held && moves) touch.moved = static_cast<double>(io.MouseDelta.x / size.x);
  touch.clicked = ImGui::IsItemDeactivated() && hovered && !moves;
  if (hovered || held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);

  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end = {at.x + size.x, at.y + size.y};
  const float round = ImGui::GetStyle().FrameRounding;
  list.AddRectFilled(at, end,
                     ImGui::GetColorU32(hovered || held ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg), round);
  const float x = at.x + static_cast<float>(place) * size.x;
  list.PushClipRect(at, {x, end.y}, true);
  list.AddRectFilled(at, end, ImGui::GetColorU32(ImGuiCol_SliderGrab, 0.35f), round);
  list.PopClipRect();
  const float half = f.px(1.25);
  const float mark = std::clamp(x, at.x + half, end.x - half);
  list.AddRectFilled({mark - half, at.y}, {mark + half, end.y},
                     ImGui::GetColorU32(held ? ImGuiCol_SliderGrabActive : ImGuiCol_SliderGrab));
  const std::string shown = ui_text(text);
  const ImVec2 words = ImGui::CalcTextSize(shown.c_str());
  const ImVec2 pad = ImGui::GetStyle().FramePadding;
  list.PushClipRect(at, end, true);
  list.AddText({std::round(end.x - pad.x - words.x), std::round(at.y + pad.y)}, packed(f.theme().text),
               shown.c_str());
  list.PopClipRect();
  return touch;
}

void TypedField::begin(const std::string& key, const std::string& text) {
  key_ = key;
  text_ = text;
  focus_ = true;
}

std::optional<std::string> TypedField::draw(const std::string& key, const std::string& shown, float width) {
  const bool mine = holds(key);
  std::string text = mine ? text_ : shown;
  ImGui::SetNextItemWidth(width);
  if (mine && std::exchange(focus_, false)) ImGui::SetKeyboardFocusHere();
  ImGui::InputText("##field", &text, ImGuiInputTextFlags_AutoSelectAll);
  if (ImGui::IsItemActive()) {
    key_ = key;
    text_ = text;
  }
  if (!mine || !ImGui::IsItemDeactivated()) return std::nullopt;
  key_.clear();
  // Escape gave the text back.
  return text != shown ? std::optional(text) : std::nullopt;
}

bool TypedField::number(GuiFrame& f, const std::string& key, const NumberKind& kind, double& value,
                        float width) {
  const std::string number = kind.decimals < 0 ? fmt::format("{:.{}g}", value, kind.whole ? 15 : kind.digits)
                                               : fmt::format("{:.{}f}", value, kind.decimals);
  ImGui::PushID(key.c_str());
  auto text = draw(key, kind.name + number + (kind.unit.empty() ? "" : " ") + kind.unit, width);
  ImGui::PopID();
  if (!text) return false;
  if (text->starts_with(kind.name)) text->erase(0, kind.name.size());
  std::string problem = number_problem(*text, kind.whole, kind.unit);
  const auto read = number_of_text(typed_number(*text, kind.unit));
  if (problem.empty() && !std::isfinite(*read)) problem = "expected a finite number";
  if (problem.empty()) {
    value = *read;
  } else {
    f.out.send(command::Tell{kind.name + problem, true});
  }
  return problem.empty();
}

}  // namespace pabd
