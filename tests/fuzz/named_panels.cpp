// SPDX-License-Identifier: MIT
// The window's panels by name alone: scripts name them, and the fuzzer of scripts draws nothing.
#include "app/gui/window_panel.h"

namespace pabd {

class GuiPanel {};  // there is none here

#define PABD_NAMED(word) const WindowPanel word##_tab = {#word, #word, "", Slot::left, nullptr};
PABD_WINDOW_PANELS(PABD_NAMED)
#undef PABD_NAMED

}  // namespace pabd
