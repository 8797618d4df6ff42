// SPDX-License-Identifier: MIT
// Contacts of two edges, or axes of capsules, that run nearly side by side: at both ends of the part that
// they share, each with its own distance and normal, so that nothing jumps while the angle between them goes
// through zero. Where they cross so much that a place between is clearly nearer, there as well. Internal.
//
//   a, b     lines p + s u, |s| ≤ h_a, and q + t v, |t| ≤ h_b                       m
//   g(t)     from the foot on a to the place t of b: normal to u, linear in t       m
//   cones    g must lead out of a over the edge and not over a face beside it, and into b likewise
#pragma once

#include <algorithm>
#include <cmath>

#include "sim/math/types.h"

namespace pabd::narrow {

struct EdgeLine {
  Vec3 middle, direction;  // unit
  double half;
  Vec3 into[2] = {Vec3::Zero(), Vec3::Zero()};  // along the two faces, away from the edge; none of a capsule
};

// A place of b and the way to it from a.
struct SidePlace {
  enum Where : unsigned { nearest, low, high };  // along a
  Where where;
  Vec3 y;           // on the line b
  Vec3 n;           // unit
  double distance;  // from the line a along n
  double t;         // place on b
};

inline constexpr double kAlongSine = 0.2;  // of the angle up to which two lines run side by side

inline bool runs_along(const Vec3& u, const Vec3& v) {
  return u.cross(v).squaredNorm() < kAlongSine * kAlongSine;
}

// Returns how many there are: 0 when the lines do not run side by side, share no part or touch.
//   slack     a place between the ends counts when it is nearer than both by more than this; m
//   shortest  part that counts; m
inline int side_by_side(const EdgeLine& a, const EdgeLine& b, double slack, double shortest,
                        SidePlace (&out)[3]) {
  const Vec3 &u = a.direction, &v = b.direction, w = b.middle - a.middle;
  if (!runs_along(u, v)) return 0;
  const double uv = u.dot(v), s_0 = u.dot(w);
  const Vec3 g_0 = w - s_0 * u, slope = v - uv * u;
  double low = -b.half, high = b.half;
  const auto keep = [&](double value, double rise) {  // where value + rise t ≥ 0
    if (rise > 0) low = std::max(low, -value / rise);
    if (rise < 0) high = std::min(high, -value / rise);
    if (rise == 0 && value < 0) high = low;
  };
  keep(a.half + s_0, uv);
  keep(a.half - s_0, -uv);
  for (const Vec3& m : a.into) keep(-m.dot(g_0), -m.dot(slope));
  for (const Vec3& m : b.into) keep(m.dot(g_0), m.dot(slope));
  if (!(high - low > shortest)) return 0;

  int count = 0;
  const auto add = [&](SidePlace::Where where, double t) {
    const Vec3 g = g_0 + t * slope;
    const double distance = g.norm();
    if (!(distance > 1e-12 * (a.half + b.half))) return;
    out[count++] = {where, b.middle + t * v, g / distance, distance, t};
  };
  add(uv > 0 ? SidePlace::low : SidePlace::high, low);
  add(uv > 0 ? SidePlace::high : SidePlace::low, high);
  if (count < 2) return 0;

  // The nearest place is G t = −A from the middle, which runs off to the ends as the lines become parallel;
  // a little added to G holds it back there, at the price of half of `slack`.
  const double middle = 0.5 * (low + high), half = 0.5 * (high - low);
  const double G = slope.squaredNorm(), A = slope.dot(g_0 + middle * slope);
  if (!(G > 0)) return count;
  const double nearest = (g_0 + (middle + std::clamp(-A / G, -half, half)) * slope).norm();
  if (!(nearest < std::min(out[0].distance, out[1].distance) - slack)) return count;
  const double held = 4 * nearest * slack / (half * half);
  add(SidePlace::nearest, middle + std::clamp(-A / (G + held), -half, half));
  return count;
}

// From y_a on the line a along n to the surface of a capsule about b. The way goes on from there to the place
// on b, through the side of its cylinder or, where that leads past the end of it, through the cap.
inline double distance_to_capsule(const SidePlace& p, const EdgeLine& b, double radius) {
  const double slope = std::abs(p.n.dot(b.direction)), cosine2 = 1 - slope * slope;
  const double to_end = p.n.dot(b.direction) < 0 ? b.half - p.t : b.half + p.t;
  const double to_side = radius / std::sqrt(cosine2);
  if (slope * to_side <= to_end) return p.distance - to_side;
  return p.distance - (to_end * slope + std::sqrt(radius * radius - to_end * to_end * cosine2));
}

}  // namespace pabd::narrow
