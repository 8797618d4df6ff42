// SPDX-License-Identifier: MIT
// What a ray meets first: picking with the pointer, shooting, measuring.
//
// A hit is the first point of a shape's surface along the ray, t ≥ 0. From outside that is where the ray
// enters; from inside (a plane is a half space) where it leaves, with n·direction > 0. For a compound it is
// the first surface of any part. A ray with non-finite numbers, or with no direction, hits nothing.
#pragma once

#include <optional>
#include <span>

#include "sim/body/line_cut.h"
#include "sim/body/model.h"
#include "sim/body/state.h"

namespace pabd {

// Points origin + t direction with t ≥ 0, world.
struct Ray {
  Vec3 origin;     // m
  Vec3 direction;  // of any length but 0: t counts in it
};

// The first body that a ray meets.
struct RayHit {
  Index body;
  double t;     // the point is origin + t direction
  Vec3 point;   // world; m
  Vec3 normal;  // outward; unit, world
};

// With one shape at the pose (c, R), which a plane ignores; the normal in the world.
std::optional<SurfaceHit> ray_cast(const Shape& shape, const Vec3& c, const Mat3& R, const Ray& ray);

// With all bodies; of equal t the body of the lower number. Linear in the number of bodies. Precondition:
// state.size() == model.size().
std::optional<RayHit> ray_cast(const Model& model, const State& state, const Ray& ray);

// A body, and where it is.
struct PlacedBody {
  Index body;
  Vec3 c;  // of mass, world; m
  Mat3 R;  // body to world
};
// With some bodies, given in the order of their numbers: what the ray meets first of them, as if there were no others.
std::optional<RayHit> ray_cast(const Model& model, std::span<const PlacedBody> some, const Ray& ray);

}  // namespace pabd
