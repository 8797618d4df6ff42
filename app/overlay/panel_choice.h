// SPDX-License-Identifier: MIT
// Which panels are shown.
#pragma once

#include <string>
#include <vector>

#include "app/overlay/overlay_panel_table.h"

namespace pabd {

// Some of the panels of a table, in its order. The table outlives it.
class OverlayOptions {
 public:
  OverlayOptions() : OverlayOptions(overlay_panels()) {}
  explicit OverlayOptions(PanelTable table) : table_(table), on_(table.size(), false) {}

  void show(const OverlayPanel& panel);  // precondition: it is in the table
  void show_with(PictureLayer layer);    // those that come with it
  bool shows(const OverlayPanel& panel) const;
  std::vector<const OverlayPanel*> shown() const;
  // The first shown panel that has a need, such as &OverlayPanel::contacts; null: none has.
  const OverlayPanel* needing(bool OverlayPanel::*need) const;

  PanelTable table() const { return table_; }

 private:
  PanelTable table_;
  std::vector<bool> on_;
};

// Switches on the panel of that name, or with "plots" those in the column that need no other run, with "all" every
// named one that needs none. False when there is no such panel.
bool enable_panel(OverlayOptions& options, const std::string& name);

// The names for messages: "params, barrier, …, plots".
std::string panel_names(PanelTable table = overlay_panels());
// The same for help, with what "plots" stands for and what needs --ab.
std::string panel_help(PanelTable table = overlay_panels());

// From "params,plots". Empty or "none": nothing. Throws Error(bad_input) naming the word and the list.
OverlayOptions parse_panels(const std::string& list, PanelTable table = overlay_panels());

}  // namespace pabd
