// SPDX-License-Identifier: MIT
// Points → hull: scaled to extent 1, checked for flatness, handed to the library, merged, scaled back.
#include "sim/body/convex_hull.h"

#include <algorithm>

#include "sim/body/hull_parts.h"

namespace pabd {
namespace {

constexpr double kFlat = 1e-5;      // smallest thickness, of the extent
constexpr double kCoplanar = 1e-6;  // of the extent: single-precision files are no better
constexpr std::size_t kDirections = 1024;

// Thickness of the points: the height of the highest point above the plane of three far ones.
double thickness(const std::vector<Vec3>& x) {
  const auto farthest = [&](const auto& distance) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < x.size(); ++i) {
      if (distance(x[i]) > distance(x[best])) best = i;
    }
    return x[best];
  };
  const Vec3 p = x.front();
  const Vec3 a = farthest([&](const Vec3& y) { return (y - p).squaredNorm(); });
  const Vec3 b = farthest([&](const Vec3& y) { return (y - a).squaredNorm(); });
  if (!((b - a).norm() > 0)) return 0;
  const Vec3 u = (b - a).normalized();
  const Vec3 c = farthest([&](const Vec3& y) { return (y - a).cross(u).squaredNorm(); });
  const Vec3 across = u.cross(c - a);
  if (!(across.norm() > kFlat)) return 0;
  const Vec3 n = across.normalized();
  const Vec3 d = farthest([&](const Vec3& y) { return std::abs(n.dot(y - a)); });
  return std::abs(n.dot(d - a));
}

// Corners that are surely on the hull: the farthest points in many directions, a golden spiral. A cheap
// refusal of meshes that are much too fine.
std::size_t certain_corners(const std::vector<Vec3>& x) {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < kDirections; ++k) {
    const double y = 1 - (2 * static_cast<double>(k) + 1) / kDirections;
    const double r = std::sqrt(1 - y * y), angle = static_cast<double>(k) * kPi * (3 - std::sqrt(5.0));
    const Vec3 n(r * std::cos(angle), y, r * std::sin(angle));
    std::size_t best = 0;
    double height = n.dot(x[0]);
    for (std::size_t i = 1; i < x.size(); ++i) {
      const double h = n.dot(x[i]);
      if (h > height) {
        height = h;
        best = i;
      }
    }
    found.push_back(best);
  }
  std::sort(found.begin(), found.end());
  return static_cast<std::size_t>(std::unique(found.begin(), found.end()) - found.begin());
}

HullResult too_many(const std::string& count) {
  return {nullptr, "the convex hull has " + count + " corners; expected at most " +
                       std::to_string(kMostHullVertices) + ", simplify the mesh"};
}

}  // namespace

HullResult make_hull(const std::vector<Vec3>& points) {
  for (const Vec3& p : points) {
    if (!p.allFinite()) return {nullptr, "a point is not finite; expected finite coordinates"};
  }
  std::vector<Vec3> x = points;
  const auto less = [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  };
  std::sort(x.begin(), x.end(), less);
  x.erase(std::unique(x.begin(), x.end()), x.end());
  if (x.size() < 4) return {nullptr, "fewer than four different points; expected a solid"};
  Vec3 lo = x[0], hi = x[0];
  for (const Vec3& p : x) {
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  const double extent = (hi - lo).maxCoeff();
  const Vec3 middle = 0.5 * (lo + hi);
  if (!(extent > 0) || !std::isfinite(extent)) return {nullptr, "no extent; expected a solid"};
  for (Vec3& p : x) p = (p - middle) / extent;
  if (!(thickness(x) > kFlat)) return {nullptr, "the points lie in one plane; expected a solid"};
  if (x.size() > 4 * kMostHullVertices) {
    const std::size_t corners = certain_corners(x);
    if (corners > kMostHullVertices) return too_many("more than " + std::to_string(kMostHullVertices));
  }

  const auto triangles = hull_parts::hull_triangles(x);
  auto hull = hull_parts::merge_faces(x, triangles, kCoplanar);
  if (!hull) hull = hull_parts::merge_faces(x, triangles, 1e-12);
  if (!hull) return {nullptr, "no clean convex hull can be made of the points; expected a thicker solid"};
  if (hull->vertices.size() > kMostHullVertices) return too_many(std::to_string(hull->vertices.size()));
  for (Vec3& v : hull->vertices) v = middle + extent * v;
  for (HullFace& face : hull->faces) face.offset = extent * face.offset + face.normal.dot(middle);
  if (!hull_parts::finish_hull(*hull)) return {nullptr, "the hull has no volume; expected a solid"};
  return {std::make_shared<const HullData>(std::move(*hull)), {}};
}

}  // namespace pabd
