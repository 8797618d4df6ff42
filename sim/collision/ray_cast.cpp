// SPDX-License-Identifier: MIT
// A ray in the frame of each shape, which says where it is met first. See ray_cast.h.
#include "sim/collision/ray_cast.h"

#include <cassert>

#include "sim/body/shape_kind.h"

namespace pabd {
namespace {

bool is_usable(const Ray& ray) {
  return ray.origin.allFinite() && ray.direction.allFinite() && ray.direction.stableNorm() > 0;
}

// `line` in the world, t in metres.
std::optional<SurfaceHit> meet(const Shape& shape, const Vec3& c, const Mat3& R, const RayLine& line) {
  const ShapeKind& kind = kind_of(shape);
  if (is_plane(shape)) return kind.hit(shape, line);
  const Vec3 between = line.o - c;
  const double b = between.dot(line.u), radius = bounding_radius(shape);
  if ((between - b * line.u).squaredNorm() > radius * radius * (1 + 1e-9)) return std::nullopt;
  auto hit = kind.hit(shape, {R.transpose() * between, R.transpose() * line.u});
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
  assert(state.size() == model.size());
  if (!is_usable(ray)) return std::nullopt;
  const double length = ray.direction.stableNorm();
  const RayLine line{ray.origin, ray.direction / length};
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
