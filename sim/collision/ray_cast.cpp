// Every convex shape cuts an interval out of the line of the ray; its ends are the two hits. In the frame of
// the shape:
//
//   x(t) = o + t u        ‖u‖ = 1                                              m
//   half space            n·x ≤ offset:  t ≤ or ≥ (offset − n·o) / (n·u)
//   ball, cylinder        t = −b ± √(r² − ‖o − b u‖²), b = o·u, without the part along a cylinder's axis
//   capsule               one interval from the first to the last of cylinder and both balls: it is convex
#include "sim/collision/ray_cast.h"

#include <cmath>
#include <limits>

#include "sim/body/compound.h"

namespace pabd {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Line {
  Vec3 o, u;  // u is a unit vector
};

// Empty while in > out.
struct Interval {
  double in = -kInfinity, out = kInfinity;
  Vec3 n_in = Vec3::Zero(), n_out = Vec3::Zero();

  bool empty() const { return in > out; }
};

Interval nothing() { return {kInfinity, -kInfinity, Vec3::Zero(), Vec3::Zero()}; }

void clip(const Line& line, const Vec3& n, double offset, Interval& cut) {
  const double above = n.dot(line.o) - offset, slope = n.dot(line.u);
  if (slope == 0) {
    if (above > 0) cut = nothing();
    return;
  }
  const double t = -above / slope;
  if (slope < 0 && t > cut.in) {
    cut.in = t;
    cut.n_in = n;
  } else if (slope > 0 && t < cut.out) {
    cut.out = t;
    cut.n_out = n;
  }
}

Interval ball(const Line& line, const Vec3& centre, double radius) {
  const Vec3 o = line.o - centre;
  const double b = o.dot(line.u);
  const double rest = radius * radius - (o - b * line.u).squaredNorm();
  if (!(rest >= 0)) return nothing();
  const double half = std::sqrt(rest);
  return {-b - half, -b + half, (o - (b + half) * line.u).normalized(),
          (o - (b - half) * line.u).normalized()};
}

Interval cut_by(const Line& line, const Sphere& sphere) { return ball(line, Vec3::Zero(), sphere.radius); }

Interval cut_by(const Line& line, const Box& box) {
  Interval cut;
  for (int k = 0; k < 3; ++k) {
    clip(line, Vec3::Unit(k), box.half[k], cut);
    clip(line, -Vec3::Unit(k), box.half[k], cut);
  }
  return cut;
}

Interval cut_by(const Line& line, const Plane& plane) {
  Interval cut;
  clip(line, plane.normal, plane.offset, cut);
  return cut;
}

Interval cut_by(const Line& line, const Hull& hull) {
  Interval cut;
  for (const HullFace& face : hull.data->faces) clip(line, face.normal, face.offset, cut);
  return cut;
}

// The round side of a capsule, along y between its ends.
Interval cylinder(const Line& line, const Capsule& capsule) {
  const Vec3 o(line.o.x(), 0, line.o.z()), u(line.u.x(), 0, line.u.z());
  const double along = u.squaredNorm();
  Interval cut;
  if (along > 0) {
    const double b = o.dot(u) / along;
    const double rest = capsule.radius * capsule.radius - (o - b * u).squaredNorm();
    if (!(rest >= 0)) return nothing();
    const double half = std::sqrt(rest / along);
    cut = {-b - half, -b + half, (o - (b + half) * u).normalized(), (o - (b - half) * u).normalized()};
  } else if (o.squaredNorm() > capsule.radius * capsule.radius) {
    return nothing();
  }
  clip(line, Vec3::UnitY(), 0.5 * capsule.length, cut);
  clip(line, -Vec3::UnitY(), 0.5 * capsule.length, cut);
  return cut;
}

Interval cut_by(const Line& line, const Capsule& capsule) {
  Interval cut = nothing();
  const Vec3 end(0, 0.5 * capsule.length, 0);
  // The balls first: where they meet the cylinder, the normals of its flat ends do not count.
  for (const Interval& part :
       {ball(line, end, capsule.radius), ball(line, -end, capsule.radius), cylinder(line, capsule)}) {
    if (part.empty()) continue;
    if (part.in < cut.in) {
      cut.in = part.in;
      cut.n_in = part.n_in;
    }
    if (part.out > cut.out) {
      cut.out = part.out;
      cut.n_out = part.n_out;
    }
  }
  return cut;
}

std::optional<SurfaceHit> first_of(const Interval& cut) {
  if (cut.empty() || cut.out < 0) return std::nullopt;
  if (cut.in >= 0) return SurfaceHit{cut.in, cut.n_in};
  if (cut.out < kInfinity) return SurfaceHit{cut.out, cut.n_out};
  return std::nullopt;
}

struct Cast {
  const Line& line;

  std::optional<SurfaceHit> operator()(const Compound& compound) const {
    std::optional<SurfaceHit> first;
    for (const CompoundPart& part : compound.data->parts) {
      const auto hit = first_of(cut_by(Line{line.o - part.offset, line.u}, part.hull));
      if (hit && (!first || hit->t < first->t)) first = hit;
    }
    return first;
  }
  std::optional<SurfaceHit> operator()(const auto& shape) const { return first_of(cut_by(line, shape)); }
};

bool is_usable(const Ray& ray) {
  return ray.origin.allFinite() && ray.direction.allFinite() && ray.direction.stableNorm() > 0;
}

// `line` in the world, t in metres.
std::optional<SurfaceHit> meet(const Shape& shape, const Vec3& c, const Mat3& R, const Line& line) {
  if (std::holds_alternative<Plane>(shape)) return std::visit(Cast{line}, shape);
  const Vec3 between = line.o - c;
  const double b = between.dot(line.u), radius = bounding_radius(shape);
  if ((between - b * line.u).squaredNorm() > radius * radius * (1 + 1e-9)) return std::nullopt;
  auto hit = std::visit(Cast{{R.transpose() * between, R.transpose() * line.u}}, shape);
  if (hit) hit->normal = R * hit->normal;
  return hit;
}

}  // namespace

std::optional<SurfaceHit> ray_cast(const Shape& shape, const Vec3& c, const Mat3& R, const Ray& ray) {
  if (!is_usable(ray)) return std::nullopt;
  const double length = ray.direction.stableNorm();
  auto hit = meet(shape, c, R, {ray.origin, ray.direction / length});
  if (hit) hit->t /= length;
  return hit;
}

std::optional<RayHit> ray_cast(const Model& model, const State& state, const Ray& ray) {
  if (!is_usable(ray)) return std::nullopt;
  const double length = ray.direction.stableNorm();
  const Line line{ray.origin, ray.direction / length};
  std::optional<RayHit> first;
  for (std::size_t i = 0; i < model.shape.size(); ++i) {
    const auto hit = meet(model.shape[i], state.c[i], state.R[i], line);
    if (hit && (!first || hit->t < first->t)) first = {static_cast<Index>(i), hit->t, {}, hit->normal};
  }
  if (first) {
    first->point = line.o + first->t * line.u;
    first->t /= length;
  }
  return first;
}

}  // namespace pabd
