// SPDX-License-Identifier: MIT
// Over the picture, bottom left: the latest note, warning or error, where a person looks anyway. Notes go by
// themselves, the others stay until they are dismissed or something else happened.
#include <algorithm>

#include "app/gui/panels.h"
#include "app/gui/widgets.h"

namespace pabd {
namespace {

constexpr double kNoteSeconds = 4;

}  // namespace

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
  // As high as its words, but never higher than the picture: what does not fit is scrolled to.
  const float most = std::max(f.px(40), static_cast<float>(view.h) - f.px(24));
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, most});
  ImGui::Begin("##messages", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_NoNav);
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

}  // namespace pabd
