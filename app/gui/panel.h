// SPDX-License-Identifier: MIT
// A panel of the window: reads, draws, and sends commands. Each has a file of its own.
#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "app/gui/ui_state.h"
#include "app/overlay/font_atlas.h"
#include "app/plots/canvas.h"
#include "app/plots/theme.h"
#include "app/workbench/snapshot.h"
#include "render/gl/renderer.h"

namespace pabd {

// Commands of panels and keys, in order.
struct Outbox {
  std::vector<Command> commands;
  std::vector<ViewCommand> view;

  void send(Command command) { commands.push_back(std::move(command)); }
  void send(ViewCommand command) { view.push_back(std::move(command)); }
};

// Opens another scene; asks first when unsaved work would be lost.
void open_scene(const Snapshot& sim, const std::string& path, Outbox& out);

// A file that was dropped on the window: see DroppedKind.
void open_dropped(const Snapshot& sim, const std::string& path, Outbox& out);

class FileRoot;
class FrameCosts;
struct GuiLayout;
class Recorder;
class SceneList;
class SweepReader;

// What a frame is made from.
struct GuiFrame {
  const Snapshot& sim;
  const UiState& ui;
  const GuiLayout& layout;
  double unit;  // pixels of a pixel of an ordinary screen
  FontAtlas& fonts;
  const FontMetrics& metrics;
  Outbox& out;
  const SceneList& scenes;
  const Recorder& recorder;
  const FrameCosts& costs;
  SweepReader& sweeps;
  bool steady;                      // for pictures of tests: nothing that depends on the clock
  const FileRoot* files = nullptr;  // the only ones that may be named; null: any

  const PlotTheme& theme() const { return ui.dark ? dark_theme() : light_theme(); }
  float px(double ordinary) const { return static_cast<float>(ordinary * unit); }
};

// A panel at work; its name and place are in its WindowPanel.
class GuiPanel {
 public:
  virtual ~GuiPanel() = default;
  // Fills the current ImGui window, whose content region is the panel's.
  virtual void draw(GuiFrame& frame) = 0;
};

template <class P>
std::unique_ptr<GuiPanel> make_panel() {
  return std::make_unique<P>();
}

}  // namespace pabd
