// SPDX-License-Identifier: MIT
// Paints into an SVG document.
#include "app/plots/svg_canvas.h"

#include <fmt/format.h>

#include <cmath>

#include "app/plots/figure.h"
#include "app/plots/markup.h"

namespace pabd {
namespace {

// Two decimals of a pixel are finer than any printer; trailing zeros go.
std::string number(double v) {
  if (!std::isfinite(v)) return "0";
  std::string text = fmt::format("{:.2f}", v);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string paint(const char* what, Color color) {
  std::string out = fmt::format(" {}=\"#{:02x}{:02x}{:02x}\"", what, color.r, color.g, color.b);
  if (color.a < 255) out += fmt::format(" {}-opacity=\"{:.3g}\"", what, color.a / 255.0);
  return out;
}

std::string path(std::span<const Point> points) {
  std::string out;
  for (const Point& p : points) {
    if (!out.empty()) out += ' ';
    out += number(p.x) + ',' + number(p.y);
  }
  return out;
}

}  // namespace

SvgCanvas::SvgCanvas(const FontMetrics& font, int width, int height, Color paper) : Canvas(font) {
  head_ = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"DejaVu Sans, Bitstream Vera Sans, Verdana, sans-serif\">\n",
      width, height);
  body_ = "<rect width=\"100%\" height=\"100%\"" + paint("fill", paper) + "/>\n";
}

void SvgCanvas::polyline(std::span<const Point> points, const Stroke& stroke, bool closed) {
  if (points.size() < 2) return;
  body_ += fmt::format("<{} points=\"{}\" fill=\"none\"{} stroke-width=\"{}\" stroke-linejoin=\"round\"",
                       closed ? "polygon" : "polyline", path(points), paint("stroke", stroke.color),
                       number(stroke.width));
  if (stroke.dash_on > 0) {
    body_ += fmt::format(" stroke-dasharray=\"{} {}\"", number(stroke.dash_on), number(stroke.dash_off));
  }
  body_ += "/>\n";
}

void SvgCanvas::fill_polygon(std::span<const Point> convex, Color color) {
  body_ += fmt::format("<polygon points=\"{}\"{}/>\n", path(convex), paint("fill", color));
}

void SvgCanvas::fill_rect(const Rect& rect, Color color, double corner_radius) {
  if (!(rect.w > 0) || !(rect.h > 0)) return;
  body_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"", number(rect.x), number(rect.y),
                       number(rect.w), number(rect.h));
  if (corner_radius > 0) body_ += fmt::format(" rx=\"{}\"", number(corner_radius));
  body_ += paint("fill", color) + "/>\n";
}

void SvgCanvas::fill_circle(const Point& center, double radius, Color color) {
  body_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"{}/>\n", number(center.x), number(center.y),
                       number(radius), paint("fill", color));
}

void SvgCanvas::text(const Point& at, std::string_view rich, const TextStyle& style) {
  const TextLayout layout = layout_text(font(), rich, style.size);
  if (layout.runs.empty()) return;
  const double down = baseline_offset(style.y, style.size);
  const char* align = style.x == AlignX::left ? "start" : style.x == AlignX::center ? "middle" : "end";
  body_ += "<text xml:space=\"preserve\"";
  if (style.vertical) {
    body_ += fmt::format(" transform=\"translate({} {}) rotate(-90)\"", number(at.x + down), number(at.y));
  } else {
    body_ += fmt::format(" x=\"{}\" y=\"{}\"", number(at.x), number(at.y + down));
  }
  body_ += fmt::format(" font-size=\"{}\" text-anchor=\"{}\"", number(style.size), align) +
           paint("fill", style.color);
  if (style.halo > 0) {
    body_ += fmt::format("{} stroke-width=\"{}\" stroke-linejoin=\"round\" paint-order=\"stroke\"",
                         paint("stroke", style.halo_color), number(2 * style.halo));
  }
  body_ += '>';
  // Runs are placed relative to each other, so its place holds even where another font steps in.
  double pen = 0, baseline = 0;
  for (const TextRun& run : layout.runs) {
    const double dx = run.x - pen, dy = run.y - baseline;
    const bool plain = run.size == style.size && !run.italic && std::abs(dx) < 0.01 && std::abs(dy) < 0.01;
    if (plain) {
      body_ += escape_markup(run.text);
    } else {
      body_ += "<tspan";
      if (std::abs(dx) >= 0.01) body_ += fmt::format(" dx=\"{}\"", number(dx));
      if (std::abs(dy) >= 0.01) body_ += fmt::format(" dy=\"{}\"", number(dy));
      if (run.size != style.size) body_ += fmt::format(" font-size=\"{}\"", number(run.size));
      if (run.italic) body_ += " font-style=\"italic\"";
      body_ += fmt::format(">{}</tspan>", escape_markup(run.text));
    }
    pen = run.x + run.width;
    baseline = run.y;
  }
  body_ += "</text>\n";
}

void SvgCanvas::push_clip(const Rect& rect) {
  definitions_ +=
      fmt::format("<clipPath id=\"clip{}\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>\n",
                  clips_, number(rect.x), number(rect.y), number(rect.w), number(rect.h));
  body_ += fmt::format("<g clip-path=\"url(#clip{})\">\n", clips_);
  ++clips_;
  ++open_clips_;
}

void SvgCanvas::pop_clip() {
  if (open_clips_ == 0) return;
  body_ += "</g>\n";
  --open_clips_;
}

std::string SvgCanvas::finish() {
  while (open_clips_ > 0) pop_clip();
  std::string out = head_;
  if (!definitions_.empty()) out += "<defs>\n" + definitions_ + "</defs>\n";
  return out + body_ + "</svg>\n";
}

std::string picture_to_svg(const Picture& picture, int width, int height, Color paper) {
  const FontMetrics font;
  SvgCanvas canvas(font, width, height, paper);
  picture(canvas, width, height);
  return canvas.finish();
}

}  // namespace pabd
