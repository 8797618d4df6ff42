// SPDX-License-Identifier: MIT
//   ρ(y)    radius of the side, r_low − s (y − low), s = (r_low − r_high)/(high − low)        m
//   x(t)    o + t u; on the side ‖x_⊥‖² = ρ²:  a t² + 2 b t + c = 0                           m
//   a, b, c u_⊥² − s² u_y²,  o_⊥·u_⊥ + s u_y ρ(o_y),  o_⊥² − ρ(o_y)²
//   inside  between the two roots where a > 0; else beyond one of them, on the side where ρ > 0
#include "sim/body/frustum.h"

#include <algorithm>
#include <cmath>

#include "sim/body/hull_parts.h"

namespace pabd {

extern const ShapeKind cone_kind;

namespace {

double slope(const Frustum& f) { return (f.r_low - f.r_high) / (f.high - f.low); }

Vec3 without_y(const Vec3& v) { return {v.x(), 0, v.z()}; }

// The part of the line inside the side, drawn out at both ends, as t_in and t_out.
std::pair<double, double> inside_side(double a, double b, double c, double falls, double radius) {
  constexpr std::pair nothing{kInfinity, -kInfinity};
  const double discriminant = b * b - a * c;
  if (discriminant < 0 && a > 0) return nothing;
  const double q = -(b + std::copysign(std::sqrt(std::max(discriminant, 0.0)), b));
  if (q == 0) return a > 0 ? std::pair{0.0, 0.0} : c <= 0 ? std::pair{-kInfinity, kInfinity} : nothing;
  const double one = c / q, other = q / a;
  if (a > 0) return std::minmax({one, other});
  // ρ = radius − falls t is positive on one side only.
  const double least = a == 0 ? one : std::min(one, other), most = a == 0 ? one : std::max(one, other);
  if (falls > 0) return {-kInfinity, least * falls <= radius ? least : -kInfinity};
  return {most * falls <= radius ? most : kInfinity, kInfinity};
}

}  // namespace

Frustum frustum_of(const Shape& solid) {
  const Sizes& sizes = sizes_of_solid(solid);
  return &kind_of(solid) == &cone_kind ? cone_frustum(sizes) : cylinder_frustum(sizes);
}

double support(const Frustum& f, const Vec3& u) {
  const double across = std::hypot(u.x(), u.z());
  return std::max(f.low * u.y() + f.r_low * across, f.high * u.y() + f.r_high * across);
}

Aabb bounds(const Frustum& f, const Vec3& c, const Mat3& R) {
  Aabb box{c, c};
  for (int k = 0; k < 3; ++k) {
    const Vec3 u = R.row(k).transpose();
    box.lo[k] -= support(f, -u);
    box.hi[k] += support(f, u);
  }
  return box;
}

double bounding_radius(const Frustum& f) {
  return std::max(std::hypot(f.low, f.r_low), std::hypot(f.high, f.r_high));
}

double inner_radius(const Frustum& f) {
  const double s = slope(f), at_centre = f.r_low + s * f.low;
  return std::min({-f.low, f.high, at_centre / std::sqrt(1 + s * s)});
}

std::optional<SurfaceHit> hit(const Frustum& f, const RayLine& line) {
  const double start = -line.o.dot(line.u);  // from the nearest point on, so that nothing cancels far away
  const Vec3 o = line.o + start * line.u, &u = line.u;
  const double s = slope(f), radius = f.r_low - s * (o.y() - f.low);
  const double a = without_y(u).squaredNorm() - s * s * u.y() * u.y();
  const double b = without_y(o).dot(u) + s * u.y() * radius;
  const double c = without_y(o).squaredNorm() - radius * radius;
  Interval cut;
  std::tie(cut.in, cut.out) = inside_side(a, b, c, s * u.y(), radius);
  if (cut.empty()) return std::nullopt;
  const auto normal = [&](double t) -> Vec3 {
    const Vec3 x = without_y(o + t * u);
    const double across = x.norm();
    return across > 0 ? (x / across + s * Vec3::UnitY()).normalized() : Vec3::UnitY();
  };
  if (std::isfinite(cut.in)) cut.n_in = normal(cut.in);
  if (std::isfinite(cut.out)) cut.n_out = normal(cut.out);
  clip({o, u}, Vec3::UnitY(), f.high, cut);
  clip({o, u}, -Vec3::UnitY(), -f.low, cut);
  if (cut.empty()) return std::nullopt;
  cut.in += start;
  cut.out += start;
  return first_hit(cut);
}

Hull facets(const Frustum& f) {
  HullData hull;
  const bool pointed = f.r_high == 0;
  const auto add_ring = [&](double y, double r) {
    for (int k = 0; k < kFacets; ++k) {
      const double angle = 2 * kPi * k / kFacets;
      hull.vertices.emplace_back(r * std::cos(angle), y, -r * std::sin(angle));
    }
  };
  add_ring(f.low, f.r_low);
  if (pointed) hull.vertices.emplace_back(0, f.high, 0);
  if (!pointed) add_ring(f.high, f.r_high);

  const auto add_face = [&](const Vec3& direction, const std::vector<int>& corners) {
    const Vec3 normal = direction.normalized();
    const double offset = normal.dot(hull.vertices[corners[0]]);
    hull.faces.push_back({normal, offset, static_cast<std::uint16_t>(hull.loop.size()),
                          static_cast<std::uint16_t>(corners.size())});
    for (const int corner : corners) hull.loop.push_back(static_cast<std::uint16_t>(corner));
  };
  std::vector<int> bottom, top;
  for (int k = 0; k < kFacets; ++k) {
    bottom.push_back(kFacets - 1 - k);
    top.push_back(kFacets + k);
  }
  add_face(-Vec3::UnitY(), bottom);
  if (!pointed) add_face(Vec3::UnitY(), top);
  for (int k = 0; k < kFacets; ++k) {
    const double angle = 2 * kPi * (k + 0.5) / kFacets;
    const Vec3 out(std::cos(angle), slope(f) * std::cos(kPi / kFacets), -std::sin(angle));
    const int next = (k + 1) % kFacets;
    if (pointed) {
      add_face(out, {k, next, kFacets});
    } else {
      add_face(out, {k, next, kFacets + next, kFacets + k});
    }
  }
  hull_parts::add_edges(hull);
  hull_parts::finish_hull(hull);
  return Hull{std::make_shared<const HullData>(std::move(hull))};
}

}  // namespace pabd
