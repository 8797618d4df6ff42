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

// Of `count` bodies, which body(k) places.
template <class Body>
std::optional<RayHit> first_hit(const Model& model, std::size_t count, const Body& body, const Ray& ray) {
  if (!is_usable(ray)) return std::nullopt;
  const double length = ray.direction.stableNorm();
  const RayLine line{ray.origin, ray.direction / length};
  std::optional<RayHit> first;
  for (std::size_t k = 0; k < count; ++k) {
    const auto& [i, c, R] = body(k);
    const auto hit = meet(model.shape[static_cast<std::size_t>(i)], c, R, line);
    if (hit && (!first || hit->t < first->t)) first = {i, hit->t, {}, hit->normal};
  }
  if (first) {
    first->point = line.o + first->t * line.u;
    first->t /= length;
  }
  return first;
}

struct Reference {
  Index body;
  const Vec3& c;
  const Mat3& R;
};

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
  const auto body = [&](std::size_t k) { return Reference{static_cast<Index>(k), state.c[k], state.R[k]}; };
  return first_hit(model, model.shape.size(), body, ray);
}

std::optional<RayHit> ray_cast(const Model& model, std::span<const PlacedBody> some, const Ray& ray) {
  return first_hit(
      model, some.size(), [&](std::size_t k) -> const PlacedBody& { return some[k]; }, ray);
}

}  // namespace pabd
