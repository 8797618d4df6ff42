// SPDX-License-Identifier: MIT
// A display that goes away. Xlib and GLFW's access to it are looked up at run time: no X headers, and GLFW
// may have been built for another window system.
#include "render/context/display_loss.h"

#include <unistd.h>

namespace pabd {
namespace {

constexpr const char* kXlib[] = {"libX11.so.6", nullptr};
constexpr const char* kGlfw[] = {"libglfw.so.3", nullptr};

// Xlib gives its first function nothing to know it by.
std::atomic<bool> opening{false};
std::atomic<int> status_when_lost{1};

// Xlib calls two functions when a connection breaks; each would end the program. Where both return, Xlib's
// caller goes on, and later calls do nothing. GLFW and drivers do not bear that while they open a window:
// they wait for ever or crash. Nothing is at stake by then.
int keep_going(void*) {
  if (!opening) return 0;
  constexpr char kText[] = "pabd: error: the display was lost while the window was being opened\n";
  static_cast<void>(write(STDERR_FILENO, kText, sizeof kText - 1) < 0);
  _exit(status_when_lost);
}
void note(void*, void* lost) { *static_cast<std::atomic<bool>*>(lost) = true; }

}  // namespace

DisplayLoss::DisplayLoss(int exit_status) : xlib_(kXlib) {
  using SetHandler = void* (*)(int (*handler)(void*));
  status_when_lost = exit_status;
  opening = true;
  if (const auto set_handler = xlib_.find<SetHandler>("XSetIOErrorHandler")) set_handler(keep_going);
}

void DisplayLoss::watch() {
  using GetDisplay = void* (*)();
  using SetExitHandler = void (*)(void* display, void (*handler)(void*, void*), void* data);
  const SharedLibrary glfw(kGlfw);
  const auto get_display = glfw.find<GetDisplay>("glfwGetX11Display");
  const auto set_exit_handler = xlib_.find<SetExitHandler>("XSetIOErrorExitHandler");
  if (get_display == nullptr || set_exit_handler == nullptr) return;
  void* const display = get_display();
  if (display != nullptr) set_exit_handler(display, note, lost_.get());
}

void DisplayLoss::opened() { opening = false; }

DisplayLoss::~DisplayLoss() {
  opening = false;
  // A lost display is never closed: closing would wait for an answer. Xlib keeps the pointer.
  if (lost()) static_cast<void>(lost_.release());
}

}  // namespace pabd
