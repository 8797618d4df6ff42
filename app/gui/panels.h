// SPDX-License-Identifier: MIT
// Parts of the window beside its panels.
#pragma once

#include <functional>

#include "app/gui/gui_layout.h"
#include "app/gui/panel.h"

namespace pabd {

// For `unit` pixels a pixel of an ordinary screen.
void apply_gui_theme(ImGuiStyle& style, bool dark, double unit);

// Behind the panels, linear light.
Vec3f window_background(bool dark);

// Em of ordinary text on an ordinary screen; px.
inline constexpr double kTextSize = 13.5;

// Begins the ImGui window of a part that stays where it is; ImGui::End() ends it.
void begin_fixed(const char* id, const Rect& rect, ImGuiWindowFlags more = 0);
// A slot with its tabs, the panel that it shows and the borders that can be dragged.
void draw_slot(GuiFrame& frame, Slot slot, GuiPanel& panel);
// Begins a menu below the button that was drawn last when that was pressed, within the window, where it scrolls if it
// is long; ImGui::EndPopup() ends it.
bool begin_menu(const GuiFrame& frame, const char* id, bool pressed);

void draw_toolbar(GuiFrame& frame);
// What its menus hold.
void draw_color_choice(GuiFrame& frame);
void draw_contact_choice(GuiFrame& frame);
void draw_panel_items(GuiFrame& frame);
void draw_view_items(GuiFrame& frame);

class TypedField;

class TimelineBar {
 public:
  void draw(GuiFrame& frame);

 private:
  double wanted_ = -1;  // time that a drag asked for; s
  float offset_ = 0;    // from the mouse to the playhead that it holds; pixels
};

// Messages over the picture, until they are read; `seconds` since the last frame.
class MessageList {
 public:
  // Messages up to `read` were read elsewhere.
  void draw(GuiFrame& frame, const Rect& view, double seconds, std::uint64_t read);

 private:
  std::uint64_t dismissed_ = 0;
  std::uint64_t newest_ = 0;
  double age_ = 0;
};

// Offers to load a scene's file again when it changed on disk, and says what would be lost.
void draw_file_offer(GuiFrame& frame, const Rect& view);

// How far a video is, while one is made.
void draw_recording(GuiFrame& frame, const Rect& view);
// What its dialog asks for beside the name.
void draw_record_fields(GuiFrame& frame, command::Record& record, TypedField& field, bool& along_keys);

// Marks of the camera's key frames on the timeline.
void draw_camera_marks(const GuiFrame& frame, const std::function<float(double)>& x_of_time, float y);

// "A" and "B" over the pictures of two simulations.
void draw_compare_labels(GuiFrame& frame, const GuiLayout& layout);

void draw_help(GuiFrame& frame, int width, int height);
// All actions by their words, to be searched.
class Palette {
 public:
  void draw(GuiFrame& frame, int width, int height);

 private:
  std::string text_;
  int chosen_ = 0;
  bool open_ = false;
};

}  // namespace pabd
