// SPDX-License-Identifier: MIT
// Paints into a Dear ImGui draw list.
#include "app/overlay/imgui_canvas.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace pabd {
namespace {

ImVec2 vec(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

ImU32 packed(Color c) { return IM_COL32(c.r, c.g, c.b, c.a); }

constexpr double kSharpTurn = 0.75;          // cosine: beyond about 40° a mitred corner would stick out
constexpr std::size_t kLongestPiece = 8000;  // points of one draw call: indices have 16 bits

// Cuts a polyline into its dashes; calls `emit` with each.
void dash_polyline(std::span<const Point> points, double on, double off,
                   const std::function<void(std::span<const Point>)>& emit) {
  if (points.size() < 2) return;
  std::vector<Point> dash{points[0]};
  bool drawing = true;
  double left = on;
  for (std::size_t i = 1; i < points.size(); ++i) {
    Point from = points[i - 1];
    double length = std::hypot(points[i].x - from.x, points[i].y - from.y);
    while (length > left) {
      const double t = left / length;
      from = {from.x + t * (points[i].x - from.x), from.y + t * (points[i].y - from.y)};
      length -= left;
      if (drawing) {
        dash.push_back(from);
        emit(dash);
        dash.clear();
      } else {
        dash.assign(1, from);
      }
      drawing = !drawing;
      left = drawing ? on : off;
    }
    left -= length;
    if (drawing) dash.push_back(points[i]);
  }
  if (drawing && dash.size() > 1) emit(dash);
}

}  // namespace

void ImGuiCanvas::polyline(std::span<const Point> points, const Stroke& stroke, bool closed) {
  if (points.size() < 2) return;
  if (stroke.dash_on > 0) {
    std::vector<Point> loop(points.begin(), points.end());
    if (closed) loop.push_back(points[0]);
    dash_polyline(loop, stroke.dash_on, stroke.dash_off, [&](std::span<const Point> dash) {
      solid_polyline(dash, stroke.color, stroke.width, false);
    });
    return;
  }
  solid_polyline(points, stroke.color, stroke.width, closed);
}

void ImGuiCanvas::solid_polyline(std::span<const Point> points, Color color, double width, bool closed) {
  const ImU32 ink = packed(color);
  std::vector<ImVec2> piece;
  const auto flush = [&](bool loop) {
    if (piece.size() > 1) {
      list_.AddPolyline(piece.data(), static_cast<int>(piece.size()), ink,
                        loop ? ImDrawFlags_Closed : ImDrawFlags_None, static_cast<float>(width));
    }
  };
  if (closed && points.size() > 2) {
    for (const Point& p : points) piece.push_back(vec(p.x, p.y));
    flush(true);
    return;
  }
  // Cut at sharp turns, where a round joint replaces the mitre.
  Point last{}, direction{};
  bool directed = false;
  for (const Point& p : points) {
    if (piece.empty()) {
      piece.push_back(vec(p.x, p.y));
      last = p;
      continue;
    }
    const double length = std::hypot(p.x - last.x, p.y - last.y);
    if (length < 0.05) continue;
    const Point next{(p.x - last.x) / length, (p.y - last.y) / length};
    const bool sharp = directed && next.x * direction.x + next.y * direction.y < kSharpTurn;
    if (sharp || piece.size() >= kLongestPiece) {
      flush(false);
      if (sharp && width > 1.2) fill_circle(last, 0.5 * width - 0.25, color);
      piece.assign(1, vec(last.x, last.y));
    }
    piece.push_back(vec(p.x, p.y));
    direction = next;
    directed = true;
    last = p;
  }
  flush(false);
}

void ImGuiCanvas::fill_polygon(std::span<const Point> convex, Color color) {
  if (convex.size() < 3) return;
  std::vector<ImVec2> points;
  double area = 0;
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const Point &a = convex[i], &b = convex[(i + 1) % convex.size()];
    area += a.x * b.y - b.x * a.y;
    points.push_back(vec(a.x, a.y));
  }
  // The soft rim grows outwards only for corners in this order.
  if (area < 0) std::reverse(points.begin(), points.end());
  list_.AddConvexPolyFilled(points.data(), static_cast<int>(points.size()), packed(color));
}

void ImGuiCanvas::fill_rect(const Rect& rect, Color color, double corner_radius) {
  if (!(rect.w > 0) || !(rect.h > 0)) return;
  list_.AddRectFilled(vec(rect.x, rect.y), vec(rect.right(), rect.bottom()), packed(color),
                      static_cast<float>(corner_radius));
}

// Triangles of our own: Dear ImGui takes the processor's approximate square root for the rim, and thousands
// of markers over each other add up what it differs by between makers of processors.
void ImGuiCanvas::fill_circle(const Point& center, double radius, Color color) {
  const int segments = std::clamp(static_cast<int>(4 + 5 * std::sqrt(radius)), 12, 64);
  const ImU32 ink = packed(color), clear = ink & ~IM_COL32_A_MASK;
  const double soft =
      0.5 / std::cos(std::numbers::pi / segments);  // half the width of the rim, at the corners
  const double inner = std::max(0.0, radius - soft), outer = radius + soft;
  list_.PrimReserve(3 * (segments - 2) + 6 * segments, 2 * segments);
  const unsigned first = list_._VtxCurrentIdx;
  const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
  const auto index = [&](int corner, int ring) {
    list_.PrimWriteIdx(static_cast<ImDrawIdx>(first + 2 * static_cast<unsigned>(corner % segments) +
                                              static_cast<unsigned>(ring)));
  };
  for (int k = 0; k < segments; ++k) {
    const double x = std::cos(2 * std::numbers::pi * k / segments),
                 y = std::sin(2 * std::numbers::pi * k / segments);
    list_.PrimWriteVtx(vec(center.x + inner * x, center.y + inner * y), white, ink);
    list_.PrimWriteVtx(vec(center.x + outer * x, center.y + outer * y), white, clear);
  }
  for (int k = 0; k < segments; ++k) {
    if (k >= 2) index(0, 0), index(k - 1, 0), index(k, 0);
    index(k, 0), index(k, 1), index(k + 1, 1);
    index(k, 0), index(k + 1, 1), index(k + 1, 0);
  }
}

void ImGuiCanvas::text(const Point& at, std::string_view rich, const TextStyle& style) {
  const TextLayout layout = layout_text(font(), rich, style.size);
  if (layout.runs.empty()) return;
  const double start = style.x == AlignX::left     ? 0
                       : style.x == AlignX::center ? -0.5 * layout.width
                                                   : -layout.width;
  const double down = baseline_offset(style.y, style.size);
  // The baseline on a whole pixel: horizontal strokes stay sharp.
  const Point origin = style.vertical ? Point{std::round(at.x + down), at.y - start}
                                      : Point{at.x + start, std::round(at.y + down)};
  if (style.halo > 0) {
    for (int k = 0; k < 12; ++k) {
      const double angle = 2 * std::numbers::pi * k / 12;
      glyphs(layout, {origin.x + style.halo * std::cos(angle), origin.y + style.halo * std::sin(angle)},
             style.vertical, {style.halo_color.r, style.halo_color.g, style.halo_color.b, style.color.a});
    }
  }
  glyphs(layout, origin, style.vertical, style.color);
}

void ImGuiCanvas::glyphs(const TextLayout& layout, const Point& origin, bool vertical, Color color) {
  const ImU32 ink = packed(color);
  for (const TextRun& run : layout.runs) {
    const ImFont* face = atlas_.font(run.size);
    if (!face) continue;  // first pass: only to learn which sizes are needed
    const double rise = std::round(static_cast<double>(face->Ascent));
    double pen = run.x;
    const double baseline = std::round(run.y);
    for (const char32_t c : decode_text(run.text)) {
      const ImFontGlyph* glyph = c <= 0xFFFF ? face->FindGlyphNoFallback(static_cast<ImWchar>(c)) : nullptr;
      if (!glyph) {
        atlas_.request(c);
        glyph = face->FindGlyph(0xFFFD);
      }
      if (glyph && glyph->Visible) {
        const double x0 = pen + static_cast<double>(glyph->X0), x1 = pen + static_cast<double>(glyph->X1);
        const double y0 = baseline + static_cast<double>(glyph->Y0) - rise;
        const double y1 = baseline + static_cast<double>(glyph->Y1) - rise;
        // Slanted about the baseline.
        const double top = run.italic ? -kSlant * (y0 - baseline) : 0;
        const double bottom = run.italic ? -kSlant * (y1 - baseline) : 0;
        const auto place = [&](double x, double y) {
          return vertical ? vec(origin.x + y, origin.y - x) : vec(origin.x + x, origin.y + y);
        };
        list_.PrimReserve(6, 4);
        list_.PrimQuadUV(place(x0 + top, y0), place(x1 + top, y0), place(x1 + bottom, y1),
                         place(x0 + bottom, y1), {glyph->U0, glyph->V0}, {glyph->U1, glyph->V0},
                         {glyph->U1, glyph->V1}, {glyph->U0, glyph->V1}, ink);
      }
      pen += font().advance(c) * run.size;
    }
  }
}

void ImGuiCanvas::push_clip(const Rect& rect) {
  list_.PushClipRect(vec(rect.x, rect.y), vec(rect.right(), rect.bottom()), true);
}

void ImGuiCanvas::pop_clip() { list_.PopClipRect(); }

ImGuiContext* new_imgui_context() {
  ImGuiContext* context = ImGui::CreateContext();
  ImGui::SetCurrentContext(context);
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  return context;
}

}  // namespace pabd
