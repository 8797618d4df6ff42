// SPDX-License-Identifier: MIT
// The button of a panel that writes its plot to a file.
#pragma once

#include <string>

#include "app/gui/panel.h"

namespace pabd {

// At the right end of the present line: a button, and below it a name to be changed; sends ExportPlot. `path`
// keeps the name that was used last; empty: one that fits is made.
void export_button(GuiFrame& frame, const char* panel, std::string& path);
// px that the button takes.
float export_width(const GuiFrame& frame);

}  // namespace pabd
