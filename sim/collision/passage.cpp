// SPDX-License-Identifier: MIT
// See passage.h.
#include "sim/collision/passage.h"

#include <algorithm>
#include <cmath>

#include "sim/collision/detect.h"

namespace pabd {
namespace {

constexpr int kMostPieces = 64;

// Of a shape along the unit vector n, in its frame. A compound is as thin as its slimmest part.
double thickness(const Shape& shape, const Vec3& n) {
  if (is_plane(shape) || std::holds_alternative<Compound>(shape)) return 2 * inner_radius(shape);
  const Aabb box = bounds(shape, Vec3::Zero(), rotation_between(n, Vec3::UnitX()));
  return box.hi.x() - box.lo.x();
}

}  // namespace

bool Passage::stays(const Model& model, Index i, Index j) const {
  const double far = (way[at(i)] - way[at(j)]).norm() + spin[at(i)] + spin[at(j)];
  return far <= 0.5 * std::min(inner_radius(model.shape[at(i)]), inner_radius(model.shape[at(j)]));
}

int pieces(const Model& model, const Passage& passage, std::span<const ContactPoint> at_start) {
  double most = 1;
  for (const ContactPoint& p : at_start) {
    // Of a's point and b's, and of their centres, should they turn out of the way.
    const auto moved = [&](Index i, const Vec3& y) {
      const Vec3 arm = y - passage.c_at(i, 0);
      const Vec3 turned = passage.R_at(i, 1) * (passage.R_at(i, 0).transpose() * arm) - arm;
      return std::pair{passage.c_at(i, 1) - passage.c_at(i, 0), turned};
    };
    const auto [way_a, turned_a] = moved(p.a, p.y_a - p.round_a * p.n);
    const auto [way_b, turned_b] = moved(p.b, p.y_b + p.round_b * p.n);
    const double straight = (way_a - way_b).dot(p.n);
    const double approach = straight + std::max(0.0, (turned_a - turned_b).dot(p.n));
    if (!(p.d - approach < passage.touching)) continue;
    const auto across = [&](Index i) {
      return thickness(model.shape[static_cast<std::size_t>(i)], passage.R_at(i, 0).transpose() * p.n);
    };
    most = std::max(most, approach / (0.5 * std::min(across(p.a), across(p.b))));
  }
  return static_cast<int>(std::ceil(std::min<double>(most, kMostPieces)));
}

}  // namespace pabd
