// SPDX-License-Identifier: MIT
// What the simulation is asked to tell of its steps: only what somebody looks at. Bodies that a GPU moves and draws may
// stay there until somebody asks where they are.
#pragma once

#include <deque>
#include <memory>

#include "app/gui/device_picture.h"
#include "app/gui/gui_layout.h"
#include "app/gui/ui_state.h"
#include "app/workbench/runner.h"
#include "render/context/window.h"

namespace pabd {

// Whether the picture shows more of bodies than a GPU that moves them can draw by itself.
bool takes_states(const Snapshot& sim, const UiState& ui);

class Observer {
 public:
  // `runner` outlives this.
  explicit Observer(Runner& runner) : runner_(runner) {}

  // What later steps tell. `states`: where bodies are, too.
  void observe(const Snapshot& sim, const UiState& ui, bool states);

  // Whether what a person does now may ask where bodies are: all but turning the camera, and what takes no button. `view`:
  // the picture; `now`: ImGui's time, by which it counts double clicks; s.
  bool asks(const std::deque<WindowEvent>& events, const Rect& view, double now);

  // The snapshot, or a later one that says where bodies are: waits for the rest of a step, and for the GPU.
  std::shared_ptr<const Snapshot> with_states(std::shared_ptr<const Snapshot> sim);

  // A message, once, where pictures cannot be drawn from the GPU's memory.
  void tell_of(const DevicePicture& device);

 private:
  void send(const command::Observe& want);
  bool asks(const WindowEvent& event, const Rect& view, double now);

  Runner& runner_;
  command::Observe observed_;
  double pressed_ = -1e9;  // when a button was pressed last; s
  bool failed_ = false;
};

}  // namespace pabd
