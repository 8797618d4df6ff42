// SPDX-License-Identifier: MIT
// What the window offers to choose from, by name: one list of each for scripts, menus, plots, settings and messages.
#pragma once

#include <string_view>
#include <vector>

#include "app/gui/window_panel.h"
#include "app/overlay/body_colors.h"
#include "app/plots/figures/quantity_plot.h"
#include "app/workbench/command.h"
#include "render/visual/build_visual.h"
#include "render/visual/picture_marks.h"
#include "render/visual/picture_theme.h"
#include "sim/body/joint.h"

namespace pabd {

using command::Choice;

inline const char* label_of(const Choice& choice) { return choice.label ? choice.label : choice.name; }

// The place of a word in a list; 0 where it is not in it.
inline std::size_t place_in(std::span<const Choice> choices, std::string_view name) {
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (name == choices[i].name) return i;
  }
  return 0;
}

inline constexpr Choice kLookFrom[] = {{"scene", "as the scene says"}, {"front", "from the front"},
                                       {"right", "from the right"},    {"top", "from above"},
                                       {"iso", "at an angle"},         {"back", "from the back"},
                                       {"left", "from the left"},      {"bottom", "from below"}};
// As Selection::Kind and ColorQuantity.
inline constexpr Choice kSelectionKinds[] = {{"none"}, {"body"}, {"joint"}, {"contact"}};
inline constexpr Choice kColors[] = {{kColorNames[0], "body", "tell bodies apart"},
                                     {kColorNames[1], "‖A − R‖"},
                                     {kColorNames[2]},
                                     {kColorNames[3]},
                                     {kColorNames[4], "component", "connected components"},
                                     {kColorNames[5], nullptr, "residual, where steps end unsolved"}};
static_assert(std::size(kColors) == std::size(kColorNames));
inline constexpr Choice kContactColors[] = {
    {kContactQuantities[0], nullptr, "gap, d/d̂"},
    {kContactQuantities[1], nullptr, "normal force, as bars along which loads go"},
    {kContactQuantities[2], nullptr, "the used part of the largest friction"}};
inline constexpr Choice kCompareViews[] = {{"ghost"}, {"side"}};
constexpr const char* slot_words(Slot slot) {
  constexpr const char* kWords[] = {"panels at the left", "panels top right", "panels bottom right"};
  return kWords[static_cast<std::size_t>(slot)];
}
inline constexpr Choice kBorders[] = {{"left"}, {"right"}, {"upper"}, {"below"}};  // as Border
static_assert(std::size(kBorders) == kBorderCount);
inline constexpr Choice kRunPlaces[] = {{"start"}, {"end"}};

// What panels plot, in the order of BarrierQuantity, BarrierAbscissa, ConvergenceQuantity and TimeQuantity (both after
// the first) and DifferenceQuantity.
inline constexpr Choice kBarrierQuantities[] = {
    {"value", "Ψ", "The potential: energy of a contact at distance d"},
    {"slope", "Ψ′", "Its slope: minus the normal force"},
    {"curvature", "Ψ″", "Its curvature: how stiff a contact is"}};
inline constexpr Choice kBarrierAbscissas[] = {{"d"}, {"d_hat", "d̂"}, {"N"}, {"kappa", "κ"}};
inline constexpr Choice kConvergenceViews[] = {
    {"all", "all in one"}, {"energy_gap", "E − E_end"},    {"energy", "energy E"},          {"residual"},
    {"penetration"},       {"joint_error", "joint error"}, {"projection_change", "‖A − R‖"}};
inline constexpr const char* kChosenSeries = "chosen";  // UiState::series_y against series_x
inline constexpr Choice kSeriesViews[] = {{"overview"},
                                          {"gap"},
                                          {"penetration"},
                                          {"energies"},
                                          {"joint_error", "joint error"},
                                          {"contacts"},
                                          {"iterations"},
                                          {"milliseconds", "ms a step"},
                                          {kChosenSeries, "y against x"}};
inline constexpr Choice kDifferenceViews[] = {
    {"distance"}, {"gap"}, {"penetration"}, {"energies"}, {"joint_error", "joint error"}, {"contacts"}};
inline constexpr Choice kPlottingPanels[] = {{"barrier"}, {"convergence"}, {"series"}};

// A dialog: it asks for the name of a file that is read or written, or whether something may be lost.
struct DialogKind {
  enum Use : std::uint8_t { reads, writes, asks };
  const char* name;
  Use use;
  const char *title, *help, *button;
  const char* first = nullptr;    // the name to begin with, after the scene's own; null: none
  const char* endings = ".json";  // of the files that it lists
};
inline constexpr DialogKind kDialogs[] = {
    {"open", DialogKind::reads, "Open a scene", "A scene file, or the name of a shipped scene", "Open"},
    {"save_scene", DialogKind::writes, "Save scene",
     "The scene file with the present parameters; bodies as at its beginning", "Save", "_tuned.json"},
    {"save_state", DialogKind::writes, "Save state",
     "A scene file that starts with the bodies and joints as they are now", "Save", "_state.json"},
    {"save_patch", DialogKind::writes, "Save patch", "Only the parameters that differ from the scene", "Save",
     "_patch.json"},
    {"apply_patch", DialogKind::reads, "Apply patch", "A patch file: parameters of this or another scene",
     "Apply"},
    {"save_recording", DialogKind::writes, "Save recording",
     "The whole timeline: steps, hands, edits; for this scene", "Save", ".pabdrec", ".pabdrec"},
    {"load_recording", DialogKind::reads, "Load recording",
     "A recording of this scene; it replaces the timeline", "Load", ".pabdrec", ".pabdrec"},
    {"screenshot", DialogKind::writes, "Screenshot", "A PNG file", "Save", ".png", ".png"},
    {"record", DialogKind::writes, "Video",
     ".mp4, .webm or .gif; or a folder/{frame:04}.png for one picture a frame", "Record", ".mp4",
     ".mp4 .webm .gif .png"},
    {"save_camera", DialogKind::writes, "Save camera keys", "A file that 'pabd render --camera' takes",
     "Save", "_camera.json"},
    {"load_camera", DialogKind::reads, "Load camera keys", "A file of camera keys", "Load"},
    {"open_sweep", DialogKind::reads, "Open a sweep", "The folder that 'pabd sweep' made", "Open", nullptr,
     ""},
    {"load_run", DialogKind::asks, "Load this run from its start?", "", "Load all the same"},
    {"load_end", DialogKind::asks, "Load this run as it ended?", "", "Load all the same"},
    {"reload", DialogKind::asks, "Load the file again?", "Parameters that were changed here stay.",
     "Load again"},
    {"clear_camera", DialogKind::asks, "Remove all camera keys?", "", "Remove all"},
    {"quit", DialogKind::asks, "Leave?", "", "Leave without saving"}};

// Lists that follow from other tables.
using Choices = const std::vector<Choice>&;
template <class Table, class Row>
std::vector<Choice> choices_from(const Table& table, const Row& choice, std::vector<Choice> out = {}) {
  for (const auto& row : table) out.push_back(choice(row));
  return out;
}
inline Choices panel_choices() {
  static const auto out = choices_from(window_panels(), [](auto* panel) { return Choice{panel->name}; });
  return out;
}
inline Choices dialog_choices() {
  static const auto out = choices_from(kDialogs, [](auto& kind) { return Choice{kind.name}; }, {{""}});
  return out;
}
inline Choices joint_choices() {  // and none
#define PABD_WORD(name) {#name},
  static const std::vector<Choice> out{PABD_JOINT_TYPES(PABD_WORD){""}};
#undef PABD_WORD
  return out;
}
inline Choices mark_choices() {  // of the picture
  static const auto out = choices_from(picture_marks(),
                                       [](auto& mark) {
                                         return Choice{mark.name.data(), nullptr, mark.help.data()};
                                       },
                                       {{"contacts"}, {"bonds"}});
  return out;
}
inline constexpr Choice kBackgrounds[] = {{"studio"}, {"dark"}, {"paper"}};  // as picture_themes()
inline Choices quantity_choices() {                                          // of a step
  static const auto out = choices_from(step_quantities(), [](auto& quantity) {
    return Choice{quantity.key, quantity.words};
  });
  return out;
}

}  // namespace pabd
