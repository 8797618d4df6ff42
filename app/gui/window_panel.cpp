// SPDX-License-Identifier: MIT
// See window_panel.h.
#include "app/gui/window_panel.h"

#include <fmt/format.h>

#include "sim/base/error.h"
#include "sim/scene/text.h"

namespace pabd {

std::vector<const WindowPanel*> panels_of(Slot slot, WindowPanelTable table) {
  std::vector<const WindowPanel*> out;
  for (const WindowPanel* panel : table) {
    if (panel->slot == slot) out.push_back(panel);
  }
  return out;
}

const WindowPanel& find_panel(std::string_view name, WindowPanelTable table) {
  std::vector<std::string_view> names;
  for (const WindowPanel* panel : table) {
    if (name == panel->name) return *panel;
    names.push_back(panel->name);
  }
  throw Error(ErrorKind::bad_input,
              fmt::format("panel: {} is not one of {}", in_quotes(std::string(name)), one_of(names)));
}

std::string panel_words(WindowPanelTable table) {
  std::string out;
  for (std::size_t i = 0; i < table.size(); ++i)
    out += (i == 0 ? "" : i + 1 < table.size() ? ", " : " or ") + std::string(table[i]->name);
  return out;
}

}  // namespace pabd
