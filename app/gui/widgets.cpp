// SPDX-License-Identifier: MIT
// See widgets.h.
#include "app/gui/widgets.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "app/overlay/imgui_canvas.h"
#include "sim/base/utf8.h"

namespace pabd {
namespace {

ImVec2 operator+(ImVec2 a, ImVec2 b) { return {a.x + b.x, a.y + b.y}; }

void triangle(ImDrawList& list, ImVec2 centre, float r, float direction, ImU32 ink) {
  list.AddTriangleFilled(centre + ImVec2(-0.8f * r * direction, -r), centre + ImVec2(r * direction, 0),
                         centre + ImVec2(-0.8f * r * direction, r), ink);
}

void bar(ImDrawList& list, ImVec2 centre, float r, float x, float width, ImU32 ink) {
  list.AddRectFilled(centre + ImVec2(x * r - 0.5f * width * r, -r),
                     centre + ImVec2(x * r + 0.5f * width * r, r), ink);
}

// A curved arrow: `direction` +1 to the right.
void hook(ImDrawList& list, ImVec2 centre, float r, float direction, ImU32 ink) {
  constexpr float kTurn = 4.4f, kStart = -0.6f;
  constexpr int kPieces = 20;
  for (int i = 0; i <= kPieces; ++i) {
    const float t = kStart - kTurn * static_cast<float>(i) / kPieces;
    list.PathLineTo(centre + ImVec2(direction * r * std::cos(t), r * std::sin(t)));
  }
  list.PathStroke(ink, 0, 0.28f * r);
  const ImVec2 tip = centre + ImVec2(direction * r * std::cos(kStart), r * std::sin(kStart));
  list.AddTriangleFilled(tip + ImVec2(-0.75f * r * direction, -0.05f * r),
                         tip + ImVec2(0.45f * r * direction, -0.35f * r),
                         tip + ImVec2(0.2f * r * direction, 0.75f * r), ink);
}

void draw_sign(ImDrawList& list, const char* sign, ImVec2 c, float r, ImU32 ink) {
  const auto is = [sign](const char* name) { return std::strcmp(sign, name) == 0; };
  if (is("play")) triangle(list, c, r, 1, ink);
  if (is("pause")) {
    bar(list, c, r, -0.5f, 0.5f, ink);
    bar(list, c, r, 0.5f, 0.5f, ink);
  }
  if (is("forward")) {
    triangle(list, c + ImVec2(-0.2f * r, 0), 0.9f * r, 1, ink);
    bar(list, c, 0.9f * r, 0.95f, 0.35f, ink);
  }
  if (is("back")) {
    triangle(list, c + ImVec2(0.2f * r, 0), 0.9f * r, -1, ink);
    bar(list, c, 0.9f * r, -0.95f, 0.35f, ink);
  }
  if (is("restart")) {
    bar(list, c, 0.9f * r, -1.0f, 0.35f, ink);
    triangle(list, c + ImVec2(-0.15f * r, 0), 0.75f * r, -1, ink);
    triangle(list, c + ImVec2(0.75f * r, 0), 0.75f * r, -1, ink);
  }
  if (is("undo") || is("reset")) hook(list, c, 0.8f * r, -1, ink);
  if (is("redo")) hook(list, c, 0.8f * r, 1, ink);
}

}  // namespace

ImU32 packed(Color c) { return IM_COL32(c.r, c.g, c.b, c.a); }
ImVec4 im_color(Color c) { return ImGui::ColorConvertU32ToFloat4(packed(c)); }

void label(const std::string& text) { ImGui::TextUnformatted(ui_text(text).c_str()); }

void muted_label(const GuiFrame& frame, const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, im_color(frame.theme().muted));
  label(text);
  ImGui::PopStyleColor();
}

void wrapped_label(const std::string& text) {
  ImGui::PushTextWrapPos(0);
  label(text);
  ImGui::PopTextWrapPos();
}

void wrapped_muted_label(const GuiFrame& frame, const std::string& text) {
  ImGui::PushTextWrapPos(0);
  muted_label(frame, text);
  ImGui::PopTextWrapPos();
}

std::string shortened(const std::string& text, float width) {
  if (ImGui::CalcTextSize(ui_text(text).c_str()).x <= width) return text;
  std::string_view left = text;
  std::string out;
  do {
    left = without_last(left);
    out = std::string(left) + "…";
  } while (!left.empty() && ImGui::CalcTextSize(out.c_str()).x > width);
  return out;
}

void same_line_if_room(float width, float gap) {
  ImGui::SameLine(0, gap);
  if (ImGui::GetContentRegionAvail().x < width) ImGui::NewLine();
}

float button_width(const std::string& text) {
  return ImGui::CalcTextSize(ui_text(text).c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
}

Rect tooltip_place(const Rect& item, Point mouse, double width, double height, const Rect& screen, double gap,
                   double large) {
  const auto fit = [](double at, double size, double lo, double hi) {
    return std::max(lo, std::min(at, hi - size));
  };
  if (item.h <= large) {
    const bool below = item.bottom() + gap + height <= screen.bottom();
    // Along what is wide it goes with the mouse.
    const double x = item.w <= 4 * large ? item.x : mouse.x - 0.5 * width;
    return {fit(x, width, screen.x, screen.right()), below ? item.bottom() + gap : item.y - gap - height,
            width, height};
  }
  const bool right = mouse.x + 2 * gap + width <= screen.right();
  const double y = fit(mouse.y - gap - height, height, screen.y, screen.bottom());
  return {right ? mouse.x + 2 * gap : mouse.x - 2 * gap - width, y, width, height};
}

void tooltip(const std::string& text) {
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) || text.empty()) return;
  const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax(), mouse = ImGui::GetMousePos();
  const ImGuiStyle& style = ImGui::GetStyle();
  const float wrap = ImGui::GetFontSize() * 22;
  const ImVec2 words = ImGui::CalcTextSize(ui_text(text).c_str(), nullptr, false, wrap);
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const Rect place =
      tooltip_place({lo.x, lo.y, hi.x - lo.x, hi.y - lo.y}, {mouse.x, mouse.y},
                    words.x + 2 * style.WindowPadding.x, words.y + 2 * style.WindowPadding.y,
                    {0, 0, display.x, display.y}, 0.4 * ImGui::GetFontSize(), 2.5 * ImGui::GetFrameHeight());
  ImGui::SetNextWindowPos({std::round(static_cast<float>(place.x)), std::round(static_cast<float>(place.y))});
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(wrap);
  label(text);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void heading(const GuiFrame& frame, const std::string& text) {
  ImGui::Dummy({0, frame.px(2)});
  label(text);
  const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
  const float y = std::round(0.5f * (lo.y + hi.y));
  const float right = ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x;
  ImGui::GetWindowDrawList()->AddRectFilled({hi.x + frame.px(8), y}, {right, y + frame.px(1)},
                                            packed(frame.theme().grid));
}

void read_out(const GuiFrame& frame, const std::string& name, const std::string& value, bool warn) {
  muted_label(frame, name);
  const std::string text = ui_text(value);
  const float width = ImGui::CalcTextSize(text.c_str()).x;
  ImGui::SameLine(std::max(ImGui::GetItemRectSize().x + frame.px(6), ImGui::GetContentRegionMax().x - width));
  if (warn) ImGui::PushStyleColor(ImGuiCol_Text, im_color(frame.theme().color(1)));
  ImGui::TextUnformatted(text.c_str());
  if (warn) ImGui::PopStyleColor();
}

bool icon_button(const GuiFrame& frame, const char* sign, const std::string& help, bool enabled) {
  const float side = ImGui::GetFrameHeight();
  ImGui::BeginDisabled(!enabled);
  ImGui::PushID(sign);
  const bool pressed = ImGui::Button("##icon", {side * 1.15f, side});
  ImGui::PopID();
  const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
  const Color ink = enabled ? frame.theme().text : frame.theme().muted;
  draw_sign(*ImGui::GetWindowDrawList(), sign, {0.5f * (lo.x + hi.x), 0.5f * (lo.y + hi.y)}, 0.25f * side,
            packed({ink.r, ink.g, ink.b, static_cast<std::uint8_t>(enabled ? 255 : 90)}));
  ImGui::EndDisabled();
  tooltip(help);
  return pressed;
}

bool toggle_button(const GuiFrame& frame, const std::string& text, bool on, const std::string& help) {
  if (on) {
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    ImGui::PushStyleColor(ImGuiCol_Text, im_color(frame.theme().text));
  } else {
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0, 0, 0, 0));
    ImGui::PushStyleColor(ImGuiCol_Text, im_color(frame.theme().muted));
  }
  const bool pressed = ImGui::Button(ui_text(text).c_str());
  ImGui::PopStyleColor(2);
  tooltip(help);
  return pressed;
}

namespace {

constexpr double kPlotNotch = 1.15;  // nearer a notch of the wheel, as in the picture

bool double_clicked() {
  for (const int button : {ImGuiMouseButton_Left, ImGuiMouseButton_Right, ImGuiMouseButton_Middle})
    if (ImGui::IsMouseDoubleClicked(button)) return true;
  return false;
}

// `moves`: the drag under way moves what is seen.
std::optional<PlotZoom> asked_part(const Plot& plot, const PlotTouch& touch, PlotHand hand, bool moves) {
  const ImGuiIO& io = ImGui::GetIO();
  const double notches = static_cast<double>(io.MouseWheel);
  if (touch.hovered && hand == PlotHand::zooms && double_clicked()) return PlotZoom{};
  if (moves && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0))
    return panned(plot, touch.layout, static_cast<double>(io.MouseDelta.x),
                  static_cast<double>(io.MouseDelta.y));
  if (touch.hovered && !touch.held && notches != 0)
    return zoomed(plot, touch.layout, touch.mouse, std::pow(kPlotNotch, notches));
  return std::nullopt;
}

}  // namespace

PlotTouch plot_widget(GuiFrame& frame, const char* id, const Plot& plot, ImVec2 size, PlotHand hand) {
  PlotTouch touch;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  size = {std::max(size.x, frame.px(40)), std::max(size.y, frame.px(40))};
  bool* moves = ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID(id) + 1);
  ImGui::InvisibleButton(id, size,
                         hand == PlotHand::none
                             ? ImGuiButtonFlags_None
                             : ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                                   ImGuiButtonFlags_MouseButtonMiddle);
  if (hand != PlotHand::none) ImGui::SetItemUsingMouseWheel();
  touch.hovered = ImGui::IsItemHovered();
  if (ImGui::IsItemActivated())
    *moves = hand != PlotHand::none && (!ImGui::IsMouseClicked(ImGuiMouseButton_Left) ||
                                        (ImGui::GetIO().KeyShift && hand != PlotHand::grips));
  touch.pressed = ImGui::IsItemActivated() && !*moves;
  touch.held = ImGui::IsItemActive() && !*moves;
  const bool moving = ImGui::IsItemActive() && *moves;
  const ImVec2 mouse = ImGui::GetMousePos();
  touch.mouse = {static_cast<double>(mouse.x), static_cast<double>(mouse.y)};

  PlotStyle style = panel_style().scaled(frame.unit);
  style.theme = frame.theme();
  touch.layout = layout_plot(plot,
                             {static_cast<double>(at.x), static_cast<double>(at.y),
                              static_cast<double>(size.x), static_cast<double>(size.y)},
                             style, frame.metrics);
  ImGuiCanvas canvas(frame.metrics, frame.fonts, *ImGui::GetWindowDrawList());
  paint_plot(plot, touch.layout, style, canvas);
  if (hand != PlotHand::none && !touch.layout.empty) touch.zoom = asked_part(plot, touch, hand, moving);
  return touch;
}

}  // namespace pabd
