// SPDX-License-Identifier: MIT
// A solid of the table against anything: the polyhedron that stands for it. That of a round one is turned
// about its axis until one of its corners points at what it touches, or a side at another round one; what is found there
// is put on the round surface (round_sides.cpp).
//
//   u      direction towards what is touched, in the body frame       m
#include "sim/body/compound.h"
#include "sim/body/frustum.h"
#include "sim/body/shape_kind.h"
#include "sim/collision/hull_view.h"
#include "sim/collision/narrow_phase.h"

namespace pabd::narrow {
namespace {

constexpr double kUpright = 0.05;  // sine of the angle to the axis below which a solid is not turned
constexpr double kMeet = 1e-9;     // how far apart axes are that meet, beside their sizes

const ShapeKind& kind_of(const Solid& solid) { return *solid.data->kind; }

struct Axis {
  Vec3 middle, along;
  double half;
};

Axis axis_of(const Placed<Capsule>& capsule) {
  return {capsule.c, capsule.R.col(1), 0.5 * capsule.shape.length};
}

Axis axis_of(const Placed<Shape>& solid) {
  const auto support = as<Solid>(solid.shape).data->kind->support;
  const double high = support(solid.shape, Vec3::UnitY()), low = -support(solid.shape, -Vec3::UnitY());
  return {solid.c + 0.5 * (low + high) * solid.R.col(1), solid.R.col(1), 0.5 * (high - low)};
}

// Between the nearest points of two axes; zero where they meet, since what is left of the way there is rounding
// and tells no direction.
Vec3 between(const Axis& a, const Axis& b) {
  const Vec3 w = a.middle - b.middle;
  const double uv = a.along.dot(b.along), uw = a.along.dot(w), vw = b.along.dot(w);
  const double sine2 = 1 - uv * uv;
  double s = sine2 > 1e-6 ? std::clamp((uv * vw - uw) / sine2, -a.half, a.half) : 0.0;
  const double t = std::clamp(uv * s + vw, -b.half, b.half);
  s = std::clamp(uv * t - uw, -a.half, a.half);
  const Vec3 way = t * b.along - s * a.along - w;
  const bool meet = !(way.norm() > kMeet * (a.half + b.half + w.norm()));
  return meet ? Vec3(Vec3::Zero()) : way;
}

// The face of a polyhedron that is farthest from the solid, or least deep in it.
struct Face {
  double distance = -kNone;
  Vec3 normal = Vec3::UnitY();  // out of the polyhedron, world
};

Face farthest_face(const Placed<Shape>& body, std::span<const HullFace> faces, const Vec3& c, const Mat3& R) {
  const auto support = as<Solid>(body.shape).data->kind->support;
  Face out;
  for (const HullFace& face : faces) {
    const Vec3 n = R * face.normal;
    const double distance = n.dot(body.c - c) - face.offset - support(body.shape, -(body.R.transpose() * n));
    if (distance > out.distance) out = {distance, n};
  }
  return out;
}

// Towards what `body` touches of the other one; of any length.
struct Towards {
  const Placed<Shape>& body;
  const Placed<Shape>& other;

  Vec3 operator()(const Plane& plane) const { return -plane.normal; }
  Vec3 operator()(const Sphere&) const { return between(axis_of(body), {other.c, other.R.col(1), 0}); }
  Vec3 operator()(const Capsule& capsule) const {
    return between(axis_of(body), axis_of(Placed<Capsule>{capsule, other.c, other.R, other.number}));
  }
  Vec3 operator()(const Solid&) const { return between(axis_of(body), axis_of(other)); }
  Vec3 operator()(const Box& box) const {
    const BoxHull hull(box.half);
    return -farthest_face(body, hull.faces, other.c, other.R).normal;
  }
  Vec3 operator()(const Hull& hull) const {
    return -farthest_face(body, hull.data->faces, other.c, other.R).normal;
  }
  Vec3 operator()(const Compound& compound) const {
    Face nearest{kNone, Vec3::UnitY()};
    for (const CompoundPart& part : compound.data->parts) {
      const Face face =
          farthest_face(body, part.hull().data->faces, other.c + other.R * part.offset, other.R);
      if (face.distance < nearest.distance) nearest = face;
    }
    return -nearest.normal;
  }
};

}  // namespace

double facet_depth(const Shape& shape) {
  const auto* solid = std::get_if<Solid>(&shape);
  if (!solid || !kind_of(*solid).round_about_y) return 0;
  const Frustum frustum = frustum_of(shape);
  return std::max(frustum.r_low, frustum.r_high) * (1 - std::cos(kPi / kFacets));
}

Mat3 facing(const Placed<Shape>& body, const Placed<Shape>& other) {
  const Mat3& R = body.R;
  const auto* solid = std::get_if<Solid>(&body.shape);
  if (!solid || !kind_of(*solid).round_about_y) return R;
  const Vec3 u = R.transpose() * std::visit(Towards{body, other}, other.shape);
  const double across = std::hypot(u.x(), u.z());
  if (!(across > kUpright * u.norm())) return R;
  // Another round one: a side of the facets, so that no edge of it cuts the line along which they touch.
  const auto* solid_too = std::get_if<Solid>(&other.shape);
  const double ahead = solid_too && kind_of(*solid_too).round_about_y ? kPi / kFacets : 0;
  const double cosine = std::cos(ahead), sine = std::sin(ahead);
  const double x = (u.x() * cosine - u.z() * sine) / across, z = (u.z() * cosine + u.x() * sine) / across;
  Mat3 turned;
  turned << x * R.col(0) + z * R.col(2), R.col(1), x * R.col(2) - z * R.col(0);
  return turned;
}

}  // namespace pabd::narrow
