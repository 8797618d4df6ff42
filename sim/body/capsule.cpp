// SPDX-License-Identifier: MIT
// A capsule of radius r with a straight part L along y: a cylinder of volume V_c and two half balls of volume
// V_s together.
//
//   ∫ x² dV = ∫ z² dV = V_c r²/4 + V_s r²/5
//   ∫ y² dV = V_c L²/12 + V_s (L²/4 + 3Lr/8 + r²/5); the centroid of a half ball is 3r/8 off its flat side
#include <fmt/format.h>

#include "sim/body/shape_kind.h"

namespace pabd {
namespace {

constexpr ShapeSize kCapsuleSizes[] = {{"radius", 1, "Radius"},
                                       {"length", 1, "Between the centres of the two caps; along y"}};
constexpr auto kCapsuleKeys = keys_of(kCapsuleSizes);

const Capsule& capsule(const Shape& shape) { return as<Capsule>(shape); }
double ball_volume(double r) { return 4.0 / 3.0 * kPi * r * r * r; }
double tube_volume(double r, double length) { return kPi * r * r * length; }

Mat3 capsule_second_moment(const Shape& shape) {
  const double r = capsule(shape).radius, length = capsule(shape).length;
  const double tube = tube_volume(r, length), caps = ball_volume(r);
  const double across = tube * r * r / 4.0 + caps * r * r / 5.0;
  const double along =
      tube * length * length / 12.0 + caps * (length * length / 4.0 + 3.0 * length * r / 8.0 + r * r / 5.0);
  return Vec3(across, along, across).asDiagonal();
}

// One interval from the first to the last of tube and both balls: a capsule is convex. The balls come first:
// where they meet the tube, the normals of its flat ends do not count.
std::optional<SurfaceHit> capsule_hit(const Shape& shape, const RayLine& line) {
  const double r = capsule(shape).radius, half = 0.5 * capsule(shape).length;
  const Vec3 end(0, half, 0);
  Interval cut = Interval::nothing();
  for (const Interval& part :
       {cut_by_ball(line, end, r), cut_by_ball(line, -end, r), cut_by_tube(line, r, half)}) {
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
  return first_hit(cut);
}

void capsule_surface(const Shape& shape, std::vector<SurfacePart>& out) {
  const double r = capsule(shape).radius, half = 0.5 * capsule(shape).length;
  if (half > 0) out.push_back({.form = SurfaceForm::tube, .size = {r, half, r}});
  out.push_back({.form = SurfaceForm::half_ball, .at = {0, half, 0}, .size = {r, r, r}});
  out.push_back(
      {.form = SurfaceForm::half_ball, .at = {0, -half, 0}, .size = {r, r, r}, .upside_down = true});
}

}  // namespace

extern const ShapeKind capsule_kind;

constinit const ShapeKind capsule_kind{
    .name = "capsule",
    .keys = kCapsuleKeys,
    .sizes = kCapsuleSizes,
    .make = [](const Sizes& sizes) -> Shape {
      return Capsule{sizes[0], sizes[1]};
    },
    .sizes_of =
        [](const Shape& shape) {
          return Sizes{capsule(shape).radius, capsule(shape).length};
        },
    .rod = [](double length, double thickness) -> Shape {
      return Capsule{thickness / 2, length - thickness};
    },
    .text =
        [](const Shape& shape) {
          return fmt::format("capsule {:.4g} m + {:.4g} m", 2 * capsule(shape).radius, capsule(shape).length);
        },
    .volume =
        [](const Shape& shape) {
          return tube_volume(capsule(shape).radius, capsule(shape).length) +
                 ball_volume(capsule(shape).radius);
        },
    .second_moment = capsule_second_moment,
    .bounds = [](const Shape& shape, const Vec3& c, const Mat3& R) -> Aabb {
      const Vec3 e =
          (0.5 * capsule(shape).length) * R.col(1).cwiseAbs() + Vec3::Constant(capsule(shape).radius);
      return {c - e, c + e};
    },
    .bounding_radius = [](const Shape& shape) { return 0.5 * capsule(shape).length + capsule(shape).radius; },
    .inner_radius = [](const Shape& shape) { return capsule(shape).radius; },
    .rolling_radius = [](const Shape& shape) { return capsule(shape).radius; },
    .core_radius = [](const Shape& shape) { return 0.5 * capsule(shape).length; },
    .round_about_y = true,
    .hit = capsule_hit,
    .surface = capsule_surface,
};

}  // namespace pabd
