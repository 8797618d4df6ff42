// A script of actions: commands of the simulation and of the view, events as a person makes them, frames to
// write, and what is expected of the state then. A JSON list, or an object with "actions":
//
//   {"do": "set", "key": "contact.kappa", "value": 50}     any command (workbench/command.h, view_command.h)
//   {"do": "key", "key": "space"}                          pressed and released; "hold", "release" for one of
//   them
//   {"do": "mouse", "at": [640, 360]}                      moved there; "press", "release", "click",
//   "double_click"
//                                                          with "button", "to": dragged there; "wheel":
//                                                          notches
//   {"do": "type", "text": "12.5"}
//   {"do": "window", "size": [1280, 720], "scale": 1}
//   {"do": "frame", "path": "panel.png"}                   draws, and writes what is seen, or a part of it:
//                                                          "of": "left", "right_top", "right_bottom",
//                                                          "picture", …
//   {"do": "expect", "at": "/a/step", "is": 10}            also "near" with "within", "above", "below",
//   "contains"
//   {"do": "wait", "frames": 3}, {"do": "until", "at": "/a/step", "above": 50}
//
// Every action is carried out before the next: results do not depend on time.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/gui/viewer.h"
#include "sim/base/output_path.h"

namespace pabd {

struct ScriptOptions {
  std::filesystem::path folder;  // what paths of frames are relative to; "{out}" in any text means it
  bool force = false;            // replace files
  int width = 1280, height = 720;
  // For a window: called before and after every frame, to take events and to show it. May be empty.
  std::function<void()> before_frame, after_frame;
  InputFiles inputs;  // that no frame replaces
};

class Script {
 public:
  // Reads and checks every action. Throws Error(bad_input) with number and place.
  Script(const std::string& json, const std::string& source);

  std::size_t size() const { return actions_.size(); }

  // Carries out everything. Throws Error: of an expectation that failed with ExitCode::images_differ,
  // whatever an action threw else.
  void run(Viewer& viewer, Runner& runner, const ScriptOptions& options) const;

 private:
  std::vector<nlohmann::ordered_json> actions_;
  std::string source_;
};

// Every action with its fields, a line each, for people.
std::string action_list();

// What a script can look at: sessions, view, messages; see the source for its parts.
nlohmann::ordered_json state_document(const Snapshot& sim, const UiState& ui);

}  // namespace pabd
