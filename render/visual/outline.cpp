// Outlines of convex bodies in perspective.
//
//   e          eye                                                                        m
//   r, D       radius of a ball, distance of its centre from the eye                      m
//   circle     a ball's outline: centre c + (r²/D) v, radius r √(1 − r²/D²), across v, the unit vector to e
//   n          of a capsule with axis u: where a plane through e touches its side, n·u = 0 and n·(e − c) = r
//
// A polyhedron's outline is every edge between a face that looks at the eye and one that does not.
#include "render/visual/outline.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/visual/contact_glyphs.h"
#include "render/visual/line_shapes.h"
#include "render/visual/palette.h"
#include "sim/body/compound.h"

namespace pabd {
namespace {

constexpr std::uint32_t kAmber = 0xffb31a, kRim = 0x1c1a22;
constexpr double kInnerWidth = 2.6, kOuterWidth = 5.4;  // pixels at 720 px frame height
constexpr double kLeastRing = 11;                       // pixels

// The outline of a shape as line pieces: first in the wide dark pen, then in the narrow light one.
class OutlinePainter {
 public:
  OutlinePainter(const Pose& pose, const Pen& pen, VisualScene& out)
      : pose_(pose), eye_(out.camera.eye.cast<double>()), pen_(pen), out_(out) {}

  void operator()(const Sphere& sphere) const { ball(pose_.c, sphere.radius, Vec3::Zero()); }

  void operator()(const Capsule& capsule) const {
    const Vec3 u = pose_.R.col(1);
    const double r = capsule.radius;
    const Vec3 ends[2] = {pose_.c + 0.5 * capsule.length * u, pose_.c - 0.5 * capsule.length * u};
    const Vec3 q = (eye_ - pose_.c) - u.dot(eye_ - pose_.c) * u;
    const double level = q.norm();
    if (level <= r) {  // seen along the axis: the nearer end hides the rest
      const bool first = u.dot(eye_ - pose_.c) > 0;
      return ball(ends[first ? 0 : 1], r, Vec3::Zero());
    }
    ball(ends[0], r, u);
    ball(ends[1], r, -u);
    const Vec3 v = q / level, side = u.cross(v);
    for (const double sign : {-1.0, 1.0}) {
      const Vec3 n = r / level * v + sign * std::sqrt(1 - r * r / (level * level)) * side;
      add_line(out_, ends[0] + r * n, ends[1] + r * n, pen_);
    }
  }

  void operator()(const Box& box) const {
    const Vec3 local = pose_.R.transpose() * (eye_ - pose_.c);
    const auto seen = [&](int axis, int sign) { return sign * local[axis] > box.half[axis]; };
    for (int axis = 0; axis < 3; ++axis) {
      const int j = (axis + 1) % 3, k = (axis + 2) % 3;
      for (const int sj : {-1, 1}) {
        for (const int sk : {-1, 1}) {
          if (seen(j, sj) == seen(k, sk)) continue;
          Vec3 a = Vec3::Zero();
          a[j] = sj * box.half[j];
          a[k] = sk * box.half[k];
          Vec3 b = a;
          a[axis] = -box.half[axis];
          b[axis] = box.half[axis];
          line(a, b);
        }
      }
    }
  }

  void operator()(const Hull& hull) const { polyhedron(*hull.data, Vec3::Zero()); }
  void operator()(const Compound& compound) const {
    for (const CompoundPart& part : compound.data->parts) polyhedron(*part.hull.data, part.offset);
  }
  void operator()(const Plane&) const {}

 private:
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
    const double length = across.norm();
    const double least =
        -r / distance * half.dot(v) * r;  // of radius · length · cos, where the other half begins
    if (length < 1e-9) return;
    const double bound = std::clamp(least / (radius * length), -1.0, 1.0);
    const Vec3 a = across / length;
    const double reach = std::acos(bound);
    add_arc(out_, c, a, v.cross(a), radius, -reach, reach, pen_);
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
    {{kRim, kOuterWidth}, {kAmber, kInnerWidth}}};

Vec3 towards_eye(const Vec3& p, const VisualScene& out) { return PixelMeter(out.camera).to_eye(p); }

}  // namespace

void add_outline(const Shape& shape, const Pose& pose, VisualScene& out) {
  if (!pose.c.allFinite() || !pose.R.allFinite()) return;
  for (const auto& [ink, width] : kPens)
    std::visit(OutlinePainter(pose, {srgb_color(ink), width}, out), shape);
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
  for (const auto& [ink, radius] : {std::pair{kRim, kDot}, {kAmber, kDot - 1.8}}) {
    const Vec3 v = towards_eye(hand, out);
    const double lift = ink == kAmber ? 0.5 * pixel : 0;
    out.instances[static_cast<int>(Primitive::disc)].push_back(
        {place_along(hand + lift * v, v, radius * pixel, radius * pixel), srgb_color(ink), false, false,
         true});
  }
  add_ring(body, 0, out);
}

}  // namespace pabd
