// SPDX-License-Identifier: MIT
// What a person does to the view: panels, camera, colours, pictures, the open sweep. None of it changes a simulation.
// The same form as app/workbench/command.h; words to choose from: view_words.h.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "app/gui/view_words.h"
#include "app/workbench/command.h"

namespace pabd {

namespace command {

// A command that only turns something on or off.
template <Text word>
struct Switch {
  static constexpr const char* name = word.characters;
  bool on = true;
  void fields(auto&& f) { f(kOn, on); }
};
// A command that is one word of a list.
template <Text word, Text field, const auto& list, Text sample>
struct Pick {
  static constexpr const char* name = word.characters;
  std::string choice;
  void fields(auto&& f) { f(need(field.characters, list, sample.characters), choice); }
};

// Brings a panel to the front, or closes its column.
struct Panel {
  static constexpr const char* name = "panel";
  std::string panel;
  bool on = true;
  void fields(auto&& f) {
    f(need("panel", panel_choices(), R"("series")"), panel);
    f(kOn, on);
  }
};
// How large panels are; what does not fit into the window is smaller for as long.
struct PanelSize {
  static constexpr const char* name = "panel_size";
  std::string border;
  double size = 0;
  void fields(auto&& f) {
    f(need("border", kBorders, R"("right")",
           "left, right: that column; upper: of two panels above each other; below: all below the picture"),
      border);
    f(may("size",
          "200 to 4000 pixels of an ordinary screen, or 0.1 to 0.9 of the height; 0: as the window has room",
          "480"),
      size);
  }
};
struct Theme {
  static constexpr const char* name = "theme";
  bool dark = true;
  void fields(auto&& f) { f(need("dark", "else light", "false"), dark); }
};
// Size of texts and everything else.
struct Scale {
  static constexpr const char* name = "scale";
  double factor = 1;
  void fields(auto&& f) { f(need("factor", "0.5 to 4, times what the screen asks for", "1.5"), factor); }
};
using Help = Switch<"help">;
using Palette = Switch<"palette">;  // all actions, to be searched
using HideUi = Switch<"hide_ui">;   // only the picture
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
using LookFrom = Pick<"look_from", "view", kLookFrom, R"("front")">;
using Ortho = Switch<"ortho">;  // parallel rays, or those of an eye
// The camera goes along with a body.
struct Follow {
  static constexpr const char* name = "follow";
  std::string body;
  void fields(auto&& f) { f(need("body", "name or number; empty: none any more", R"("1")"), body); }
};
using FrameSelection =
    Plain<"frame_selection">;  // what is selected fills the view; without a selection everything
struct Select {
  static constexpr const char* name = "select";
  std::string kind = "body", item;
  std::vector<double> at = {}, normal = {};  // without: the centre
  void fields(auto&& f) {
    f(need("kind", kSelectionKinds, R"("body")"), kind);
    f(may("item", "number, or the name of a body or joint", R"("1")"), item);
    f(may("at", "of a body: where; body frame, m", "[0, 0.5, 0]"), at);
    f(may("normal", "of a body: the normal there; body frame", "[0, 1, 0]"), normal);
  }
};
// A joint from where the selected body was picked to the body that is double-clicked next, at the place of the click.
struct Join {
  static constexpr const char* name = "join";
  std::string type;
  void fields(auto&& f) { f(need("type", joint_choices(), R"("hinge")", "none after all"), type); }
};
using ColorBy = Pick<"color_by", "quantity", kColors, R"("speed")">;
// What the colours of contacts say; shows them.
using ContactsBy = Pick<"contacts_by", "quantity", kContactColors, R"("force")">;
// What is drawn into the picture.
struct Show {
  static constexpr const char* name = "show";
  std::string what;
  bool on = true;
  void fields(auto&& f) {
    f(need("what", mark_choices(), R"("bonds")"), what);
    f(kOn, on);
  }
};
// Light and background of the picture.
using Background = Pick<"background", "theme", kBackgrounds, R"("paper")">;
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
// How a second simulation is shown.
using CompareView = Pick<"compare_view", "how", kCompareViews, R"("side")">;
struct BarrierView {
  static constexpr const char* name = "barrier_view";
  std::string quantity = "value", against = "d";
  bool log = false, energy = true, printed = true, onset = false, even = false, log_barrier = false;
  bool histogram = true;
  void fields(auto&& f) {
    f(may("quantity", kBarrierQuantities, R"("slope")"), quantity);
    f(may("against", kBarrierAbscissas, R"("d_hat")", "what stands on the horizontal axis"), against);
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
using ConvergenceView = Pick<"convergence_view", "quantity", kConvergenceViews, R"("residual")">;
struct SeriesView {
  static constexpr const char* name = "series_view";
  std::string quantity;
  std::string x = "time", y = "kinetic";
  void fields(auto&& f) {
    f(need("quantity", kSeriesViews, R"("gap")", "chosen is y against x"), quantity);
    f(may("x", quantity_choices(), R"("penetration")"), x);
    f(may("y", quantity_choices(), R"("elastic")"), y);
  }
};
// What of B − A is plotted.
using DifferenceView = Pick<"difference_view", "quantity", kDifferenceViews, R"("energies")">;
// The part of a panel's plot that is seen.
struct PlotView {
  static constexpr const char* name = "plot_view";
  std::string panel;
  std::vector<double> x, y, right;
  void fields(auto&& f) {
    static constexpr const char* kEnds = "[lowest, highest] in the unit of that axis; without: the whole";
    f(need("panel", kPlottingPanels, R"("series")"), panel);
    f(may("x", kEnds, "[0, 0.5]"), x);
    f(may("y", kEnds, "[0.001, 1]"), y);
    f(may("right", kEnds, "[0, 1]"), right);
  }
};
// A PNG of the window, or of the scene alone.
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
// The plot of a panel as a file, by the ending of its name.
struct ExportPlot {
  static constexpr const char* name = "export_plot";
  std::string panel, path;
  bool force = false;
  int width = 0, height = 0;
  void fields(auto&& f) {
    f(need("panel", kPlottingPanels, R"("series")"), panel);
    f(need("path", ".csv, .svg, .pdf or .png file", R"("series.pdf")"), path);
    f(kForce, force);
    f(may("width", "pixels, 16 to 16384; 0: what suits the plot", "1000"), width);
    f(may("height", "pixels, 16 to 16384; 0: what suits the plot", "700"), height);
  }
};
// A video of the past as `pabd render` makes it, with the view's camera, or along the camera keys while flying.
struct Record {
  static constexpr const char* name = "record";
  std::string path;
  double from = -1, to = -1, fps = 60;
  int width = 1280, height = 720;
  std::string overlay;
  int crf = -1;
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
struct StopRecord {
  static constexpr const char* name = "stop_record";
  bool keep = true;
  void fields(auto&& f) { f(may("keep", "the frames that are there; else no file", "false"), keep); }
};
using AddCameraKey = Plain<"add_camera_key">;  // the camera as it is, at the present time of the simulation
struct DropCameraKey {
  static constexpr const char* name = "drop_camera_key";
  int index = 0;
  void fields(auto&& f) { f(need("index", "number from 0, in order of time", "0"), index); }
};
using ClearCameraKeys = Plain<"clear_camera_keys">;
using Fly = Switch<"fly">;      // the camera follows its keys while time goes on
using Along = Switch<"along">;  // while time goes on the camera goes along by itself, until a person moves it
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
using Costs = Switch<"costs">;  // what a frame costs, part by part
// The folder of a sweep is read and shown; again when it is open already.
struct OpenSweep {
  static constexpr const char* name = "open_sweep";
  std::string folder;
  void fields(auto&& f) {
    f(need("folder", "of 'pabd sweep', finished or not; empty: closes it", R"("sweep_out")"), folder);
  }
};
// What the cells of the sweep show. What is left out is chosen: the first metric, the parameters with the most values.
struct SweepView {
  static constexpr const char* name = "sweep_view";
  std::string metric, x, y;
  int slice = 0;
  bool pictures = true;
  void fields(auto&& f) {
    f(may("metric", "whose colours the cells have, by its name", R"("penetration")"), metric);
    f(may("x", "parameter from left to right, by its key", R"("contact.N")"), x);
    f(may("y", "parameter from bottom to top, by its key", R"("contact.d_hat")"), y);
    f(may("slice", "of the combinations of the other parameters, from 0", "1"), slice);
    f(may("pictures", "of the ends in the cells; else colours alone", "false"), pictures);
  }
  bool operator==(const SweepView&) const = default;
};
// The scene with the parameters of a task of the open sweep.
struct LoadRun {
  static constexpr const char* name = "load_run";
  int task = 0;
  std::string at = "start";
  bool force = false;
  void fields(auto&& f) {
    f(need("task", "its index", "7"), task);
    f(may("at", kRunPlaces, R"("end")", "as the task began, or as it left it"), at);
    f(kGiveUp, force);
  }
};
struct Ask {
  static constexpr const char* name = "ask";
  std::string what, text = {};
  void fields(auto&& f) {
    f(need("what", dialog_choices(), R"("open")", "the dialog; empty closes it"), what);
    f(may("text", "what it starts with", R"("stack")"), text);
  }
};
using CopyCommand = Plain<"copy_command">;
struct Quit {
  static constexpr const char* name = "quit";
  bool force = false;
  void fields(auto&& f) { f(kGiveUp, force); }
};

}  // namespace command

using ViewCommand =
    std::variant<command::Panel, command::PanelSize, command::Theme, command::Scale, command::Help,
                 command::Palette, command::HideUi, command::Look, command::LookFrom, command::Ortho,
                 command::Follow, command::FrameSelection, command::Select, command::Join, command::ColorBy,
                 command::ContactsBy, command::Show, command::Background, command::Trail,
                 command::CompareView, command::BarrierView, command::ConvergenceView, command::SeriesView,
                 command::DifferenceView, command::PlotView, command::Screenshot, command::ExportPlot,
                 command::Record, command::StopRecord, command::AddCameraKey, command::DropCameraKey,
                 command::ClearCameraKeys, command::Fly, command::Along, command::SaveCamera,
                 command::LoadCamera, command::Costs, command::OpenSweep, command::SweepView,
                 command::LoadRun, command::Ask, command::CopyCommand, command::Quit>;

}  // namespace pabd
