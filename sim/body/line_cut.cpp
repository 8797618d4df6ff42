// SPDX-License-Identifier: MIT
//   tube   t = −b ± √((r² − ‖o − b u‖²)/‖u‖²), of o and u without their parts along y; b = o·u/‖u‖²
#include "sim/body/line_cut.h"

#include <cmath>

namespace pabd {
Interval Interval::nothing() { return {kInfinity, -kInfinity, Vec3::Zero(), Vec3::Zero()}; }

void clip(const RayLine& line, const Vec3& n, double offset, Interval& cut) {
  const double above = n.dot(line.o) - offset, slope = n.dot(line.u);
  if (slope == 0) {
    if (above > 0) cut = Interval::nothing();
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

Interval cut_by_ball(const RayLine& line, const Vec3& centre, double radius) {
  const Vec3 o = line.o - centre;
  const double b = o.dot(line.u);
  const double rest = radius * radius - (o - b * line.u).squaredNorm();
  if (!(rest >= 0)) return Interval::nothing();
  const double half = std::sqrt(rest);
  return {-b - half, -b + half, (o - (b + half) * line.u).normalized(),
          (o - (b - half) * line.u).normalized()};
}

Interval cut_by_tube(const RayLine& line, double radius, double half_length) {
  const Vec3 o(line.o.x(), 0, line.o.z()), u(line.u.x(), 0, line.u.z());
  const double along = u.squaredNorm();
  Interval cut;
  if (along > 0) {
    const double b = o.dot(u) / along;
    const double rest = radius * radius - (o - b * u).squaredNorm();
    if (!(rest >= 0)) return Interval::nothing();
    const double half = std::sqrt(rest / along);
    cut = {-b - half, -b + half, (o - (b + half) * u).normalized(), (o - (b - half) * u).normalized()};
  } else if (o.squaredNorm() > radius * radius) {
    return Interval::nothing();
  }
  clip(line, Vec3::UnitY(), half_length, cut);
  clip(line, -Vec3::UnitY(), half_length, cut);
  return cut;
}

std::optional<SurfaceHit> first_hit(const Interval& cut) {
  if (cut.empty() || cut.out < 0) return std::nullopt;
  if (cut.in >= 0) return SurfaceHit{cut.in, cut.n_in};
  if (cut.out < kInfinity) return SurfaceHit{cut.out, cut.n_out};
  return std::nullopt;
}

}  // namespace pabd
