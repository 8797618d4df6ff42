// SPDX-License-Identifier: MIT
// See overlap_solid.h.
#include "app/overlay/overlap_solid.h"

#include <memory>

#include "render/visual/body_parts.h"
#include "sim/body/convex_hull.h"

namespace pabd {
namespace {

// Adds the ends of what a segment has inside of a box.
void clip(const std::pair<Vec3, Vec3>& edge, const Box& box, const Pose& at, std::vector<Vec3>& out) {
  const Vec3 from = at.R.transpose() * (edge.first - at.c), to = at.R.transpose() * (edge.second - at.c);
  double begin = 0, end = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double step = to[axis] - from[axis];
    for (const double side : {-1.0, 1.0}) {
      // Inside: side (from + t step) ≤ half.
      const double room = box.half[axis] - side * from[axis], speed = side * step;
      if (speed == 0) {
        if (room < 0) return;
      } else if (speed > 0) {
        end = std::min(end, room / speed);
      } else {
        begin = std::max(begin, room / speed);
      }
    }
  }
  if (begin > end) return;
  for (const double t : {begin, end}) out.push_back(edge.first + t * (edge.second - edge.first));
}

}  // namespace

std::vector<std::pair<Vec3, Vec3>> edges_of(const Box& box, const Pose& at) {
  const auto corner = [&](int k) -> Vec3 {
    const Vec3 signs(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
    return at.c + at.R * signs.cwiseProduct(box.half);
  };
  std::vector<std::pair<Vec3, Vec3>> edges;
  for (int k = 0; k < 8; ++k) {
    for (const int axis : {1, 2, 4}) {
      if (!(k & axis)) edges.emplace_back(corner(k), corner(k | axis));
    }
  }
  return edges;
}

std::vector<Vec3> overlap_corners(const Box& a, const Pose& at_a, const Box& b, const Pose& at_b) {
  std::vector<Vec3> points;
  for (const auto& edge : edges_of(a, at_a)) clip(edge, b, at_b, points);
  for (const auto& edge : edges_of(b, at_b)) clip(edge, a, at_a, points);
  return points;
}

std::optional<MeshInstances> convex_solid(const std::vector<Vec3>& points, const Vec4f& color) {
  if (points.size() < 4) return std::nullopt;
  const std::shared_ptr<const HullData> hull = make_hull(points).hull;
  if (!hull) return std::nullopt;
  Instance instance{Mat4f::Identity(), color, false, false};
  instance.transform.block<3, 3>(0, 0) *= static_cast<float>(hull->bounding_radius);
  instance.transform.block<3, 1>(0, 3) = hull->centroid.cast<float>();
  return MeshInstances{triangles_of(*hull), hull, {instance}};
}

}  // namespace pabd
