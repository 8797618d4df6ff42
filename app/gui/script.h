// SPDX-License-Identifier: MIT
// Plays a script of actions (scripts.md, script_actions.h). Every action is carried out before the next: results do
// not depend on time. An action that is refused or fails ends the script, unless it has "may_fail": true.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/gui/script_actions.h"
#include "app/gui/viewer.h"
#include "sim/base/output_path.h"

namespace pabd {

struct ScriptOptions {
  std::filesystem::path folder;  // what names of files are relative to; "{out}" in any text means it
  bool force = false;            // replace files
  int width = 1280, height = 720;
  // For a window: called before and after every frame, to take events and to show it. May be empty.
  std::function<void()> before_frame, after_frame;
  std::function<void(const std::string& line)> print;          // gets what "print" says
  InputFiles inputs;                                           // that no frame replaces
  std::function<void(std::size_t number)> before_action = {};  // may be empty
  // Why the window cannot have that size; no text: it can. May be empty.
  std::function<std::string(int width, int height)> refusal_of_window = {};
};

class Script {
 public:
  // Reads and checks every action. Throws Error(bad_input) with number and place.
  Script(const std::string& json, const std::string& source);

  std::size_t size() const { return actions_.size(); }

  // Carries out everything. Throws Error with file, number of the action (from 0) and why: of an expectation
  // that failed with ErrorKind::images_differ, of what was refused with bad_input, of a simulation that
  // diverged with diverged, and so on.
  void run(Viewer& viewer, Runner& runner, const ScriptOptions& options) const;

 private:
  std::vector<nlohmann::ordered_json> actions_;
  std::string source_;
};

// What a script can look at: sessions, view, messages; see the source for its parts.
nlohmann::ordered_json state_document(const Snapshot& sim, const UiState& ui, const GuiLayout& layout);

}  // namespace pabd
