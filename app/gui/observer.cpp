// SPDX-License-Identifier: MIT
// See observer.h.
#include "app/gui/observer.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

#include "app/gui/panel.h"

namespace pabd {
namespace {

constexpr Index kMostTold = 100'000;  // bodies on a GPU whose contacts are read back
constexpr double kDoubleClick = 0.5;  // s between two presses that may be one, at most

}  // namespace

bool takes_states(const Snapshot& sim, const UiState& ui) {
  const bool marks = ui.marks.velocities || ui.marks.boxes;
  const bool chosen = ui.selection.kind != Selection::Kind::none || ui.follow || ui.joining;
  return sim.b || marks || chosen || !ui.trails.empty() || ui.color != ColorQuantity::body ||
         (ui.contacts && ui.contacts_by != ContactQuantity::gap);
}

void Observer::observe(const Snapshot& sim, const UiState& ui, bool states) {
  command::Observe want;
  const auto seen = [&](bool WindowPanel::*need) {
    const auto panels = window_panels();
    return std::any_of(panels.begin(), panels.end(),
                       [&](const WindowPanel* panel) { return panel->*need && ui.shows(*panel); });
  };
  const bool chosen = ui.selection.kind != Selection::Kind::none;
  const bool too_many = sim.a.model->size() > kMostTold && !sim.a.device.name.empty();
  want.iterations = seen(&WindowPanel::iterations);
  want.contacts = !too_many && (ui.contacts || ui.bonds || seen(&WindowPanel::contacts) || chosen);
  want.bodies = ui.color != ColorQuantity::body || ui.selection.kind == Selection::Kind::body;
  want.states = want.contacts || states;
  send(want);
}

void Observer::send(const command::Observe& want) {
  if (want == observed_) return;
  observed_ = want;
  runner_.send(want);
}

bool Observer::asks(const std::deque<WindowEvent>& events, const Rect& view, double now) {
  return std::count_if(events.begin(), events.end(),
                       [&](const WindowEvent& event) { return asks(event, view, now); }) > 0;
}

bool Observer::asks(const WindowEvent& event, const Rect& view, double now) {
  if (const auto* key = std::get_if<KeyChanged>(&event)) return key->pressed;
  const auto* click = std::get_if<MouseClicked>(&event);
  if (!click) return std::holds_alternative<FilesDropped>(event);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const bool inside = view.contains(Point{static_cast<double>(mouse.x), static_cast<double>(mouse.y)});
  const bool again = click->pressed && now - std::exchange(pressed_, now) < kDoubleClick;
  return again || !inside || click->modifiers.ctrl || ImGui::IsKeyDown(ImGuiKey_Space);
}

std::shared_ptr<const Snapshot> Observer::with_states(std::shared_ptr<const Snapshot> sim) {
  if (!sim->a.poses) return sim;
  command::Observe want = observed_;
  want.states = true;
  send(want);
  return runner_.settle();
}

void Observer::tell_of(const DevicePicture& device) {
  if (failed_ || device.failure().empty()) return;
  failed_ = true;
  runner_.send(command::Tell{"bodies come back from the GPU for each picture: " + device.failure(), false});
}

}  // namespace pabd
