// SPDX-License-Identifier: MIT
// Widgets that several panels use.
#pragma once

#include <optional>
#include <string>

#include "app/gui/panel.h"
#include "app/plots/plot_zoom.h"

namespace pabd {

// Text with d̂ and other signs, for ImGui's own functions.
void label(const std::string& text);
void muted_label(const GuiFrame& frame, const std::string& text);
// The same in lines as wide as the panel.
void wrapped_label(const std::string& text);
void wrapped_muted_label(const GuiFrame& frame, const std::string& text);
// Cut where it would be wider than so many pixels, with "…" for the rest.
std::string shortened(const std::string& text, float width);
// Stays on the line if `width` pixels fit.
void same_line_if_room(float width, float gap = -1);  // gap: as usual
float button_width(const std::string& text);          // pixels
// Shows `text` while the mouse is on the last item: beside it, or beside the mouse on a large item.
void tooltip(const std::string& text);
// Where a tooltip of that size goes on a screen: below or above the item, or if that is higher than `large` above and
// beside the mouse. Pixels.
Rect tooltip_place(const Rect& item, Point mouse, double width, double height, const Rect& screen, double gap,
                   double large);
ImU32 packed(Color color);
ImVec4 im_color(Color color);

// A heading across the panel.
void heading(const GuiFrame& frame, const std::string& text);
// name …… value, the value right-aligned; `warn` in the colour of warnings.
void read_out(const GuiFrame& frame, const std::string& name, const std::string& value, bool warn = false);

// A button with a drawn sign, square, as high as other widgets. Signs: "play", "pause", "back", "forward",
// "restart", "undo", "redo", "reset".
bool icon_button(const GuiFrame& frame, const char* sign, const std::string& help, bool enabled = true);

// A button that stays pressed.
bool toggle_button(const GuiFrame& frame, const std::string& text, bool on, const std::string& help);

// What the mouse does on a plot.
struct PlotTouch {
  PlotLayout layout;
  bool hovered = false, pressed = false, held = false;  // by the left button
  Point mouse;                                          // pixels; layout.unmap gives data
  std::optional<PlotZoom>
      zoom;  // what it asks for: the wheel, a drag with another button or with shift, a double-click
};
// What it may do to the axes; with `grips` the left button takes hold of something.
enum class PlotHand : std::uint8_t { none, zooms, grips };
// A plot of that size (pixels) at the cursor; `id` is unique in the panel.
PlotTouch plot_widget(GuiFrame& frame, const char* id, const Plot& plot, ImVec2 size,
                      PlotHand hand = PlotHand::none);

}  // namespace pabd
