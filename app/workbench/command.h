// Everything a person can do, as data. Panels and keys send commands, script files hold them, and both go the
// same way. In a script a command is an object whose "do" is its name: {"do": "set", "key": "contact.kappa",
// "value": 50}.
//
// Each struct lists its name and its fields once; reading and writing JSON follow from that
// (command_json.h).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace pabd {

// Which of two simulations side by side: "a", or "b" while there is one.
enum class Side : std::uint8_t { a, b };

namespace command {

// ---- parameters (keys and values as for --set) ----
struct Set {
  static constexpr const char* name = "set";
  std::string key, value;
  Side side = Side::a;
  bool more = false;  // goes on with the last change of that key, as a slider does: one step of undo
  void fields(auto&& f) { f("key", key), f("value", value), f("side", side, false), f("more", more, false); }
};
// Several at once; one step of undo.
struct SetAll {
  static constexpr const char* name = "set_all";
  std::vector<std::string> values;  // "key=value"
  Side side = Side::a;
  void fields(auto&& f) { f("values", values), f("side", side, false); }
};
// Back to what the scene file says; an empty key means all.
struct ResetParams {
  static constexpr const char* name = "reset_params";
  std::string key;
  Side side = Side::a;
  void fields(auto&& f) { f("key", key, false), f("side", side, false); }
};
struct Undo {
  static constexpr const char* name = "undo";
  void fields(auto&&) {}
};
struct Redo {
  static constexpr const char* name = "redo";
  void fields(auto&&) {}
};

// ---- time ----
struct Play {
  static constexpr const char* name = "play";
  void fields(auto&&) {}
};
struct Pause {
  static constexpr const char* name = "pause";
  void fields(auto&&) {}
};
// Forward (negative: back) by steps.
struct Step {
  static constexpr const char* name = "step";
  int steps = 1;
  void fields(auto&& f) { f("steps", steps, false); }
};
struct Seek {
  static constexpr const char* name = "seek";
  double time = 0;  // s
  void fields(auto&& f) { f("time", time); }
};
// Simulated seconds a second; 0: as fast as it goes.
struct Speed {
  static constexpr const char* name = "speed";
  double factor = 1;
  void fields(auto&& f) { f("factor", factor); }
};
// From the beginning, with the present parameters.
struct Restart {
  static constexpr const char* name = "restart";
  void fields(auto&&) {}
};

// ---- hands ----
// Bodies or joints added or removed, here and now. `edit` is an object as in app/session/model_edit.h:
// {"do": "edit", "edit": {"do": "remove_body", "body": 3}}.
struct Edit {
  static constexpr const char* name = "edit";
  std::string edit;
  void fields(auto&& f) { f("edit", edit); }
};
// A hand on a body, until it lets go: a soft spring from `target` to `point` of the body.
struct Pull {
  static constexpr const char* name = "pull";
  int body = 0;
  std::vector<double> point, target;  // three numbers each: body frame, world; m
  double kappa = 0;                   // N/m; 0: as swings the body alone at 2 Hz
  void fields(auto&& f) { f("body", body), f("point", point), f("target", target), f("kappa", kappa, false); }
};
struct Release {
  static constexpr const char* name = "release";
  void fields(auto&&) {}
};
// A ball.
struct Shoot {
  static constexpr const char* name = "shoot";
  std::vector<double> from, direction;  // three numbers each: where its centre starts, m; of any length
  double speed = 10;                    // m/s
  double radius = 0.2;                  // m
  double density = 1000;                // kg/m³
  void fields(auto&& f) {
    f("from", from), f("direction", direction), f("speed", speed, false), f("radius", radius, false);
    f("density", density, false);
  }
};

// ---- comparing ----
// A second simulation in step with the first, from here on; `values` is how its parameters differ.
struct Compare {
  static constexpr const char* name = "compare";
  std::vector<std::string> values;
  void fields(auto&& f) { f("values", values, false); }
};
struct EndCompare {
  static constexpr const char* name = "end_compare";
  void fields(auto&&) {}
};
// Keeps the convergence of the present step, as that method makes it (empty: as it was made).
struct Hold {
  static constexpr const char* name = "hold";
  std::string method;
  void fields(auto&& f) { f("method", method, false); }
};
struct DropHeld {
  static constexpr const char* name = "drop_held";
  void fields(auto&&) {}
};
// A message, in place of those that others send.
struct Tell {
  static constexpr const char* name = "tell";
  std::string text;
  bool error = false;
  void fields(auto&& f) { f("text", text), f("error", error, false); }
};
// What is recorded of later steps: only what somebody looks at.
struct Observe {
  static constexpr const char* name = "observe";
  bool iterations = true, contacts = true, bodies = false;
  void fields(auto&& f) { f("iterations", iterations), f("contacts", contacts), f("bodies", bodies, false); }
};

// ---- files ----
struct Load {
  static constexpr const char* name = "load";
  std::string scene;              // file, or name of a shipped scene
  std::vector<std::string> sets;  // "key=value"
  bool force = false;             // although something is not saved
  void fields(auto&& f) { f("scene", scene), f("sets", sets, false), f("force", force, false); }
};
// The scene's file again, with the parameters that were changed here.
struct Reload {
  static constexpr const char* name = "reload";
  void fields(auto&&) {}
};
// The scene's file with the present parameters; with `state` the bodies as they are now.
struct SaveScene {
  static constexpr const char* name = "save_scene";
  std::string path;
  bool state = false, force = false;
  Side side = Side::a;
  void fields(auto&& f) {
    f("path", path), f("state", state, false), f("force", force, false), f("side", side, false);
  }
};
// Only what differs from the scene, as a JSON merge patch.
struct SavePatch {
  static constexpr const char* name = "save_patch";
  std::string path;
  bool force = false;
  Side side = Side::a;
  void fields(auto&& f) { f("path", path), f("force", force, false), f("side", side, false); }
};
struct ApplyPatch {
  static constexpr const char* name = "apply_patch";
  std::string path;
  Side side = Side::a;
  void fields(auto&& f) { f("path", path), f("side", side, false); }
};

// The timeline of A as a file, and back: only for the same scene.
struct SaveRecording {
  static constexpr const char* name = "save_recording";
  std::string path;
  bool force = false;
  void fields(auto&& f) { f("path", path), f("force", force, false); }
};
struct LoadRecording {
  static constexpr const char* name = "load_recording";
  std::string path;
  bool force = false;  // although something is not saved
  void fields(auto&& f) { f("path", path), f("force", force, false); }
};

}  // namespace command

// What the Workbench carries out.
using Command =
    std::variant<command::Set, command::SetAll, command::ResetParams, command::Undo, command::Redo,
                 command::Play, command::Pause, command::Step, command::Seek, command::Speed,
                 command::Restart, command::Edit, command::Pull, command::Release, command::Shoot,
                 command::Compare, command::EndCompare, command::Hold, command::DropHeld, command::Observe,
                 command::Tell, command::Load, command::Reload, command::SaveScene, command::SavePatch,
                 command::ApplyPatch, command::SaveRecording, command::LoadRecording>;

}  // namespace pabd
