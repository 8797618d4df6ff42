// SPDX-License-Identifier: MIT
// See view_marks.h.
#include "app/overlay/view_marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/plots/rich_text.h"
#include "app/plots/theme.h"

namespace pabd {
namespace {

// px at scale 1
constexpr double kMargin = 16, kArm = 30, kLetter = 11, kHead = 7;
constexpr double kLongest = 150, kTick = 7, kText = 11.5;

Color ink_of(const std::uint8_t (&c)[3]) { return {c[0], c[1], c[2]}; }
Color halo_of(const MarkInks& inks) { return {inks.halo[0], inks.halo[1], inks.halo[2], inks.halo[3]}; }

}  // namespace

double round_length(double pixel, double most) {
  const double longest = pixel * most;
  if (!(longest > 0) || !std::isfinite(longest)) return 0;
  double power = std::pow(10, std::floor(std::log10(longest)));
  if (10 * power <= longest) power *= 10;  // the logarithm was rounded
  for (const double step : {5.0, 2.0}) {
    if (step * power <= longest) return step * power;
  }
  return power;
}

std::string length_text(double metres) {
  if (metres >= 999.5) return fmt::format("{:g} km", metres / 1000);
  if (metres >= 0.9995) return fmt::format("{:g} m", metres);
  if (metres >= 0.009995) return fmt::format("{:g} cm", 100 * metres);
  return fmt::format("{:.6g} mm", 1000 * metres);
}

void paint_axes(const Camera& camera, const MarkInks& inks, const Rect& free, double scale, Canvas& canvas) {
  const double reach = (kArm + kLetter + kMargin) * scale;
  if (free.w < 2 * reach || free.h < 2 * reach) return;
  const Color halo = halo_of(inks);
  const Mat4f view = view_matrix(camera);
  const Point origin{std::round(free.x + reach), std::round(free.bottom() - reach)};
  struct Arm {
    int axis;
    double depth;  // towards the eye
  };
  std::array<Arm, 3> arms{};
  for (int k = 0; k < 3; ++k) arms[static_cast<std::size_t>(k)] = {k, static_cast<double>(view(2, k))};
  // Far ones first.
  std::sort(arms.begin(), arms.end(), [](const Arm& a, const Arm& b) { return a.depth < b.depth; });
  for (const Arm& arm : arms) {
    const double x = static_cast<double>(view(0, arm.axis)), y = -static_cast<double>(view(1, arm.axis));
    const double length = std::hypot(x, y);
    const Color ink = ink_of(inks.axes[arm.axis]);
    const Point tip{origin.x + kArm * scale * x, origin.y + kArm * scale * y};
    const char* name = arm.axis == 0 ? "x" : arm.axis == 1 ? "y" : "z";
    TextStyle text{kLetter * scale, ink, AlignX::center, AlignY::middle, false, 2.5 * scale, halo};
    if (length < 0.12) {  // along the line of sight: a dot, with its letter beside it
      canvas.fill_circle(origin, 4.5 * scale, halo);
      canvas.fill_circle(origin, 3.2 * scale, ink);
      canvas.text({origin.x + 10 * scale, origin.y + 10 * scale}, name, text);
      continue;
    }
    const std::array<Point, 2> line{origin, tip};
    canvas.polyline(line, {halo, 4.5 * scale});
    canvas.arrow(origin, tip, {ink, 2 * scale}, std::min(kHead, 0.7 * kArm * length) * scale);
    const double out = kArm + 0.8 * kLetter / std::max(length, 0.3);
    canvas.text({origin.x + out * scale * x, origin.y + out * scale * y}, name, text);
  }
}

void paint_scale_bar(const Camera& camera, const MarkInks& inks, double picture_height, const Rect& free,
                     double scale, Canvas& canvas) {
  const double margin = kMargin * scale, most = std::min(kLongest * scale, 0.4 * free.w);
  const double distance = static_cast<double>((camera.eye - camera.target).norm());
  const double pixel =
      2 * static_cast<double>(half_height(camera)) * (camera.orthographic ? 1 : distance) / picture_height;
  const double length = round_length(pixel, most);
  if (!(length > 0) || free.h < 4 * margin || most < 20 * scale) return;
  const Color halo = halo_of(inks), ink = ink_of(inks.text);
  const double right = std::round(free.right() - margin), left = right - length / pixel;
  const double y = std::round(free.bottom() - margin), tick = kTick * scale;
  const std::array<Point, 4> bar{Point{left, y - tick}, {left, y}, {right, y}, {right, y - tick}};
  canvas.polyline(bar, {halo, 5 * scale});
  canvas.polyline(bar, {ink, 1.8 * scale});
  const std::string text = length_text(length) + (camera.orthographic ? "" : " in the middle");
  const bool fits = text_width(canvas.font(), text, kText * scale) <= length / pixel - 6 * scale;
  const TextStyle style{kText * scale, ink, fits ? AlignX::center : AlignX::right, AlignY::baseline, false,
                        2.5 * scale,   halo};
  canvas.text({fits ? 0.5 * (left + right) : right, y - (fits ? 5 * scale : tick + 4 * scale)}, text, style);
}

}  // namespace pabd
