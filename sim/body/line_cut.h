// SPDX-License-Identifier: MIT
// What a straight line cuts out of a solid, in the frame of the solid:
//
//   x(t) = o + t u        ‖u‖ = 1                                              m
//   half space            n·x ≤ offset:  t ≤ or ≥ (offset − n·o) / (n·u)
//   ball                  t = −b ± √(r² − ‖o − b u‖²), b = o·u
//
// A convex solid cuts one interval out of a line; its ends are where a ray along it enters and leaves.
#pragma once

#include <limits>
#include <optional>

#include "sim/math/types.h"

namespace pabd {

struct SurfaceHit {
  double t;     // the point is origin + t direction
  Vec3 normal;  // of the surface, outward; unit
};

struct RayLine {
  Vec3 o, u;  // u is a unit vector
};

// Empty while in > out. Everything at first.
struct Interval {
  double in = -std::numeric_limits<double>::infinity(), out = std::numeric_limits<double>::infinity();
  Vec3 n_in = Vec3::Zero(), n_out = Vec3::Zero();

  bool empty() const { return in > out; }
  static Interval nothing();
};

// Leaves of `cut` what lies below the plane n·x = offset.
void clip(const RayLine& line, const Vec3& n, double offset, Interval& cut);

Interval cut_by_ball(const RayLine& line, const Vec3& centre, double radius);

// Of the tube about the y axis from y = −half_length to half_length.
Interval cut_by_tube(const RayLine& line, double radius, double half_length);

// Where the ray that starts at t = 0 meets the surface first: it enters, or leaves when it starts inside.
std::optional<SurfaceHit> first_hit(const Interval& cut);

}  // namespace pabd
