// SPDX-License-Identifier: MIT
// The table of panels: their names, places, and what they need. A new one is its file and a line here.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

// clang-format off
// In the order of their tabs.
#define PABD_WINDOW_PANELS(X) \
  X(parameters) \
  X(inspector) \
  X(scenes) \
  X(sweep) \
  X(barrier) \
  X(convergence) \
  X(series) \
  X(compare)
// clang-format on

namespace pabd {

class GuiPanel;
struct UiState;

// Places for panels; each shows one of its panels.
enum class Slot : std::uint8_t { left, right_top, right_bottom };
inline constexpr Slot kSlots[] = {Slot::left, Slot::right_top, Slot::right_bottom};
constexpr std::string_view slot_name(Slot slot) {
  constexpr std::string_view kNames[] = {"left", "right_top", "right_bottom"};
  return kNames[static_cast<std::size_t>(slot)];
}

// One of each slot.
template <class T>
struct BySlot {
  std::array<T, std::size(kSlots)> of{};

  T& operator[](Slot slot) { return of[static_cast<std::size_t>(slot)]; }
  const T& operator[](Slot slot) const { return of[static_cast<std::size_t>(slot)]; }
  bool operator==(const BySlot&) const = default;
};

// Borders of the panels that a person drags, by what is larger then: the columns at the left and at the right of the
// picture, the upper one of two panels, all that is below the picture.
enum class Border : std::uint8_t { left, right, upper, below };
inline constexpr std::size_t kBorderCount = 4;
// Pixels of an ordinary screen; of `upper` and `below` parts of the height. 0: what suits the window.
struct PanelSizes {
  std::array<double, kBorderCount> of{};

  double& operator[](Border border) { return of[static_cast<std::size_t>(border)]; }
  double operator[](Border border) const { return of[static_cast<std::size_t>(border)]; }
  bool operator==(const PanelSizes&) const = default;
};
// What may be asked for.
struct SizeRange {
  double least, most;
};
constexpr SizeRange size_range(Border border) {
  return border == Border::left || border == Border::right ? SizeRange{200, 4000} : SizeRange{0.1, 0.9};
}

struct WindowPanel {
  const char* name;   // "barrier": in commands and settings
  const char* title;  // of its tab, UTF-8
  const char* help;   // one line under the mouse
  Slot slot;
  std::unique_ptr<GuiPanel> (*make)();
  bool iterations = false;                       // while it is seen the iterations of a step are recorded,
  bool contacts = false;                         // the contacts
  bool (*offered)(const UiState& ui) = nullptr;  // whether it has a tab while it is not shown; null: always
};

// parameters_tab, inspector_tab, …
#define PABD_DECLARE(name) extern const WindowPanel name##_tab;
PABD_WINDOW_PANELS(PABD_DECLARE)
#undef PABD_DECLARE

using WindowPanelTable = std::span<const WindowPanel* const>;

inline WindowPanelTable window_panels() {
#define PABD_ROW(name) &name##_tab,
  static constexpr const WindowPanel* kPanels[] = {PABD_WINDOW_PANELS(PABD_ROW)};
#undef PABD_ROW
  return kPanels;
}

// The tabs of a slot.
std::vector<const WindowPanel*> panels_of(Slot slot, WindowPanelTable table = window_panels());

// By name. Throws Error(bad_input) with the names.
const WindowPanel& find_panel(std::string_view name, WindowPanelTable table = window_panels());

// The names in words: "parameters, inspector, … or compare".
std::string panel_words(WindowPanelTable table = window_panels());

}  // namespace pabd
