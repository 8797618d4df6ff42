// Which panels are shown, and where: parameters top left, legends bottom left, plots in a column at the
// right. Panels never overlap and stay inside the frame.
#pragma once

#include <string>
#include <vector>

#include "app/plots/canvas.h"

namespace pabd {

enum class Panel { params, barrier, convergence, series, legend, joints, difference };
const char* to_string(Panel panel);

struct OverlayOptions {
  bool params = false;
  bool barrier = false;
  bool convergence = false;
  bool series = false;
  bool legend = false;      // of contact colours
  bool joints = false;      // legend of joints; comes with the bonds overlay, not by a name of its own
  int joint_rows = 0;       // how many of the parameters are about joints: the panel grows
  bool difference = false;  // of two runs beside each other

  bool shows(Panel panel) const;
  bool any() const { return params || barrier || convergence || series || legend || joints || difference; }
};

// Switches on the panel of that name: params, barrier, convergence, series, legend, difference; plots: the
// middle three.
// False when there is no such panel. `panel_names` is the list for messages.
bool enable_panel(OverlayOptions& options, const std::string& name);
std::string panel_names();

// From "params,plots". Empty or "none": nothing; "all": everything. Throws Error(bad_input) naming the word
// and the list.
OverlayOptions parse_panels(const std::string& list);

struct PlacedPanel {
  Panel panel;
  Rect rect;
};

struct PanelLayout {
  double scale = 1;  // of texts and lines; 1 at 1280 × 720
  std::vector<PlacedPanel> panels;
  Rect
      free;  // the largest rectangle at the left of the plots that no panel covers: where the picture is seen
};

PanelLayout layout_panels(const OverlayOptions& options, int width, int height);

}  // namespace pabd
