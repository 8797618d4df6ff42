// SPDX-License-Identifier: MIT
// What the Workbench shows of itself: a copy that other threads may keep as long as they like.
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

// Something to tell a person, in place, in one line.
struct Message {
  std::uint64_t number = 0;  // rises
  Severity severity = Severity::note;
  std::string text;
  std::string about = {};                 // name of the command that it answers; empty: of none
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

// One of the simulations. Its parameters are those of the next step, its history has all moments of the
// timeline: also those after this one.
struct RunView : FrameView {
  // What it goes on with: of B with the law of its own joints (run.h, continue_as). Never null.
  std::shared_ptr<const Scene> scene;
  std::size_t cursor = 0;  // which moment this is
  Params made_with;        // parameters of the step that led here
  std::size_t alike = 0;  // of the last steps up to it, those made with the same, as far as advice looks back
  DeviceStatus device;    // who makes the next step
  std::size_t gone = 0;   // moments of the history that cannot be gone to (Timeline::gone)
  // Keys that differ from the scene, with their value, also of its joints' law (joint_settings.h).
  std::vector<std::pair<std::string, std::string>> changed;
  std::vector<Pull> pulls;  // hands on bodies in the next step
  // Of the run that the last branch left, if there is one.
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
  std::uint64_t jumps = 0;                  // rises when A goes elsewhere than by steps
  bool playing = false;
  double speed = 1;             // asked for
  double real_time_factor = 0;  // simulated seconds a second of late; 0 when not playing
  bool diverged = false;        // the step after this state left the numbers
  bool unsaved = false;         // something was made since the scene was loaded or saved
  // In words, what a person made that would be gone with another scene, or with the scene's file loaded
  // again.
  std::vector<std::string> at_stake, reload_loses;
  bool file_changed = false;  // the scene's file is another one than when it was loaded
  bool can_undo = false, can_redo = false;
  std::string undo_text, redo_text;  // "contact.kappa"
  std::vector<HeldCurve> held;
  std::vector<Message> messages;  // the latest few, oldest first
  std::size_t timeline_bytes = 0, timeline_budget = 0, forgotten = 0;
};

// "a, b and c".
std::string listed(const std::vector<std::string>& words);

}  // namespace pabd
