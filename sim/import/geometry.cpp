// SPDX-License-Identifier: MIT
// Corners of geoms. See geometry.h.
#include "sim/import/geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace pabd {
namespace {

// An icosahedron whose triangles are parted into four, twice: 162 directions.
const std::vector<Vec3>& directions() {
  static const std::vector<Vec3> kAll = [] {
    const double g = (1 + std::sqrt(5.0)) / 2;
    std::vector<Vec3> points;
    for (const double a : {-1.0, 1.0}) {
      for (const double b : {-g, g}) {
        points.push_back(Vec3(0, a, b).normalized());
        points.push_back(Vec3(a, b, 0).normalized());
        points.push_back(Vec3(b, 0, a).normalized());
      }
    }
    for (int round = 0; round < 2; ++round) {
      // Neighbours are the pairs at the least distances: edges differ by less than a fifth, diagonals by far more.
      double shortest = 2;
      const std::size_t n = points.size();
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j) shortest = std::min(shortest, (points[i] - points[j]).norm());
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j)
          if ((points[i] - points[j]).norm() < 1.3 * shortest)
            points.push_back((points[i] + points[j]).normalized());
    }
    return points;
  }();
  return kAll;
}

std::vector<Vec3> capsule(double r, double h) {
  constexpr int kSides = 16, kRings = 4;
  std::vector<Vec3> out;
  for (const double end : {-1.0, 1.0}) {
    out.emplace_back(0, 0, end * (h + r));
    for (int ring = 0; ring < kRings; ++ring) {
      const double up = kPi / 2 * ring / kRings;
      for (int k = 0; k < kSides; ++k) {
        const double turn = 2 * kPi * k / kSides;
        out.emplace_back(r * std::cos(up) * std::cos(turn), r * std::cos(up) * std::sin(turn),
                         end * (h + r * std::sin(up)));
      }
    }
  }
  return out;
}

std::vector<Vec3> cylinder(double r, double h) {
  constexpr int kSides = 32;
  std::vector<Vec3> out;
  for (const double end : {-1.0, 1.0})
    for (int k = 0; k < kSides; ++k)
      out.emplace_back(r * std::cos(2 * kPi * k / kSides), r * std::sin(2 * kPi * k / kSides), end * h);
  return out;
}

}  // namespace

std::vector<Vec3> corners_of(const RobotGeom& geom) {
  const Vec3& s = geom.size;
  std::vector<Vec3> out;
  switch (geom.kind) {
    case GeomKind::box:
      for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
          for (const double z : {-1.0, 1.0}) out.push_back(s.cwiseProduct(Vec3(x, y, z)));
      return out;
    case GeomKind::sphere:
      for (const Vec3& u : directions()) out.push_back(s.x() * u);
      return out;
    case GeomKind::ellipsoid:
      for (const Vec3& u : directions()) out.push_back(s.cwiseProduct(u));
      return out;
    case GeomKind::capsule:
      return capsule(s.x(), s.y());
    case GeomKind::cylinder:
      return cylinder(s.x(), s.y());
    case GeomKind::mesh:
      return geom.points;
    case GeomKind::plane:
      break;
  }
  return out;
}

}  // namespace pabd
