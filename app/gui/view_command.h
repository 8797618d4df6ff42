// What a person does to the view: panels, camera, colours, pictures. None of it changes a simulation. The
// same form as app/workbench/command.h.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "app/workbench/command.h"

namespace pabd {

namespace command {

// Brings a panel to the front ("barrier"), or closes its column.
struct Panel {
  static constexpr const char* name = "panel";
  std::string panel;
  bool on = true;
  void fields(auto&& f) { f("panel", panel), f("on", on, false); }
};
struct Theme {
  static constexpr const char* name = "theme";
  bool dark = true;
  void fields(auto&& f) { f("dark", dark); }
};
// Size of texts and everything else, times what the screen asks for; 0.5 … 4.
struct Scale {
  static constexpr const char* name = "scale";
  double factor = 1;
  void fields(auto&& f) { f("factor", factor); }
};
struct Help {
  static constexpr const char* name = "help";
  bool on = true;
  void fields(auto&& f) { f("on", on, false); }
};
// Only the picture.
struct HideUi {
  static constexpr const char* name = "hide_ui";
  bool on = true;
  void fields(auto&& f) { f("on", on, false); }
};
struct Look {
  static constexpr const char* name = "look";
  std::vector<double> eye, target;  // three numbers each, m
  double fov = 0;                   // degrees; 0: as it is
  void fields(auto&& f) { f("eye", eye), f("target", target), f("fov", fov, false); }
};
// "scene", "iso", "front", "back", "left", "right", "top", "bottom".
struct LookFrom {
  static constexpr const char* name = "look_from";
  std::string view;
  void fields(auto&& f) { f("view", view); }
};
// What is selected fills the view; without a selection everything.
struct FrameSelection {
  static constexpr const char* name = "frame_selection";
  void fields(auto&&) {}
};
// `kind`: "none", "body", "joint", "contact"; `item`: number, or the name of a body or joint. Of a body also
// where, and the normal there: body frame, three numbers each; else its centre.
struct Select {
  static constexpr const char* name = "select";
  std::string kind = "body", item;
  std::vector<double> at = {}, normal = {};
  void fields(auto&& f) {
    f("kind", kind), f("item", item, false), f("at", at, false), f("normal", normal, false);
  }
};
// A joint from where the selected body was picked to the body that is double-clicked next, at the place of
// the click. `type`: "spherical", "hinge", "slider", "fixed", "distance"; "" ends the wait.
struct Join {
  static constexpr const char* name = "join";
  std::string type;
  void fields(auto&& f) { f("type", type); }
};
// "body", "projection" (‖A − R‖), "speed", "energy", "component".
struct ColorBy {
  static constexpr const char* name = "color_by";
  std::string quantity;
  void fields(auto&& f) { f("quantity", quantity); }
};
// What is drawn into the picture: "contacts", "bonds".
struct Show {
  static constexpr const char* name = "show";
  std::string what;
  bool on = true;
  void fields(auto&& f) { f("what", what), f("on", on, false); }
};
// How a second simulation is shown: "ghost" or "side".
struct CompareView {
  static constexpr const char* name = "compare_view";
  std::string how;
  void fields(auto&& f) { f("how", how); }
};
// `quantity`: "value", "slope", "curvature".
struct BarrierView {
  static constexpr const char* name = "barrier_view";
  std::string quantity = "value";
  bool log = false, energy = true, printed = true, onset = false, even = false, log_barrier = false;
  bool histogram = true;
  void fields(auto&& f) {
    f("quantity", quantity, false), f("log", log, false), f("energy", energy, false);
    f("printed", printed, false), f("onset", onset, false), f("even", even, false);
    f("log_barrier", log_barrier, false), f("histogram", histogram, false);
  }
  bool operator==(const BarrierView&) const = default;
};
// `quantity`: "all", "energy_gap", "energy", "residual", "penetration", "joint_error", "projection_change".
struct ConvergenceView {
  static constexpr const char* name = "convergence_view";
  std::string quantity;
  void fields(auto&& f) { f("quantity", quantity); }
};
// `quantity`: "overview", "gap", "penetration", "energies", "joint_error", "contacts", "iterations",
// "milliseconds".
struct SeriesView {
  static constexpr const char* name = "series_view";
  std::string quantity;
  void fields(auto&& f) { f("quantity", quantity); }
};
// What of B − A is plotted: "distance", "gap", "penetration", "energies", "joint_error", "contacts".
struct DifferenceView {
  static constexpr const char* name = "difference_view";
  std::string quantity;
  void fields(auto&& f) { f("quantity", quantity); }
};
// A PNG of the window, or without `ui` of the scene alone, as `pabd render` would draw it. Size 0: that of
// the window.
struct Screenshot {
  static constexpr const char* name = "screenshot";
  std::string path;
  bool ui = true, force = false;
  int width = 0, height = 0;
  void fields(auto&& f) {
    f("path", path), f("ui", ui, false), f("force", force, false);
    f("width", width, false), f("height", height, false);
  }
};
// A video of the past as `pabd render` makes it, with the view's camera, or along the camera keys while
// flying. `from`, `to` in seconds; negative: the first or last moment. `overlay` as for `pabd render`; empty:
// what the view shows.
struct Record {
  static constexpr const char* name = "record";
  std::string path;
  double from = -1, to = -1, fps = 60;
  int width = 1280, height = 720;
  std::string overlay;
  bool force = false;
  void fields(auto&& f) {
    f("path", path), f("from", from, false), f("to", to, false), f("fps", fps, false);
    f("width", width, false), f("height", height, false), f("overlay", overlay, false);
    f("force", force, false);
  }
};
// Ends it: with the frames that are there, or without a file.
struct StopRecord {
  static constexpr const char* name = "stop_record";
  bool keep = true;
  void fields(auto&& f) { f("keep", keep, false); }
};
// The camera as it is becomes a key frame at the present time of the simulation.
struct AddCameraKey {
  static constexpr const char* name = "add_camera_key";
  void fields(auto&&) {}
};
struct DropCameraKey {
  static constexpr const char* name = "drop_camera_key";
  int index = 0;  // in order of time
  void fields(auto&& f) { f("index", index); }
};
struct ClearCameraKeys {
  static constexpr const char* name = "clear_camera_keys";
  void fields(auto&&) {}
};
// The camera follows its keys while time goes on.
struct Fly {
  static constexpr const char* name = "fly";
  bool on = true;
  void fields(auto&& f) { f("on", on, false); }
};
// Camera keys as a file, which `pabd render --camera` takes.
struct SaveCamera {
  static constexpr const char* name = "save_camera";
  std::string path;
  bool force = false;
  void fields(auto&& f) { f("path", path), f("force", force, false); }
};
struct LoadCamera {
  static constexpr const char* name = "load_camera";
  std::string path;
  void fields(auto&& f) { f("path", path); }
};
// What a frame costs, part by part.
struct Costs {
  static constexpr const char* name = "costs";
  bool on = true;
  void fields(auto&& f) { f("on", on, false); }
};
// A dialog that asks for a file name: "open", "save_scene", "save_state", "save_patch", "apply_patch",
// "save_recording", "load_recording", "screenshot", "record", "save_camera", "load_camera"; "" closes it.
// `text`: what it starts with.
struct Ask {
  static constexpr const char* name = "ask";
  std::string what, text = {};
  void fields(auto&& f) { f("what", what), f("text", text, false); }
};
struct CopyCommand {
  static constexpr const char* name = "copy_command";
  void fields(auto&&) {}
};
struct Quit {
  static constexpr const char* name = "quit";
  bool force = false;  // although something is not saved
  void fields(auto&& f) { f("force", force, false); }
};

}  // namespace command

using ViewCommand =
    std::variant<command::Panel, command::Theme, command::Scale, command::Help, command::HideUi,
                 command::Look, command::LookFrom, command::FrameSelection, command::Select, command::Join,
                 command::ColorBy, command::Show, command::CompareView, command::BarrierView,
                 command::ConvergenceView, command::SeriesView, command::DifferenceView, command::Screenshot,
                 command::Record, command::StopRecord, command::AddCameraKey, command::DropCameraKey,
                 command::ClearCameraKeys, command::Fly, command::SaveCamera, command::LoadCamera,
                 command::Costs, command::Ask, command::CopyCommand, command::Quit>;

}  // namespace pabd
