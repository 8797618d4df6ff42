// SPDX-License-Identifier: MIT
// For programs that are built without GLFW: asking for a window says so.
#include "render/context/window.h"
#include "sim/base/error.h"

namespace pabd {

std::unique_ptr<Window> open_window(const WindowOptions&) {
  throw Error(
      ErrorKind::no_context,
      "no window: this program was built with PABD_WINDOW=OFF; give --headless, or build it with GLFW "
      "(the preset 'release')");
}

}  // namespace pabd
