// SPDX-License-Identifier: MIT
// What the Workbench shows of itself: a copy that other threads may keep.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/session/run.h"
#include "app/workbench/command.h"
#include "sim/base/error.h"
#include "sim/scene/scene.h"

namespace pabd {

enum class Severity : std::uint8_t { note, warning, error };

// A line for the person at the desk.
struct Message {
  std::uint64_t number = 0;  // rises
  Severity severity = Severity::note;
  std::string text;
  std::string about = {};                 // name of the command that it answers, if any
  ErrorKind kind = ErrorKind::bad_input;  // of an error
};

struct HeldCurve {
  std::string name;  // method and step
  std::int64_t step = 0;
  std::shared_ptr<const std::vector<IterationRecord>> records;  // never null
  int softened = 0;                                             // MethodRun::softened
};

// How far two runs are apart: largest distance between the places of a body.
struct RunDistance {
  double time, position;  // s, m
};

// One of the simulations. `params` are those of the next step; `history` has all moments of the timeline, also later ones.
struct RunView : FrameView {
  // Never null; of B with the law of its own joints (Run::continue_as).
  std::shared_ptr<const Scene> scene;
  std::size_t cursor = 0;  // which moment this is
  Params made_with;        // parameters of the step that led here
  std::size_t alike = 0;   // how many of the last steps were made with these (at most kStepsLookedAt)
  DeviceStatus device;     // who makes the next step
  std::size_t gone = 0;    // moments whose state is not known (Timeline::gone)
  // Keys that differ from the scene, with their value, also of its joints' law (joint_settings.h).
  std::vector<std::pair<std::string, std::string>> changed;
  std::vector<Pull> pulls;  // hands on bodies in the next step
  // The future that the last branch left, if any, and where the two part.
  std::optional<Reports> left;
  std::optional<Parting> parting;
};

struct Snapshot {
  std::uint64_t serial = 0;        // rises with every snapshot
  std::uint64_t scene_serial = 0;  // rises with every scene that is loaded
  std::shared_ptr<const Scene> scene;
  std::string scene_path;               // file; empty when it came from elsewhere
  std::vector<std::string> scene_sets;  // "key=value" that it was loaded with
  RunView a;
  std::optional<RunView> b;
  SharedList<RunDistance>::View distances;  // of A and B at common times
  std::uint64_t jumps = 0;                  // rises when A goes to another moment than the next
  bool playing = false;
  double speed = 1;             // asked for
  double real_time_factor = 0;  // recent simulated seconds a second; 0 when not playing
  bool diverged = false;        // the step after this state diverged
  bool unsaved = false;         // something was made since the scene was loaded or saved
  // In words: what a person made that another scene, or loading the scene's file again, would discard.
  std::vector<std::string> at_stake, reload_loses;
  bool file_changed = false;  // the scene's file changed since it was loaded
  bool can_undo = false, can_redo = false;
  std::string undo_text, redo_text;  // "contact.kappa"
  std::vector<HeldCurve> held;
  std::vector<Message> messages;  // the latest few, oldest first
  std::size_t timeline_bytes = 0, timeline_budget = 0, forgotten = 0;
};

// "a, b and c".
std::string listed(const std::vector<std::string>& words);

}  // namespace pabd
