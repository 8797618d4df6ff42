// SPDX-License-Identifier: MIT
// See picture_notes.h. The latest message is at the bottom left: notes disappear after a while, warnings and errors stay
// until they are dismissed. Questions are at the top.
#include "app/gui/picture_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/gui/inspector_rows.h"
#include "app/gui/panels.h"
#include "app/gui/pictures.h"
#include "app/gui/scene_view.h"
#include "app/gui/widgets.h"
#include "app/overlay/imgui_canvas.h"
#include "app/overlay/view_marks.h"
#include "render/visual/camera_control.h"
#include "sim/base/srgb.h"

namespace pabd {
namespace {

constexpr double kNoteSeconds = 4;
constexpr ImGuiWindowFlags kOverPicture = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                          ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

ImVec2 operator+(ImVec2 a, ImVec2 b) { return {a.x + b.x, a.y + b.y}; }

// Text on a plate; `align`: part of its size that is left of and above `at`.
void note(const GuiFrame& f, ImVec2 at, const std::string& text, ImVec2 align) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const std::string shown = ui_text(text);
  const ImVec2 size = ImGui::CalcTextSize(shown.c_str());
  const ImVec2 pad(f.px(7), f.px(4));
  const ImVec2 lo(std::round(at.x - align.x * (size.x + 2 * pad.x)),
                  std::round(at.y - align.y * (size.y + 2 * pad.y)));
  list.AddRectFilled(lo, lo + size + pad + pad, packed(f.theme().legend), f.px(4));
  list.AddText(lo + pad, packed(f.theme().text), shown.c_str());
}

ImU32 map_color(double t) {
  const Vec4f c = value_color(t);
  return IM_COL32(srgb_byte(c.x()), srgb_byte(c.y()), srgb_byte(c.z()), 255);
}

// Heights in pixels of an ordinary screen, with the room below.
constexpr double kLegend = 68, kNames = 32, kTop = 12;

bool shows_contact_legend(const GuiFrame& f) {
  return f.ui.contacts && f.ui.contacts_by != ContactQuantity::gap;
}

// Title and bar with its upper right corner there; `most`: pixels that it may be wide.
void color_bar(const GuiFrame& f, float right, float top, float most, const std::string& title,
               const ValueRange& range) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float width = std::max(std::min(f.px(200), most), ImGui::CalcTextSize(ui_text(title).c_str()).x);
  const float bar = f.px(10), line = ImGui::GetTextLineHeight();
  const ImVec2 pad(f.px(10), f.px(7));
  const ImVec2 lo(right - width - 2 * pad.x, top);
  list.AddRectFilled(lo, {right, top + 2 * line + bar + 2 * pad.y + f.px(6)}, packed(f.theme().legend),
                     f.px(4));
  const ImVec2 at = lo + pad;
  list.AddText(at, packed(f.theme().text), ui_text(title).c_str());
  const float bar_top = at.y + line + f.px(3);
  constexpr int kPieces = 50;
  for (int i = 0; i < kPieces; ++i) {
    const float a = at.x + width * static_cast<float>(i) / kPieces;
    list.AddRectFilled({a, bar_top}, {at.x + width * static_cast<float>(i + 1) / kPieces, bar_top + bar},
                       map_color((i + 0.5) / kPieces));
  }
  const float below = bar_top + bar + f.px(3), gap = f.px(5);
  const auto text_at = [&](double t) { return fmt::format("{:.3g}", range.value(t)); };
  const auto left_of = [&](double t) {
    return std::round(at.x + static_cast<float>(t) * (width - ImGui::CalcTextSize(text_at(t).c_str()).x));
  };
  const std::vector<double> places = range.places();
  float free = at.x;
  for (const double t : places) {
    const float left = left_of(t), end = left + ImGui::CalcTextSize(text_at(t).c_str()).x;
    // Those of the ends, and between them what has room.
    const bool inner = t != places.front() && t != places.back();
    if (inner && (left < free || end + gap > left_of(places.back()))) continue;
    list.AddText({left, below}, packed(f.theme().muted), text_at(t).c_str());
    free = end + gap;
  }
}

// Do the names of two simulations reach below the legends at the right?
bool names_are_in_the_way(const GuiFrame& f) {
  constexpr double kWidest = 236;  // of a legend, and its distance from the edge
  if (!f.sim.b) return false;
  const Rect& last = f.ui.side_by_side ? f.layout.views[1] : f.layout.view;
  const float name = ImGui::CalcTextSize(f.ui.side_by_side ? "B" : "A, and B as a ghost").x;
  return last.x + static_cast<double>(name + f.px(24)) > f.layout.view.right() - kWidest * f.unit;
}

void legends(const GuiFrame& f, const Rect& view) {
  if (view.w < 220 * f.unit) return;
  const BodyColors colors = shown_colors(f.sim, f.sim.a, f.ui.color);
  const float right = static_cast<float>(view.right()) - f.px(12);
  float top = static_cast<float>(view.y) + f.px(12) + (names_are_in_the_way(f) ? f.px(kNames) : 0);
  const float most = 0.42f * static_cast<float>(view.w);
  if (!colors.note.empty()) note(f, {right, top}, colors.note, {1, 0});
  if (colors.note.empty() && !colors.values.empty())
    color_bar(f, right, top, most, colors.title, colors.range);
  if (!shows_contact_legend(f)) return;
  if (!colors.values.empty()) top += f.px(kLegend);
  const bool force = f.ui.contacts_by == ContactQuantity::force;
  color_bar(f, right, top, most, force ? "normal force, N" : "friction / (μ · normal force)",
            force ? shown_forces(f.sim) : ValueRange{});
}

// Beside the springs of hands: how hard they pull.
void pulls(const GuiFrame& f, const RunView& run, const Rect& view) {
  for (const Pull& pull : run.pulls) {
    const auto i = static_cast<std::size_t>(pull.body);
    if (i >= run.state->c.size()) continue;
    const Vec3 held = run.state->c[i] + run.state->R[i] * pull.r;
    const PixelPoint a = to_pixel(f.ui.camera, {view.w, view.h}, held);
    const PixelPoint b = to_pixel(f.ui.camera, {view.w, view.h}, pull.target);
    if (!(a.depth > 0 && b.depth > 0)) continue;
    const double force = pull.kappa * (pull.target - held).norm();
    const double x = std::clamp(view.x + b.x, view.x + 4, view.right() - 90 * f.unit);
    const double y = std::clamp(view.y + b.y, view.y + 30 * f.unit, view.bottom() - 8);
    note(f, {static_cast<float>(x) + f.px(14), static_cast<float>(y)}, force_text(force), {0, 0.5f});
  }
}

}  // namespace

double below_captions(const GuiFrame& f) {
  const double count = (f.ui.color != ColorQuantity::body) + shows_contact_legend(f);
  const bool names = count > 0 ? names_are_in_the_way(f) : f.sim.b.has_value();
  return f.unit * (kTop + count * kLegend + (names ? kNames : 0));
}
double below_recording(const GuiFrame& f) {
  constexpr double kRecording = 96;
  return below_captions(f) + (f.recorder.busy() ? kRecording * f.unit : 0);
}
double below_offer(const GuiFrame& f) {
  constexpr double kOffer = 116;
  return below_recording(f) + (f.sim.file_changed ? kOffer * f.unit : 0);
}

void draw_picture_notes(GuiFrame& f, const GuiLayout& layout) {
  const bool two = f.sim.b && f.ui.side_by_side;
  ImGui::GetBackgroundDrawList()->PushClipRect(
      {static_cast<float>(layout.view.x), static_cast<float>(layout.view.y)},
      {static_cast<float>(layout.view.right()), static_cast<float>(layout.view.bottom())});
  draw_compare_labels(f, layout);  // under the legends
  legends(f, layout.view);
  if (f.ui.marks.axes || f.ui.marks.scale) {
    ImGuiCanvas canvas(f.metrics, f.fonts, *ImGui::GetBackgroundDrawList());
    const Camera camera = rounded(f.ui.camera);
    if (f.ui.marks.axes) paint_axes(camera, f.ui.theme->inks, layout.views[0], f.unit, canvas);
    if (f.ui.marks.scale)
      paint_scale_bar(camera, f.ui.theme->inks, layout.views[0].h, layout.views[0], f.unit, canvas);
  }
  pulls(f, f.sim.a, layout.views[0]);
  if (two) pulls(f, *f.sim.b, layout.views[1]);
  if (f.ui.joining) {
    note(f,
         {static_cast<float>(layout.view.x + 0.5 * layout.view.w),
          static_cast<float>(layout.view.y + below_offer(f))},
         fmt::format("double-click the body that a {} joint should hold (Esc: none)", f.ui.joining->type),
         {0.5f, 0});
  }
  ImGui::GetBackgroundDrawList()->PopClipRect();
}

void MessageList::draw(GuiFrame& f, const Rect& view, double seconds, std::uint64_t read) {
  if (f.sim.messages.empty()) return;
  const Message& m = f.sim.messages.back();
  if (m.number != newest_) {
    newest_ = m.number;
    age_ = 0;
  }
  age_ += seconds;
  dismissed_ = std::max(dismissed_, read);
  if (m.number <= dismissed_ || (m.severity == Severity::note && age_ > kNoteSeconds)) return;
  const float width = std::min(f.px(560), static_cast<float>(view.w) - f.px(24));
  if (width < f.px(80)) return;
  ImGui::SetNextWindowPos(
      {static_cast<float>(view.x) + f.px(12), static_cast<float>(view.bottom()) - f.px(12)}, ImGuiCond_Always,
      {0, 1});
  // As high as its words, at most as high as the picture; the rest is scrolled to.
  const float most = std::max(f.px(40), static_cast<float>(view.h) - f.px(24));
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, most});
  ImGui::Begin("##messages", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_AlwaysAutoResize | kOverPicture);
  const Color ink = m.severity == Severity::note ? f.theme().color(2) : f.theme().color(1);
  const ImVec2 lo = ImGui::GetWindowPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRectFullScreen();
  list.AddRectFilled(lo, {lo.x + f.px(4), lo.y + ImGui::GetWindowHeight()}, packed(ink));
  list.PopClipRect();
  ImGui::PushTextWrapPos(width - f.px(44));
  label(m.text);
  ImGui::PopTextWrapPos();
  ImGui::SameLine(width - f.px(34));
  if (ImGui::Button("×")) dismissed_ = m.number;
  tooltip("Dismiss");
  ImGui::End();
}

void draw_file_offer(GuiFrame& f, const Rect& view) {
  if (!f.sim.file_changed) return;
  const float width = std::min(f.px(420), static_cast<float>(view.w) - f.px(24));
  if (width < f.px(80)) return;
  const float top = static_cast<float>(view.y + below_recording(f));
  ImGui::SetNextWindowPos({static_cast<float>(view.x + 0.5 * view.w), top}, ImGuiCond_Always, {0.5f, 0});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::Begin("##file_offer", nullptr, ImGuiWindowFlags_NoDecoration | kOverPicture);
  ImGui::PushTextWrapPos(0);
  label(std::filesystem::path(f.sim.scene_path).filename().string() + " changed on disk.");
  muted_label(f, f.sim.reload_loses.empty()
                     ? "Loading it again keeps the parameters that were changed here."
                     : "Loading it again keeps the parameters that were changed here, and gives up " +
                           listed(f.sim.reload_loses) + ".");
  ImGui::PopTextWrapPos();
  if (ImGui::Button("Load again")) f.out.send(command::Reload{true});
  tooltip("The scene as it is on disk now (ctrl+r)");
  ImGui::SameLine();
  if (ImGui::Button("Keep this")) f.out.send(command::IgnoreFile{});
  tooltip("The scene stays as it is here; the file stays as it is there");
  ImGui::End();
}

}  // namespace pabd
