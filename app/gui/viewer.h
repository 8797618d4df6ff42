// SPDX-License-Identifier: MIT
// The window's content: takes events, draws a frame, sends commands to the simulation. The caller shows the frame.
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/gui/gui_layout.h"
#include "app/gui/panel.h"
#include "app/workbench/file_root.h"
#include "app/workbench/runner.h"
#include "render/context/window.h"
#include "render/gl/renderer.h"

namespace pabd {

struct ViewerOptions {
  double screen_scale = 1;  // pixels of a pixel of an ordinary screen
  bool steady = false;      // for pictures of tests: nothing that depends on the clock is shown
  UiState start;            // what the view begins with
  std::function<std::vector<std::filesystem::path>()> shipped_scenes;
  std::function<std::string()> clipboard;
  std::function<void(const std::string&)> set_clipboard;
  // The only files that commands may name, for a session in a browser; null: any.
  std::shared_ptr<const FileRoot> files;
  bool can_quit = true;  // else the command is refused
};

class Viewer {
 public:
  // `context` is current in every call and outlives the viewer, as does `runner`.
  Viewer(GlContext& context, Runner& runner, const ViewerOptions& options);
  ~Viewer();
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  void handle(const WindowEvent& event);
  void send(const Command& command);
  void send(const ViewCommand& command);  // what does not fit changes nothing and becomes a message

  // Draws a frame of that size in pixels, `seconds` after the last one, into the renderer.
  void draw(int width, int height, double seconds);
  // A picture of another size between two frames, without pointer and events. Precondition: no button is held, as
  // what it drags would be elsewhere.
  void draw_aside(int width, int height);
  bool button_held() const;

  Renderer& renderer();
  const UiState& ui() const;
  const Snapshot& snapshot() const;  // that the last frame showed
  void set_screen_scale(double scale);
  const GuiLayout& layout() const;  // of the last frame
  MouseCursor cursor() const;       // that suits what the pointer is over
  bool has_input() const;           // events that wait for the next frame
  std::size_t waiting_events() const;
  bool wants_text() const;  // a field is being typed into

  // The file that a name in a command means. Throws Error(bad_input) where it may not be named.
  std::string file_of(const std::string& name, FileUse use = FileUse::read) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pabd
