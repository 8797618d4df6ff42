// SPDX-License-Identifier: MIT
// Outlines of convex bodies in perspective.
//
//   e          eye                                                                        m
//   r, D       radius of a ball, distance of its centre from the eye                      m
//   circle     a ball's outline: centre c + (r²/D) v, radius r √(1 − r²/D²), across v, the unit vector to e
//   ρ          of a round side about the axis u: its radius at the height of the eye, a cone being drawn out
//   q          distance of e from the axis; the side turns away from e at the angle acos(ρ/q) from e's own
//
// A polyhedron's outline is every edge between a face that looks at the eye and one that does not.
#include "render/visual/outline.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/visual/contact_glyphs.h"
#include "render/visual/line_shapes.h"
#include "render/visual/palette.h"
#include "sim/body/shape_kind.h"

namespace pabd {
namespace {

constexpr std::uint32_t kAmber = 0xffb31a, kRimColor = 0x1c1a22;
constexpr double kInnerWidth = 2.6, kOuterWidth = 5.4;  // pixels at 720 px frame height
constexpr double kLeastRing = 11;                       // pixels

// The outline of a shape as line pieces: first in the wide dark pen, then in the narrow light one.
class OutlinePainter {
 public:
  OutlinePainter(const Pose& pose, const Pen& pen, VisualScene& out)
      : pose_(pose), eye_(eye_of(out.camera)), pen_(pen), out_(out) {}

  void operator()(const SurfacePart& part) const {
    const double y = part.at.y();
    switch (part.form) {
      case SurfaceForm::box:
        return box(part.size);
      case SurfaceForm::ball:
        return ball(at(part), part.size.x(), Vec3::Zero());
      case SurfaceForm::half_ball:
        return ball(at(part), part.size.x(), (part.upside_down ? -1 : 1) * pose_.R.col(1));
      case SurfaceForm::tube:
      case SurfaceForm::cylinder:
        return side({y + part.size.y(), part.size.x()}, {y - part.size.y(), part.size.x()},
                    part.form == SurfaceForm::cylinder);
      case SurfaceForm::cone:
        return side({y + part.size.y(), 0}, {y, part.size.x()}, true);
      case SurfaceForm::polyhedron:
        return polyhedron(*part.hull->data, part.at);
    }
  }

 private:
  Vec3 at(const SurfacePart& part) const { return pose_.c + pose_.R * part.at; }

  void line(const Vec3& a, const Vec3& b) const {
    add_line(out_, pose_.c + pose_.R * a, pose_.c + pose_.R * b, pen_);
  }

  // The part of a ball's outline on the side of `half`; all of it if that is zero.
  void ball(const Vec3& centre, double r, const Vec3& half) const {
    const Vec3 to_eye = eye_ - centre;
    const double distance = to_eye.norm();
    if (distance <= 1.0001 * r) return;
    const Vec3 v = to_eye / distance;
    const Vec3 c = centre + r * r / distance * v;
    const double radius = r * std::sqrt(1 - r * r / (distance * distance));
    if (half.isZero()) {
      const Vec3 a = v.unitOrthogonal();
      return add_arc(out_, c, a, v.cross(a), radius, 0, 2 * kPi, pen_);
    }
    // In the frame whose first axis is the half's own direction across v, the arc is symmetric.
    const Vec3 across = half - half.dot(v) * v;
    const double length = std::max(across.norm(), 1e-12);
    const double least =
        -r / distance * half.dot(v) * r;  // of radius · length · cos, where the other half begins
    const double bound = least / (radius * length);
    if (bound >= 1) return;
    if (bound <= -1) return ball(centre, r, Vec3::Zero());
    const Vec3 a = across / length;
    const double reach = std::acos(bound);
    add_arc(out_, c, a, v.cross(a), radius, -reach, reach, pen_);
  }

  void box(const Vec3& half) const {
    const Vec3 local = pose_.R.transpose() * (eye_ - pose_.c);
    const auto seen = [&](int axis, int sign) { return sign * local[axis] > half[axis]; };
    for (int axis = 0; axis < 3; ++axis) {
      const int j = (axis + 1) % 3, k = (axis + 2) % 3;
      for (const int sj : {-1, 1}) {
        for (const int sk : {-1, 1}) {
          if (seen(j, sj) == seen(k, sk)) continue;
          Vec3 a = Vec3::Zero();
          a[j] = sj * half[j];
          a[k] = sk * half[k];
          Vec3 b = a;
          a[axis] = -half[axis];
          b[axis] = half[axis];
          line(a, b);
        }
      }
    }
  }

  // A circle about the body's y axis; a point where its radius is 0.
  struct Rim {
    double y, radius;
  };

  // The round side between two rims about the y axis: two lines, where it turns away from the eye. With flat
  // ends also the part of each rim between an end and a side of which the eye sees only one.
  void side(const Rim& top, const Rim& bottom, bool flat_ends) const {
    const Vec3 u = pose_.R.col(1);
    const double height = u.dot(eye_ - pose_.c);
    const Vec3 q = (eye_ - pose_.c) - height * u;
    const double level = q.norm(), slope = (bottom.radius - top.radius) / (top.y - bottom.y);
    const double radius = bottom.radius - slope * (height - bottom.y);  // of the side, drawn out to the eye
    const Vec3 v = level > 0 ? Vec3(q / level) : u.unitOrthogonal(), across = u.cross(v);
    const auto on = [&](const Rim& rim, double cosine, double sine) -> Vec3 {
      return pose_.c + rim.y * u + rim.radius * (cosine * v + sine * across);
    };
    const bool two_lines = std::abs(radius) < level;
    if (two_lines) {
      for (const double sign : {-1.0, 1.0}) {
        const double cosine = radius / level, sine = sign * std::sqrt(1 - radius * radius / (level * level));
        add_line(out_, on(top, cosine, sine), on(bottom, cosine, sine), pen_);
      }
    }
    if (!flat_ends) return;
    // The eye sees the side within `half` of the direction v.
    const double half = two_lines ? std::acos(radius / level) : radius < 0 ? kPi : 0;
    for (const auto& [rim, end_seen] : {std::pair{top, height > top.y}, {bottom, height < bottom.y}}) {
      const double from = end_seen ? half : -half, to = end_seen ? 2 * kPi - half : half;
      if (rim.radius > 0 && to > from)
        add_arc(out_, pose_.c + rim.y * u, v, across, rim.radius, from, to, pen_);
    }
  }

  void polyhedron(const HullData& hull, const Vec3& offset) const {
    const Vec3 local = pose_.R.transpose() * (eye_ - pose_.c) - offset;
    const auto seen = [&](std::uint16_t face) {
      return hull.faces[face].normal.dot(local) > hull.faces[face].offset;
    };
    for (const HullEdge& edge : hull.edges) {
      if (seen(edge.left) != seen(edge.right))
        line(offset + hull.vertices[edge.from], offset + hull.vertices[edge.to]);
    }
  }

  const Pose& pose_;
  Vec3 eye_;
  Pen pen_;
  VisualScene& out_;
};

constexpr std::array<std::pair<std::uint32_t, double>, 2> kPens = {
    {{kRimColor, kOuterWidth}, {kAmber, kInnerWidth}}};

Vec3 towards_eye(const Vec3& p, const VisualScene& out) { return PixelMeter(out.camera).to_eye(p); }

}  // namespace

void add_outline(const Shape& shape, const Pose& pose, VisualScene& out) {
  if (!pose.c.allFinite() || !pose.R.allFinite()) return;
  std::vector<SurfacePart> parts;
  kind_of(shape).surface(shape, parts);
  for (const auto& [ink, width] : kPens)
    for (const SurfacePart& part : parts) OutlinePainter(pose, {srgb_color(ink), width}, out)(part);
}

void add_ring(const Vec3& centre, double radius, VisualScene& out) {
  if (!centre.allFinite() || !std::isfinite(radius)) return;
  const double least = kLeastRing * PixelMeter(out.camera).at(centre);
  const Vec3 a = towards_eye(centre, out).unitOrthogonal(), b = towards_eye(centre, out).cross(a);
  for (const auto& [ink, width] : kPens)
    add_arc(out, centre, a, b, std::max(radius, least), 0, 2 * kPi, {srgb_color(ink), width});
}

void add_spring(const Vec3& hand, const Vec3& body, VisualScene& out) {
  if (!hand.allFinite() || !body.allFinite()) return;
  constexpr int kTurns = 9;
  constexpr double kRadius = 7, kDot = 6;  // pixels
  const double pixel = PixelMeter(out.camera).at(hand);
  const Vec3 side = (body - hand).cross(towards_eye(hand, out));
  for (const auto& [ink, width] : kPens)
    add_coil(out, hand, body, kRadius * pixel, kTurns, true, side, {srgb_color(ink), width});
  for (const auto& [ink, radius] : {std::pair{kRimColor, kDot}, {kAmber, kDot - 1.8}}) {
    const Vec3 v = towards_eye(hand, out);
    const double lift = ink == kAmber ? 0.5 * pixel : 0;
    out.instances[static_cast<int>(Primitive::disc)].push_back(
        {place_along(hand + lift * v, v, radius * pixel, radius * pixel), srgb_color(ink), false, false,
         true});
  }
  add_ring(body, 0, out);
}

}  // namespace pabd
