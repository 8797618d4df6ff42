// SPDX-License-Identifier: MIT
// The sphere around what is to be seen.
#include "render/visual/bounds.h"

#include <algorithm>
#include <limits>

namespace pabd {
namespace {

// Fixed bodies up to this many times the radius of the movable ones belong to the picture; larger ones are
// scenery.
constexpr double kScenery = 3.0;

template <class Accept>
std::optional<BoundingSphere> sphere_around(const Model& model, const State& state, Accept accept) {
  const double inf = std::numeric_limits<double>::infinity();
  Vec3 lo = Vec3::Constant(inf);
  Vec3 hi = Vec3::Constant(-inf);
  for (Index i = 0; i < model.size(); ++i) {
    if (is_plane(model.shape[i]) || !has_finite_pose(state, i) || !accept(i)) continue;
    const Aabb box = bounds(model.shape[i], state.c[i], state.R[i]);
    lo = lo.cwiseMin(box.lo);
    hi = hi.cwiseMax(box.hi);
  }
  if (!(lo.array() <= hi.array()).all()) return std::nullopt;
  const Vec3 centre = 0.5 * (lo + hi);
  double radius = 0;
  for (Index i = 0; i < model.size(); ++i) {
    if (is_plane(model.shape[i]) || !has_finite_pose(state, i) || !accept(i)) continue;
    radius = std::max(radius, (state.c[i] - centre).norm() + bounding_radius(model.shape[i]));
  }
  return BoundingSphere{centre, std::max(radius, 1e-6)};
}

}  // namespace

void set_sphere(const BoundingSphere& around, VisualScene& out) {
  out.centre = around.centre.cast<float>();
  out.radius = static_cast<float>(around.radius);
}

bool has_finite_pose(const State& state, Index body) {
  return state.c[body].allFinite() && state.R[body].allFinite();
}

bool is_scenery(const BoundingSphere& movable, const Vec3& c, double radius) {
  return (c - movable.centre).norm() + radius > kScenery * movable.radius;
}

std::vector<std::uint8_t> bodies_in_picture(const Model& model, const State& state) {
  const auto movable = sphere_around(model, state, [&](Index i) { return !model.fixed[i]; });
  std::vector<std::uint8_t> out(model.shape.size(), 0);
  for (Index i = 0; i < model.size(); ++i) {
    if (is_plane(model.shape[i]) || !has_finite_pose(state, i)) continue;
    const bool scenery =
        movable && model.fixed[i] && is_scenery(*movable, state.c[i], bounding_radius(model.shape[i]));
    out[static_cast<std::size_t>(i)] = scenery ? 0 : 1;
  }
  return out;
}

std::optional<BoundingSphere> bounding_sphere(const Model& model, const State& state) {
  return bounding_sphere(model, state, bodies_in_picture(model, state));
}

std::optional<BoundingSphere> bounding_sphere(const Model& model, const State& state,
                                              const std::vector<std::uint8_t>& marked) {
  return sphere_around(model, state, [&](Index i) { return marked[static_cast<std::size_t>(i)] != 0; });
}

}  // namespace pabd
