// SPDX-License-Identifier: MIT
// The state of the view, as plain data. Panels read it; view commands, the mouse, the flight along camera keys and
// changes of the scene write it.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/gui/opened_sweep.h"
#include "app/gui/view_command.h"
#include "app/overlay/body_colors.h"
#include "app/plots/plot_zoom.h"
#include "app/session/trails.h"
#include "render/visual/camera_path.h"
#include "render/visual/framing.h"
#include "sim/math/types.h"

namespace pabd {

inline constexpr std::size_t kMostRecent = 10;  // scenes that are remembered

struct Selection {
  enum class Kind : std::uint8_t { none, body, joint, contact };
  Kind kind = Kind::none;
  Index index = 0;         // of a contact: among the reports of the step; −1: it is open now
  Index a = -1, b = -1;    // of a contact: its bodies
  Vec3 at = Vec3::Zero();  // of a body: where it was picked, and the normal there; body frame
  Vec3 normal = Vec3::UnitY();
  bool operator==(const Selection&) const = default;
};

// What a command fitted into the picture; fitted again when the picture changes its shape, until the camera moves.
struct Framed {
  std::shared_ptr<const std::vector<Spot>> spots;
  Camera camera;      // as it was fitted
  double aspect = 0;  // of the picture
  bool near = false;  // so near that the camera has to go along
};

// A joint that waits for its second body.
struct Joining {
  std::string type;
  Index body = 0;  // the first one
  Vec3 at;         // on it; body frame
};

struct UiState {
  bool dark = true;
  double scale = 1;  // times the screen's
  bool help = false, palette = false, hidden = false, costs = false;
  BySlot<const WindowPanel*> shown{&parameters_tab, &barrier_tab, &convergence_tab};
  BySlot<bool> open{true, true, true};
  std::array<Slot, std::size(kSlots)> front{Slot::right_top, Slot::right_bottom, Slot::left};  // see bring()
  PanelSizes sizes;  // as they were dragged

  CameraPose camera;
  std::optional<Framed> framed;
  std::shared_ptr<const std::vector<Spot>> scene_spots;  // what the scene shows from its start on
  std::optional<Index> follow;                           // the body that the camera goes along with
  std::vector<CameraKey> camera_keys;                    // in order of time
  bool keys_unsaved = false;  // they were set or removed since they were saved or loaded
  bool fly = false;
  bool along = true;  // the camera goes along by itself until a person moves it (going_along.h)
  bool contacts = true, bonds = true;
  PictureMarks marks;
  const PictureTheme* theme = &kStudioTheme;  // of the picture; never null
  std::vector<TrailPoint> trails;             // whose paths are shown
  ColorQuantity color = ColorQuantity::body;
  ContactQuantity contacts_by = ContactQuantity::gap;
  Selection selection;
  std::optional<Joining> joining;
  bool side_by_side = false;  // of A and B; else B is a ghost

  command::BarrierView barrier;
  std::array<PlotZoom, std::size(kPlottingPanels)> zoom;  // see zoom_of
  std::string convergence = "all", series = "overview", difference = "distance";
  std::string series_x = "time", series_y = "kinetic";  // of the series "chosen"

  OpenedSweep sweep;

  std::string dialog;               // see command::Ask; empty: none
  std::string dialog_text;          // what it starts with; empty: something that fits
  std::vector<std::string> recent;  // scenes that were open, newest first; at most kMostRecent
  bool quit = false;

  // Where there is room for fewer panels, it is for those that were brought last.
  void bring(const WindowPanel& panel) {
    shown[panel.slot] = &panel;
    open[panel.slot] = true;
    const auto place = std::find(front.begin(), front.end(), panel.slot);
    std::rotate(front.begin(), place, place + 1);
  }

  // The part of the plot of one of kPlottingPanels that is seen.
  const PlotZoom& zoom_of(std::string_view panel) const { return zoom[place_in(kPlottingPanels, panel)]; }
  bool shows(const WindowPanel& panel) const {
    return !hidden && open[panel.slot] && shown[panel.slot] == &panel;
  }
};

// The command for that part of a panel's plot.
inline command::PlotView plot_view(const char* panel, const PlotZoom& zoom) {
  const auto ends = [](const std::optional<PlotRange>& range) {
    return range ? std::vector<double>{range->lo, range->hi} : std::vector<double>();
  };
  return {panel, ends(zoom.x), ends(zoom.y), ends(zoom.right)};
}

}  // namespace pabd
