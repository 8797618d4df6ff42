// SPDX-License-Identifier: MIT
// A window on the screen: a GL context to draw with, and what the person in front of it does.
//
// All lengths are in pixels of the framebuffer, from its top left corner; content_scale() says how many of
// them make a pixel of an ordinary screen.
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "render/context/context.h"
#include "render/context/keyboard.h"

namespace pabd {

struct MouseMoved {
  double x = 0, y = 0;
};
struct MouseLeft {};  // the pointer is outside the window
struct MouseClicked {
  MouseButton button = MouseButton::left;
  bool pressed = false;
  Modifiers modifiers;
};
struct MouseScrolled {
  double x = 0, y = 0;  // notches of the wheel; y > 0: away from the person
};
struct KeyChanged {
  Key key = Key::none;
  Modifiers modifiers;  // with the key itself, if it is one
  bool pressed = false;
  bool repeated = false;  // held down
};
struct TextTyped {
  std::string text;  // UTF-8, one character
};
struct WindowResized {
  int width = 0, height = 0;
};
struct ScaleChanged {
  double scale = 1;
};
struct FocusChanged {
  bool focused = false;
};
struct CloseRequested {};
struct FilesDropped {
  std::vector<std::string> paths;
};

using WindowEvent = std::variant<MouseMoved, MouseLeft, MouseClicked, MouseScrolled, KeyChanged, TextTyped,
                                 WindowResized, ScaleChanged, FocusChanged, CloseRequested, FilesDropped>;

enum class MouseCursor { arrow, text, cross, hand, resize_horizontal, resize_vertical };

struct WindowOptions {
  std::string title = "pabd";
  int width = 1280, height = 720;             // on an ordinary screen; times the scale on a dense one
  int least_width = 640, least_height = 360;  // the person cannot make it smaller
  bool visible = true;
  // Exit status of the process if the display breaks while the window is being opened: Xlib cannot go on
  // then.
  int display_lost_status = 1;
};

// One at a time in a process; made, used and destroyed in the main thread.
class Window {
 public:
  virtual ~Window() = default;

  virtual GlContext& context() = 0;  // current when the window is made; lives as long as the window

  // What happened since the last call, oldest first. Waits up to `wait` seconds for the first event.
  virtual std::vector<WindowEvent> poll(double wait = 0) = 0;

  // The person wants it closed, or the display is gone.
  virtual bool should_close() const = 0;
  // Takes back a wish to close: "save first?".
  virtual void keep_open() = 0;
  // The connection to the display broke. Nothing can be shown any more; every call does nothing.
  virtual bool display_lost() const = 0;
  // Asks the window system whether it is still there. To be asked before each use of the window's own
  // framebuffer: Mesa takes the size of a window that is gone from memory that nobody set, and draws there.
  virtual bool answers() const = 0;

  virtual double content_scale() const = 0;
  // Of the framebuffer; 0×0 while the window is minimised or its display lost.
  virtual void size(int& width, int& height) const = 0;
  virtual void set_title(const std::string& title) = 0;
  virtual void set_cursor(MouseCursor cursor) = 0;

  virtual std::string clipboard() const = 0;  // UTF-8; empty when there is no text in it
  virtual void set_clipboard(const std::string& text) = 0;
};

// Throws Error(no_context) with what was tried and the remedy when there is no display, when the driver lacks
// OpenGL 3.3 core, or when the program was built without a window.
std::unique_ptr<Window> open_window(const WindowOptions& options);

}  // namespace pabd
