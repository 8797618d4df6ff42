// SPDX-License-Identifier: MIT
// Everything a person can do, as data. Panels and keys send commands, script files hold them, and both go the
// same way. In a script a command is an object whose "do" is its name: {"do": "set", "key": "contact.kappa",
// "value": 50}.
//
// Each struct lists its name and its fields once, each with its meaning, unit and an example; reading,
// writing and explaining their JSON follow from that (command_json.h).
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "sim/base/error.h"
#include "sim/solver/parameter_table.h"

namespace pabd {

// Which of two simulations side by side: "a", or "b" while there is one.
enum class Side : std::uint8_t { a, b };

namespace command {

// A word that a field takes.
struct Choice {
  const char* name;             // in commands and settings
  const char* label = nullptr;  // in lists, rich text; null: the name
  const char* help = nullptr;   // null: none
};
// A field as it is written in a script. Its type is that of the member.
struct Field {
  const char* name;
  const char* help;     // what it means, with its unit
  const char* example;  // as JSON
  bool required = true;
  std::span<const Choice> choices = {};  // of a text; empty: any
};
constexpr Field need(const char* name, const char* help, const char* example) {
  return {name, help, example};
}
constexpr Field may(const char* name, const char* help, const char* example) {
  return {name, help, example, false};
}
// A text that is one of these; `help` says more than the words.
constexpr Field need(const char* name, std::span<const Choice> choices, const char* example,
                     const char* help = "") {
  return {name, help, example, true, choices};
}
constexpr Field may(const char* name, std::span<const Choice> choices, const char* example,
                    const char* help = "") {
  return {name, help, example, false, choices};
}
// Fields that many commands have.
inline constexpr Field kSide = may("side", "which simulation", R"("b")");
inline constexpr Field kForce = may("force", "replace a file that exists", "true");
inline constexpr Field kGiveUp = may("force", "although something that was made here would be gone", "true");
inline constexpr Field kOn = may("on", "or off", "false");

// A command without fields.
template <std::size_t length>
struct Text {
  constexpr Text(const char (&text)[length]) { std::copy_n(text, length, characters); }
  char characters[length];
};
template <Text text>
struct Plain {
  static constexpr const char* name = text.characters;
  void fields(auto&&) {}
};

// ---- parameters (keys and values as for --set) ----
// A value as a person writes it, or as a slider has it.
using SetValue = std::variant<std::string, ParameterValue>;
struct Set {
  static constexpr const char* name = "set";
  std::string key;
  SetValue value;
  Side side = Side::a;
  bool more = false;  // goes on with the last change of that key, as a slider does: one step of undo
  void fields(auto&& f) {
    f(need("key", "parameter, as for --set; of B also of its joints: joints_default.kappa",
           R"("contact.kappa")"),
      key);
    f(need("value", "number, list or word, in the unit of the parameter", "50"), value);
    f(kSide, side);
    f(may("more", "goes on with the last change of that key: one step of undo", "true"), more);
  }
};
// Several at once; one step of undo.
struct SetAll {
  static constexpr const char* name = "set_all";
  std::vector<std::string> values;  // "key=value"
  Side side = Side::a;
  void fields(auto&& f) {
    f(need("values", "KEY=VALUE, as for --set", R"(["contact.kappa=50", "contact.N=4"])"), values);
    f(kSide, side);
  }
};
// Back to what the scene file says; an empty key means all.
struct ResetParams {
  static constexpr const char* name = "reset_params";
  std::string key;
  Side side = Side::a;
  void fields(auto&& f) {
    f(may("key", "parameter; without: all of them", R"("contact.kappa")"), key);
    f(kSide, side);
  }
};
struct Undo : Plain<"undo"> {};
struct Redo : Plain<"redo"> {};

// ---- time ----
struct Play : Plain<"play"> {};
struct Pause : Plain<"pause"> {};
// Forward (negative: back) by steps.
struct Step {
  static constexpr const char* name = "step";
  int steps = 1;
  void fields(auto&& f) { f(may("steps", "time steps; negative: back", "60"), steps); }
};
struct Seek {
  static constexpr const char* name = "seek";
  double time = 0;  // s
  void fields(auto&& f) { f(need("time", "simulated time, s", "0.5"), time); }
};
// Simulated seconds a second; 0: as fast as it goes.
struct Speed {
  static constexpr const char* name = "speed";
  double factor = 1;
  void fields(auto&& f) {
    f(need("factor", "simulated seconds a second, 0 to 1000; 0: as fast as it goes", "0.25"), factor);
  }
};
// From the beginning, with the present parameters.
struct Restart : Plain<"restart"> {};

// ---- hands ----
// Bodies or joints added or removed, here and now. `edit` is an object as in app/session/model_edit.h:
// {"do": "edit", "edit": {"do": "remove_body", "body": 3}}.
struct Edit {
  static constexpr const char* name = "edit";
  std::string edit;
  void fields(auto&& f) {
    f(need("edit", "what is added or removed, with keys and units of a scene file",
           R"({"do": "remove_body", "body": 1})"),
      edit);
  }
};
// A hand on a body, until it lets go: a soft spring from `target` to `point` of the body.
struct Pull {
  static constexpr const char* name = "pull";
  int body = 0;
  std::vector<double> point, target;  // three numbers each: body frame, world; m
  double kappa = 0;                   // N/m; 0: as swings the body alone at 2 Hz
  void fields(auto&& f) {
    f(need("body", "its number", "1"), body);
    f(need("point", "where it is held: body frame, m", "[0, 0.5, 0]"), point);
    f(need("target", "where the hand is: world, m", "[1, 2, 0]"), target);
    f(may("kappa", "stiffness, N/m; 0: as swings the body alone at 2 Hz", "500"), kappa);
  }
};
struct Release : Plain<"release"> {};
// A ball.
struct Shoot {
  static constexpr const char* name = "shoot";
  std::vector<double> from, direction;  // three numbers each: where its centre starts, m; of any length
  double speed = 10;                    // m/s
  double radius = 0.2;                  // m
  double density = 1000;                // kg/m³
  void fields(auto&& f) {
    f(need("from", "where its centre starts: world, m", "[0, 2, 8]"), from);
    f(need("direction", "of any length but 0", "[0, 0, -1]"), direction);
    f(may("speed", "m/s", "10"), speed);
    f(may("radius", "m", "0.2"), radius);
    f(may("density", "kg/m³", "1000"), density);
  }
};

// ---- comparing ----
// A second simulation in step with the first, from here on; `values` is how its parameters differ, also the law of its
// joints ("joints_default.kappa=50").
struct Compare {
  static constexpr const char* name = "compare";
  std::vector<std::string> values;
  void fields(auto&& f) {
    f(may("values", "how its parameters and the law of its joints differ: KEY=VALUE, as for --set",
          R"(["contact.N=6", "joints_default.kappa=500"])"),
      values);
  }
};
struct EndCompare : Plain<"end_compare"> {};
// Keeps the convergence of the present step, as that method makes it (empty: as it was made).
struct Hold {
  static constexpr const char* name = "hold";
  std::string method;
  void fields(auto&& f) {
    f(may("method", "as for solver.method, of the same step; without: as it was made", R"("sissm")"), method);
  }
};
struct DropHeld : Plain<"drop_held"> {};
// A message, in place of those that others send.
struct Tell {
  static constexpr const char* name = "tell";
  std::string text;
  bool error = false;
  std::string about = {};                 // not in scripts: what it answers
  ErrorKind kind = ErrorKind::bad_input;  // not in scripts: of an error
  void fields(auto&& f) {
    f(need("text", "what is said", R"("half way")"), text);
    f(may("error", "as something that went wrong", "false"), error);
  }
};
// What is recorded of later steps: only what somebody looks at.
struct Observe {
  static constexpr const char* name = "observe";
  bool iterations = true, contacts = true, bodies = false, states = true;
  bool operator==(const Observe&) const = default;
  void fields(auto&& f) {
    f(need("iterations", "every iteration of a step", "true"), iterations);
    f(need("contacts", "every contact", "true"), contacts);
    f(may("bodies", "every body", "true"), bodies);
    f(may("states", "where bodies are while it plays; else the GPU that makes the steps may keep them",
          "true"),
      states);
  }
};

// ---- files ----
struct Load {
  static constexpr const char* name = "load";
  std::string scene;              // file, or name of a shipped scene
  std::vector<std::string> sets;  // "key=value"
  bool force = false;             // although something is not saved
  std::string from = {};          // file of another state to begin with
  void fields(auto&& f) {
    f(need("scene", "file, or name of a shipped scene", R"("two_boxes")"), scene);
    f(may("sets", "KEY=VALUE, as for --set", R"(["contact.N=4"])"), sets);
    f(kGiveUp, force);
    f(may("from", "file of a state to begin with, as 'pabd run --state' writes it", R"("end.json")"), from);
  }
};
// The scene's file again, with the parameters that were changed here, B and the held curves.
struct Reload {
  static constexpr const char* name = "reload";
  bool force = false;  // although the timeline and what was done to bodies and joints is gone then
  void fields(auto&& f) { f(kGiveUp, force); }
};
// The scene stays as it is although its file changed; asked again when that changes again.
struct IgnoreFile : Plain<"ignore_file"> {};
// The scene's file with the present parameters; with `state` the bodies as they are now.
struct SaveScene {
  static constexpr const char* name = "save_scene";
  std::string path;
  bool state = false, force = false;
  Side side = Side::a;
  void fields(auto&& f) {
    f(need("path", "file", R"("tuned.json")"), path);
    f(may("state", "with the bodies and joints as they are now", "true"), state);
    f(kForce, force);
    f(kSide, side);
  }
};
// Only what differs from the scene, as a JSON merge patch.
struct SavePatch {
  static constexpr const char* name = "save_patch";
  std::string path;
  bool force = false;
  Side side = Side::a;
  void fields(auto&& f) {
    f(need("path", "file", R"("patch.json")"), path);
    f(kForce, force);
    f(kSide, side);
  }
};
struct ApplyPatch {
  static constexpr const char* name = "apply_patch";
  std::string path;
  Side side = Side::a;
  void fields(auto&& f) {
    f(need("path", "file", R"("patch.json")"), path);
    f(kSide, side);
  }
};

// The timeline of A as a file, and back: only for the same scene.
struct SaveRecording {
  static constexpr const char* name = "save_recording";
  std::string path;
  bool force = false;
  void fields(auto&& f) {
    f(need("path", "file", R"("run.pabdrec")"), path);
    f(kForce, force);
  }
};
struct LoadRecording {
  static constexpr const char* name = "load_recording";
  std::string path;
  bool force = false;  // although something is not saved
  void fields(auto&& f) {
    f(need("path", "file", R"("run.pabdrec")"), path);
    f(kGiveUp, force);
  }
};

}  // namespace command

// What the Workbench carries out.
using Command =
    std::variant<command::Set, command::SetAll, command::ResetParams, command::Undo, command::Redo,
                 command::Play, command::Pause, command::Step, command::Seek, command::Speed,
                 command::Restart, command::Edit, command::Pull, command::Release, command::Shoot,
                 command::Compare, command::EndCompare, command::Hold, command::DropHeld, command::Observe,
                 command::Tell, command::Load, command::Reload, command::IgnoreFile, command::SaveScene,
                 command::SavePatch, command::ApplyPatch, command::SaveRecording, command::LoadRecording>;

}  // namespace pabd
