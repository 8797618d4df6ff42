// SPDX-License-Identifier: MIT
// Colours and sizes of Dear ImGui's widgets, after the inks of the plots.
#include "app/gui/panels.h"
#include "render/visual/palette.h"

namespace pabd {
namespace {

ImVec4 color(Color c, double alpha = 1) {
  return {static_cast<float>(c.r) / 255, static_cast<float>(c.g) / 255, static_cast<float>(c.b) / 255,
          static_cast<float>(alpha * c.a / 255)};
}

}  // namespace

void apply_gui_theme(ImGuiStyle& style, bool dark, double unit) {
  const PlotTheme& theme = dark ? dark_theme() : light_theme();
  const auto px = [unit](double ordinary) {
    return static_cast<float>(static_cast<int>(ordinary * unit + 0.5));
  };
  style = ImGuiStyle();
  style.AntiAliasedLinesUseTex = false;
  style.WindowPadding = {px(12), px(8)};
  style.FramePadding = {px(7), px(3)};
  style.ItemSpacing = {px(7), px(4)};
  style.ItemInnerSpacing = {px(5), px(4)};
  style.CellPadding = {px(4), px(2)};
  style.IndentSpacing = px(14);
  style.ScrollbarSize = px(11);
  style.GrabMinSize = px(11);
  style.WindowRounding = 0;
  style.FrameRounding = style.GrabRounding = style.TabRounding = style.PopupRounding = px(4);
  style.ScrollbarRounding = px(6);
  style.WindowBorderSize = 0;
  style.PopupBorderSize = px(1);
  style.WindowMinSize = {1, 1};
  style.DisabledAlpha = 0.45f;

  const Color panel = dark ? Color{30, 35, 41, 255} : Color{250, 251, 252, 255};
  const Color field = dark ? Color{45, 52, 61, 255} : Color{229, 234, 240, 255};
  const Color hover = dark ? Color{58, 68, 80, 255} : Color{214, 222, 231, 255};
  const Color accent = dark ? Color{64, 110, 160, 255} : Color{164, 196, 230, 255};
  const Color grab = dark ? Color{118, 168, 220, 255} : Color{46, 107, 168, 255};
  ImVec4* c = style.Colors;
  c[ImGuiCol_Text] = color(theme.text);
  c[ImGuiCol_TextDisabled] = color(theme.muted);
  c[ImGuiCol_WindowBg] = color(panel);
  c[ImGuiCol_ChildBg] = ImVec4(0, 0, 0, 0);
  c[ImGuiCol_PopupBg] = color(panel);
  c[ImGuiCol_Border] = color(hover);
  c[ImGuiCol_FrameBg] = color(field);
  c[ImGuiCol_FrameBgHovered] = color(hover);
  c[ImGuiCol_FrameBgActive] = color(hover);
  c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = c[ImGuiCol_TitleBgCollapsed] = color(field);
  c[ImGuiCol_ScrollbarBg] = ImVec4(0, 0, 0, 0);
  c[ImGuiCol_ScrollbarGrab] = color(hover);
  c[ImGuiCol_ScrollbarGrabHovered] = c[ImGuiCol_ScrollbarGrabActive] = color(accent);
  c[ImGuiCol_CheckMark] = color(grab);
  c[ImGuiCol_SliderGrab] = color(grab, 0.85);
  c[ImGuiCol_SliderGrabActive] = color(grab);
  c[ImGuiCol_Button] = color(field);
  c[ImGuiCol_ButtonHovered] = color(hover);
  c[ImGuiCol_ButtonActive] = color(accent);
  c[ImGuiCol_Header] = color(accent, 0.55);
  c[ImGuiCol_HeaderHovered] = color(hover);
  c[ImGuiCol_HeaderActive] = color(accent);
  c[ImGuiCol_Separator] = color(hover);
  c[ImGuiCol_Tab] = color(panel);
  c[ImGuiCol_TabHovered] = color(hover);
  c[ImGuiCol_TabActive] = color(accent);
  c[ImGuiCol_TabUnfocused] = color(panel);
  c[ImGuiCol_TabUnfocusedActive] = color(accent);
  c[ImGuiCol_TextSelectedBg] = color(accent);
  c[ImGuiCol_NavHighlight] = color(grab);
  c[ImGuiCol_ModalWindowDimBg] = ImVec4(0, 0, 0, dark ? 0.45f : 0.25f);
}

Vec3f window_background(bool dark) { return srgb_color(dark ? 0x171B20 : 0xDDE3EA).head<3>(); }

}  // namespace pabd
