// SPDX-License-Identifier: MIT
// Window events as Dear ImGui takes them.
#pragma once

#include <imgui.h>

#include <deque>

#include "render/context/window.h"

namespace pabd {

// A context for the window, current; whoever asked destroys it.
ImGuiContext* make_gui_context();

// The queue of events. Of a press and a release of the same button or key the second waits for the next frame, as Dear
// ImGui would not see the press.
class ImGuiInput {
 public:
  void add(const WindowEvent& event) { waiting_.push_back(event); }
  bool empty() const { return waiting_.empty(); }
  std::size_t waiting() const { return waiting_.size(); }
  const std::deque<WindowEvent>& events() const { return waiting_; }  // oldest first

  // Hands the events of one frame to ImGui and returns them.
  std::vector<WindowEvent> feed(ImGuiIO& io);

 private:
  std::deque<WindowEvent> waiting_;
};

// The pointer that Dear ImGui asks for.
MouseCursor imgui_cursor();

}  // namespace pabd
