// SPDX-License-Identifier: MIT
// All commands of the window by their words, to be searched: the palette. Finding knows no window.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/gui/panel.h"

namespace pabd {

struct PaletteEntry {
  std::string group;  // "Files"
  std::string words;  // "open a scene"
  std::string keys;   // "Ctrl+O"; empty: it has none
  std::function<void(const Snapshot& sim, const UiState& ui, Outbox& out)> act;
};

// Every key of the table, once, and what the window can do that has no key.
const std::vector<PaletteEntry>& palette_entries();

// Those in which every word of `text` begins a word of the entry or stands within one, in any case; entries in
// which they begin words come first. All of them for an empty text.
std::vector<const PaletteEntry*> find_entries(const std::vector<PaletteEntry>& entries,
                                              std::string_view text);

class Palette {
 public:
  void draw(GuiFrame& frame, int width, int height);

 private:
  std::string text_;
  int chosen_ = 0;
  bool open_ = false;
};

}  // namespace pabd
