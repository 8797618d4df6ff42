// A display that goes away. Xlib and GLFW's access to it are looked up at run time: no X headers, and GLFW
// may have been built for another window system.
#include "render/context/display_loss.h"

namespace pabd {
namespace {

constexpr const char* kXlib[] = {"libX11.so.6", nullptr};
constexpr const char* kGlfw[] = {"libglfw.so.3", nullptr};

// Xlib calls two functions when a connection breaks; each would end the program. Where both return, Xlib's
// caller goes on, and later calls do nothing.
int keep_going(void*) { return 0; }
void note(void*, void* lost) { *static_cast<std::atomic<bool>*>(lost) = true; }

}  // namespace

DisplayLoss::DisplayLoss() : xlib_(kXlib) {
  using GetDisplay = void* (*)();
  using SetHandler = void* (*)(int (*handler)(void*));
  using SetExitHandler = void (*)(void* display, void (*handler)(void*, void*), void* data);
  const SharedLibrary glfw(kGlfw);
  const auto get_display = glfw.find<GetDisplay>("glfwGetX11Display");
  const auto set_exit_handler = xlib_.find<SetExitHandler>("XSetIOErrorExitHandler");
  const auto set_handler = xlib_.find<SetHandler>("XSetIOErrorHandler");
  if (get_display == nullptr || set_exit_handler == nullptr || set_handler == nullptr) return;
  void* const display = get_display();
  if (display == nullptr) return;
  set_handler(keep_going);
  set_exit_handler(display, note, lost_.get());
}

DisplayLoss::~DisplayLoss() {
  // A lost display is never closed: closing would wait for an answer. Xlib keeps the pointer.
  if (lost()) static_cast<void>(lost_.release());
}

}  // namespace pabd
