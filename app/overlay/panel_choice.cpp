// SPDX-License-Identifier: MIT
// Which panels are shown.
#include "app/overlay/panel_choice.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/error.h"

namespace pabd {
namespace {

bool in_plots(const OverlayPanel& panel) {
  return panel.place == PanelPlace::column && !panel.name.empty() && !panel.other_run;
}
bool in_all(const OverlayPanel& panel) { return !panel.name.empty() && !panel.other_run; }

// The names of those that `fits`, and what `more` says behind each.
template <class Fits, class More>
std::string names(PanelTable table, const Fits& fits, const More& more) {
  std::string out;
  for (const OverlayPanel* panel : table) {
    if (!panel->name.empty() && fits(*panel))
      out += fmt::format("{}{}{}", out.empty() ? "" : ", ", panel->name, more(*panel));
  }
  return out;
}

bool any_panel(const OverlayPanel&) { return true; }
const char* nothing(const OverlayPanel&) { return ""; }

}  // namespace

void OverlayOptions::show(const OverlayPanel& panel) {
  for (std::size_t i = 0; i < table_.size(); ++i) {
    if (table_[i] == &panel) on_[i] = true;
  }
}

void OverlayOptions::show_with(PictureLayer layer) {
  for (std::size_t i = 0; i < table_.size(); ++i) {
    if (table_[i]->layer == layer) on_[i] = true;
  }
}

std::vector<const OverlayPanel*> OverlayOptions::shown() const {
  std::vector<const OverlayPanel*> out;
  for (std::size_t i = 0; i < table_.size(); ++i) {
    if (on_[i]) out.push_back(table_[i]);
  }
  return out;
}

bool OverlayOptions::shows(const OverlayPanel& panel) const {
  const auto all = shown();
  return std::find(all.begin(), all.end(), &panel) != all.end();
}

const OverlayPanel* OverlayOptions::needing(bool OverlayPanel::*need) const {
  for (const OverlayPanel* panel : shown()) {
    if (panel->*need) return panel;
  }
  return nullptr;
}

bool enable_panel(OverlayOptions& options, const std::string& name) {
  bool found = false;
  for (const OverlayPanel* panel : options.table()) {
    const bool meant = name == "plots" ? in_plots(*panel)
                       : name == "all" ? in_all(*panel)
                                       : !name.empty() && name == panel->name;
    if (meant) options.show(*panel);
    found = found || meant;
  }
  return found;
}

std::string panel_names(PanelTable table) { return names(table, any_panel, nothing) + ", plots"; }

std::string panel_help(PanelTable table) {
  return fmt::format("{}, plots ({})",
                     names(table, any_panel,
                           [](const OverlayPanel& panel) { return panel.other_run ? " (with --ab)" : ""; }),
                     names(table, in_plots, nothing));
}

OverlayOptions parse_panels(const std::string& list, PanelTable table) {
  OverlayOptions options(table);
  if (list.empty() || list == "none") return options;
  for (std::size_t i = 0; i <= list.size();) {
    const std::size_t end = std::min(list.find(',', i), list.size());
    const std::string name = list.substr(i, end - i);
    if (!enable_panel(options, name)) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("overlay '{}': no such panel; expected some of {}, or all, none", name,
                              panel_names(table)));
    }
    i = end + 1;
  }
  return options;
}

}  // namespace pabd
