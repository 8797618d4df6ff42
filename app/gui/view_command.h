// SPDX-License-Identifier: MIT
// What a person does to the view: panels, camera, colours, pictures. None of it changes a simulation. The
// same form as app/workbench/command.h.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "app/gui/sweep_commands.h"
#include "app/gui/window_panel.h"
#include "app/plots/figures/step_quantities.h"
#include "app/workbench/command.h"
#include "sim/body/joint.h"

namespace pabd {

namespace command {

// Brings a panel to the front ("barrier"), or closes its column.
struct Panel {
  static constexpr const char* name = "panel";
  std::string panel;
  bool on = true;
  void fields(auto&& f) {
    static const std::string names = panel_words();
    f(need("panel", names.c_str(), R"("series")"), panel);
    f(kOn, on);
  }
};
struct Theme {
  static constexpr const char* name = "theme";
  bool dark = true;
  void fields(auto&& f) { f(need("dark", "else light", "false"), dark); }
};
// Size of texts and everything else, times what the screen asks for; 0.5 … 4.
struct Scale {
  static constexpr const char* name = "scale";
  double factor = 1;
  void fields(auto&& f) { f(need("factor", "0.5 to 4, times what the screen asks for", "1.5"), factor); }
};
struct Help {
  static constexpr const char* name = "help";
  bool on = true;
  void fields(auto&& f) { f(kOn, on); }
};
// All commands by their words, to be searched.
struct Palette {
  static constexpr const char* name = "palette";
  bool on = true;
  void fields(auto&& f) { f(kOn, on); }
};
// Only the picture.
struct HideUi {
  static constexpr const char* name = "hide_ui";
  bool on = true;
  void fields(auto&& f) { f(kOn, on); }
};
struct Look {
  static constexpr const char* name = "look";
  std::vector<double> eye, target;  // three numbers each, m
  double fov = 0;                   // degrees; 0: as it is
  void fields(auto&& f) {
    f(need("eye", "m", "[4, 3, 6]"), eye);
    f(need("target", "what is looked at, m", "[0, 1, 0]"), target);
    f(may("fov", "vertical angle of view, 1 to 170 degrees", "40"), fov);
  }
};
// Parallel rays, or those of an eye.
struct Ortho {
  static constexpr const char* name = "ortho";
  bool on = true;
  void fields(auto&& f) { f(kOn, on); }
};
// The camera goes along with a body.
struct Follow {
  static constexpr const char* name = "follow";
  std::string body;  // name or number; empty: with none any more
  void fields(auto&& f) { f(need("body", "name or number; empty: none any more", R"("1")"), body); }
};
// "scene", "iso", "front", "back", "left", "right", "top", "bottom".
struct LookFrom {
  static constexpr const char* name = "look_from";
  std::string view;
  void fields(auto&& f) {
    f(need("view", "scene, iso, front, back, left, right, top or bottom", R"("front")"), view);
  }
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
    f(need("kind", "none, body, joint or contact", R"("body")"), kind);
    f(may("item", "number, or the name of a body or joint", R"("1")"), item);
    f(may("at", "of a body: where; body frame, m", "[0, 0.5, 0]"), at);
    f(may("normal", "of a body: the normal there; body frame", "[0, 1, 0]"), normal);
  }
};
// A joint from where the selected body was picked to the body that is double-clicked next, at the place of
// the click. `type`: as in a scene file; "" ends the wait.
struct Join {
  static constexpr const char* name = "join";
  std::string type;
  void fields(auto&& f) {
#define PABD_WORD(name) #name ", "
    f(need("type", PABD_JOINT_TYPES(PABD_WORD) "or empty: none after all", R"("hinge")"), type);
#undef PABD_WORD
  }
};
// "body", "projection" (‖A − R‖), "speed", "energy", "component".
struct ColorBy {
  static constexpr const char* name = "color_by";
  std::string quantity;
  void fields(auto&& f) {
    f(need("quantity", "body, projection, speed, energy or component", R"("speed")"), quantity);
  }
};
// What is drawn into the picture: "contacts", "bonds", or what picture_marks.h lists.
struct Show {
  static constexpr const char* name = "show";
  std::string what;
  bool on = true;
  void fields(auto&& f) {
    f(need("what", "contacts, bonds, velocities, boxes, axes or scale", R"("bonds")"), what);
    f(kOn, on);
  }
};
// Light and background of the picture.
struct Background {
  static constexpr const char* name = "background";
  std::string theme;
  void fields(auto&& f) { f(need("theme", "studio, dark or paper", R"("paper")"), theme); }
};
// The path of a point is shown from now on, or not any more.
struct Trail {
  static constexpr const char* name = "trail";
  std::string of;
  bool on = true;
  void fields(auto&& f) {
    f(need("of",
           "com: the centre of mass of all that moves; or BODY, or BODY@x,y,z with a point in its frame, m",
           R"("1@0,0.5,0")"),
      of);
    f(kOn, on);
  }
};
// How a second simulation is shown: "ghost" or "side".
struct CompareView {
  static constexpr const char* name = "compare_view";
  std::string how;
  void fields(auto&& f) { f(need("how", "ghost or side", R"("side")"), how); }
};
// `quantity`: "value", "slope", "curvature".
struct BarrierView {
  static constexpr const char* name = "barrier_view";
  std::string quantity = "value";
  bool log = false, energy = true, printed = true, onset = false, even = false, log_barrier = false;
  bool histogram = true;
  std::string against = "d";
  void fields(auto&& f) {
    f(may("quantity", "value, slope or curvature", R"("slope")"), quantity);
    f(may("against", "d, d_hat, N or kappa: what stands on the horizontal axis", R"("d_hat")"), against);
    f(may("log", "logarithmic axis", "true"), log);
    f(may("energy", "with κ: the energy, in J; else its shape", "false"), energy);
    f(may("printed", "the printed formula, ε = 0", "false"), printed);
    f(may("onset", "with onset ε", "true"), onset);
    f(may("even", "the even barrier", "true"), even);
    f(may("log_barrier", "the logarithmic barrier", "true"), log_barrier);
    f(may("histogram", "contacts over d/d̂", "false"), histogram);
  }
  bool operator==(const BarrierView&) const = default;
};
// `quantity`: "all", "energy_gap", "energy", "residual", "penetration", "joint_error", "projection_change".
struct ConvergenceView {
  static constexpr const char* name = "convergence_view";
  std::string quantity;
  void fields(auto&& f) {
    f(need("quantity", "all, energy_gap, energy, residual, penetration, joint_error or projection_change",
           R"("residual")"),
      quantity);
  }
};
// `quantity`: "overview", "gap", "penetration", "energies", "joint_error", "contacts", "iterations",
// "milliseconds"; or "chosen": `y` against `x`, each a number that a step tells (step_quantities.h).
struct SeriesView {
  static constexpr const char* name = "series_view";
  std::string quantity;
  std::string x = "time", y = "kinetic";
  void fields(auto&& f) {
    static const std::string words = step_quantity_words();
    f(need(
          "quantity",
          "overview, gap, penetration, energies, joint_error, contacts, iterations, milliseconds, or chosen: "
          "y against x",
          R"("gap")"),
      quantity);
    f(may("x", words.c_str(), R"("penetration")"), x);
    f(may("y", "as x", R"("elastic")"), y);
  }
};
// What of B − A is plotted: "distance", "gap", "penetration", "energies", "joint_error", "contacts".
struct DifferenceView {
  static constexpr const char* name = "difference_view";
  std::string quantity;
  void fields(auto&& f) {
    f(need("quantity", "distance, gap, penetration, energies, joint_error or contacts", R"("energies")"),
      quantity);
  }
};
// A PNG of the window, or without `ui` of the scene alone, as `pabd render` would draw it. Size 0: that of
// the window.
struct Screenshot {
  static constexpr const char* name = "screenshot";
  std::string path;
  bool ui = true, force = false;
  int width = 0, height = 0;
  void fields(auto&& f) {
    f(need("path", ".png file", R"("window.png")"), path);
    f(may("ui", "with the panels; else the scene alone, as 'pabd render' draws it", "false"), ui);
    f(kForce, force);
    f(may("width", "pixels, 16 to 16384, without panels only; 0: as the window", "640"), width);
    f(may("height", "pixels, 16 to 16384, without panels only; 0: as the window", "360"), height);
  }
};
// The plot of a panel as a file, by the ending of its name. Size 0: what suits it.
struct ExportPlot {
  static constexpr const char* name = "export_plot";
  std::string panel, path;
  bool force = false;
  int width = 0, height = 0;
  void fields(auto&& f) {
    f(need("panel", "barrier, convergence or series", R"("series")"), panel);
    f(need("path", ".csv, .svg, .pdf or .png file", R"("series.pdf")"), path);
    f(kForce, force);
    f(may("width", "pixels, 16 to 16384; 0: what suits the plot", "1000"), width);
    f(may("height", "pixels, 16 to 16384; 0: what suits the plot", "700"), height);
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
  int crf = -1;  // negative: what suits the kind of file
  std::string preset;
  int loop = 0;
  std::string encoder = "software";
  bool force = false;
  void fields(auto&& f) {
    f(need("path", ".mp4, .webm, .gif, or numbered .png files", R"("frames/{frame:04}.png")"), path);
    f(may("from", "simulated time, s; negative: the first moment", "0"), from);
    f(may("to", "simulated time, s; negative: the last moment", "0.5"), to);
    f(may("fps", "frames a second of simulated time", "30"), fps);
    f(may("width", "pixels, 16 to 16384", "640"), width);
    f(may("height", "pixels, 16 to 16384", "360"), height);
    f(may("overlay", "as for 'pabd render'; without: what the view shows", R"("contacts,series")"), overlay);
    f(may("crf",
          "how much may be lost, smaller is better and larger: .mp4 0 to 51, .webm 0 to 63; negative: 18, 24",
          "14"),
      crf);
    f(may("preset", "of .mp4 and .webm: time for a smaller file, ultrafast to veryslow", R"("slow")"),
      preset);
    f(may("loop", "how often a .gif is played; 0: for ever", "1"), loop);
    f(may("encoder", "of .mp4: software, or that of an NVIDIA GPU: nvenc", R"("nvenc")"), encoder);
    f(kForce, force);
  }
};
// Ends it: with the frames that are there, or without a file.
struct StopRecord {
  static constexpr const char* name = "stop_record";
  bool keep = true;
  void fields(auto&& f) { f(may("keep", "the frames that are there; else no file", "false"), keep); }
};
// The camera as it is becomes a key frame at the present time of the simulation.
struct AddCameraKey {
  static constexpr const char* name = "add_camera_key";
  void fields(auto&&) {}
};
struct DropCameraKey {
  static constexpr const char* name = "drop_camera_key";
  int index = 0;  // in order of time
  void fields(auto&& f) { f(need("index", "number from 0, in order of time", "0"), index); }
};
struct ClearCameraKeys {
  static constexpr const char* name = "clear_camera_keys";
  void fields(auto&&) {}
};
// The camera follows its keys while time goes on.
struct Fly {
  static constexpr const char* name = "fly";
  bool on = true;
  void fields(auto&& f) { f(kOn, on); }
};
// Camera keys as a file, which `pabd render --camera` takes.
struct SaveCamera {
  static constexpr const char* name = "save_camera";
  std::string path;
  bool force = false;
  void fields(auto&& f) {
    f(need("path", "file", R"("camera.json")"), path);
    f(kForce, force);
  }
};
struct LoadCamera {
  static constexpr const char* name = "load_camera";
  std::string path;
  void fields(auto&& f) { f(need("path", "file", R"("camera.json")"), path); }
};
// What a frame costs, part by part.
struct Costs {
  static constexpr const char* name = "costs";
  bool on = true;
  void fields(auto&& f) { f(kOn, on); }
};
// A dialog: for a file name "open", "save_scene", "save_state", "save_patch", "apply_patch",
// "save_recording", "load_recording", "screenshot", "record", "save_camera", "load_camera", "open_sweep"; before something
// is gone "reload", "clear_camera", "quit"; "" closes it. `text`: what it starts with.
struct Ask {
  static constexpr const char* name = "ask";
  std::string what, text = {};
  void fields(auto&& f) {
    f(need("what", "open, save_scene, …: see scripts.md; empty: closes it", R"("open")"), what);
    f(may("text", "what it starts with", R"("stack")"), text);
  }
};
struct CopyCommand {
  static constexpr const char* name = "copy_command";
  void fields(auto&&) {}
};
struct Quit {
  static constexpr const char* name = "quit";
  bool force = false;  // although something is not saved
  void fields(auto&& f) { f(kGiveUp, force); }
};

}  // namespace command

using ViewCommand =
    std::variant<command::Panel, command::Theme, command::Scale, command::Help, command::Palette,
                 command::HideUi, command::Look, command::LookFrom, command::Ortho, command::Follow,
                 command::FrameSelection, command::Select, command::Join, command::ColorBy, command::Show,
                 command::Background, command::Trail, command::CompareView, command::BarrierView,
                 command::ConvergenceView, command::SeriesView, command::DifferenceView, command::Screenshot,
                 command::ExportPlot, command::Record, command::StopRecord, command::AddCameraKey,
                 command::DropCameraKey, command::ClearCameraKeys, command::Fly, command::SaveCamera,
                 command::LoadCamera, command::Costs, command::OpenSweep, command::SweepView,
                 command::LoadRun, command::Ask, command::CopyCommand, command::Quit>;

}  // namespace pabd
