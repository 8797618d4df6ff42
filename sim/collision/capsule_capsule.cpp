// SPDX-License-Identifier: MIT
// Capsule against capsule: the nearest points of the two axes; where these run side by side, both ends of the
// part that they share, and between them only where that is nearer.
//
//   u, v     axes of a and b                                         unit
//   s, t     places on the axes, |s| ≤ half_a, |t| ≤ half_b           m
//   w        c_a − c_b;  the squared distance is ‖w + s u − t v‖²      m
#include "sim/collision/narrow_phase.h"
#include "sim/collision/side_by_side.h"

namespace pabd::narrow {
namespace {

constexpr double kParallelSine = 0.01;  // below this angle places between the ends must be clearly nearer

enum Feature : std::uint32_t { kLowEnd = 0, kHighEnd = 1, kCrossing = 2 };

// Both ends of the common part, and what is nearer than both by more than `slack`. Returns the smallest d, in
// reach or not; kNone where there is no part.
double add_ends(const Placed<Capsule>& a, const Placed<Capsule>& b, double slack, double reach,
                Contacts& out) {
  const double r_a = a.shape.radius, r_b = b.shape.radius;
  const EdgeLine on_a{a.c, a.R.col(1), 0.5 * a.shape.length}, on_b{b.c, b.R.col(1), 0.5 * b.shape.length};
  SidePlace place[3];
  const int count = side_by_side(on_a, on_b, slack, 1e-3 * std::min(on_a.half, on_b.half), place);
  double lowest = kNone;
  for (int k = 0; k < count; ++k) {
    const SidePlace& p = place[k];
    const double d = distance_to_capsule(p, on_b, r_b) - r_a;
    lowest = std::min(lowest, d);
    const Vec3 y_a = p.y - (p.distance - r_a) * p.n;
    constexpr Feature kFeature[] = {kCrossing, kLowEnd, kHighEnd};
    if (d < reach) add_contact(out, a.number, b.number, y_a + d * p.n, p.n, d, kFeature[p.where]);
  }
  return lowest;
}

}  // namespace

void capsule_capsule(const Placed<Capsule>& a, const Placed<Capsule>& b, double reach, Contacts& out) {
  const Vec3 u = a.R.col(1), v = b.R.col(1), w = a.c - b.c;
  const double half_a = 0.5 * a.shape.length, half_b = 0.5 * b.shape.length;
  const double uv = u.dot(v), uw = u.dot(w), vw = v.dot(w);
  const Vec3 across = u.cross(v);
  const double sine2 = across.squaredNorm();
  const bool parallel = sine2 < kParallelSine * kParallelSine;

  const auto nearest_on_b = [&](double s) { return std::clamp(uv * s + vw, -half_b, half_b); };
  double s = sine2 > 1e-16 ? std::clamp((uv * vw - uw) / sine2, -half_a, half_a) : 0.0;
  const double t = nearest_on_b(s);
  s = std::clamp(uv * t - uw, -half_a, half_a);
  const double d = (w + s * u - t * v).norm() - a.shape.radius - b.shape.radius;
  const double slack = 0.5 * preference(d, std::min(a.shape.radius, b.shape.radius));
  const double by_ends = add_ends(a, b, parallel ? slack : kNone, reach, out);
  if (parallel && by_ends < kNone) return;
  if (!(d < by_ends - 1e-9 * (a.shape.radius + b.shape.radius))) return;
  Vec3 fallback = parallel ? any_normal(u) : Vec3(across / std::sqrt(sine2));
  if (fallback.dot(w) > 0) fallback = -fallback;
  add_round_contact(out, a.number, b.number, a.c + s * u, a.shape.radius, b.c + t * v, b.shape.radius,
                    fallback, reach, kCrossing);
}

}  // namespace pabd::narrow
