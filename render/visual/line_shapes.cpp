// SPDX-License-Identifier: MIT
// Curves made of lines: arcs in pieces of equal angle, coils in pieces of a turn.
#include "render/visual/line_shapes.h"

#include <algorithm>
#include <cmath>

namespace pabd {
namespace {

constexpr double kFrameHeight = 720;   // px; line widths count in these as well
constexpr double kFarAway = 1e5;       // in distances of eye and target
constexpr double kArcStep = 0.16;      // rad of a piece of an arc
constexpr int kCoilPieces = 14;        // a turn
constexpr double kStraightEnd = 0.14;  // of a coil's length, at each end

}  // namespace

PixelMeter::PixelMeter(const Camera& camera)
    : eye_(eye_of(camera)),
      forward_((camera.target - camera.eye).cast<double>().stableNormalized()),
      orthographic_(camera.orthographic),
      slope_(2 * static_cast<double>(half_height(camera)) / kFrameHeight) {}

Vec3 eye_of(const Camera& camera) {
  const Vec3 eye = camera.eye.cast<double>(), back = eye - camera.target.cast<double>();
  return camera.orthographic ? Vec3(eye + kFarAway * back) : eye;
}

double PixelMeter::at(const Vec3& p) const {
  if (orthographic_) return slope_;
  return slope_ * std::max((p - eye_).dot(forward_), 0.02 * (p - eye_).norm());
}

Vec3 PixelMeter::to_eye(const Vec3& p) const {
  const Vec3 v = eye_ - p;
  return v.norm() > 0 ? Vec3(v.normalized()) : Vec3(-forward_);
}

void add_line(VisualScene& out, const Vec3& a, const Vec3& b, const Pen& pen) {
  out.lines.push_back(
      {a.cast<float>(), b.cast<float>(), pen.color, static_cast<float>(pen.width), pen.on_top});
}

void add_arc(VisualScene& out, const Vec3& c, const Vec3& u, const Vec3& w, double radius, double from,
             double to, const Pen& pen) {
  const double span = std::clamp(to - from, -2 * kPi, 2 * kPi);
  const int pieces = static_cast<int>(std::ceil(std::abs(span) / kArcStep));
  const auto point = [&](int k) -> Vec3 {
    const double t = from + span * k / pieces;
    return c + radius * (std::cos(t) * u + std::sin(t) * w);
  };
  for (int k = 0; k < pieces; ++k) add_line(out, point(k), point(k + 1), pen);
}

void add_coil(VisualScene& out, const Vec3& a, const Vec3& b, double radius, int turns, bool flat,
              const Vec3& side, const Pen& pen) {
  const Vec3 along = b - a;
  const double length = along.norm();
  if (!(length > 0) || turns < 1) return;
  const Vec3 n = along / length;
  Vec3 u = side - side.dot(n) * n;
  u = u.norm() > 1e-6 ? u.normalized() : n.unitOrthogonal();
  const Vec3 w = n.cross(u);
  const Vec3 first = a + kStraightEnd * along, last = b - kStraightEnd * along;
  const int pieces = turns * (flat ? 2 : kCoilPieces);
  // A zig-zag swings from one side to the other; it starts and ends on the axis, as the coil's ends do.
  const auto point = [&](int k) -> Vec3 {
    if (k < 0) return a;
    if (k > pieces) return b;
    const Vec3 on_axis = first + (last - first) * (static_cast<double>(k) / pieces);
    if (k == 0 || k == pieces) return on_axis;
    const double t = 2 * kPi * turns * k / pieces;
    return flat ? Vec3(on_axis + (k % 2 == 0 ? radius : -radius) * u)
                : Vec3(on_axis + radius * (std::cos(t) * u + std::sin(t) * w));
  };
  for (int k = -1; k <= pieces; ++k) add_line(out, point(k), point(k + 1), pen);
}

}  // namespace pabd
