// SPDX-License-Identifier: MIT
// Paints into a Dear ImGui draw list: anti-aliased triangles, glyph by glyph text.
#pragma once

#include "app/overlay/font_atlas.h"
#include "app/plots/canvas.h"

struct ImDrawList;
struct ImGuiContext;

namespace pabd {

class ImGuiCanvas : public Canvas {
 public:
  ImGuiCanvas(const FontMetrics& font, FontAtlas& atlas, ImDrawList& list)
      : Canvas(font), atlas_(atlas), list_(list) {}

  void polyline(std::span<const Point> points, const Stroke& stroke, bool closed) override;
  void fill_polygon(std::span<const Point> convex, Color color) override;
  void fill_rect(const Rect& rect, Color color, double corner_radius) override;
  void fill_circle(const Point& center, double radius, Color color) override;
  void text(const Point& at, std::string_view rich, const TextStyle& style) override;
  void push_clip(const Rect& rect) override;
  void pop_clip() override;

 private:
  void solid_polyline(std::span<const Point> points, Color color, double width, bool closed);
  void glyphs(const TextLayout& layout, const Point& origin, bool vertical, Color color);

  FontAtlas& atlas_;
  ImDrawList& list_;
};

// A context that keeps no files and takes draw lists of any length, current; the caller destroys it.
ImGuiContext* new_imgui_context();

}  // namespace pabd
