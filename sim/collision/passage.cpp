// SPDX-License-Identifier: MIT
// See passage.h.
#include "sim/collision/passage.h"

#include <algorithm>

#include "sim/body/compound.h"
#include "sim/collision/detect.h"

namespace pabd {
namespace {

// Of a shape along the unit vector n, in its frame. A compound is as thin as its slimmest part.
double thickness(const Shape& shape, const Vec3& n) {
  if (const CompoundPart* part = off_centre(shape)) return thickness(part->shape, n);
  if (is_plane(shape) || std::holds_alternative<Compound>(shape)) return 2 * inner_radius(shape);
  const Aabb box = bounds(shape, Vec3::Zero(), rotation_between(n, Vec3::UnitX()));
  return box.hi.x() - box.lo.x();
}

}  // namespace

bool may_pass(const Model& model, const Passage& passage, std::span<const ContactPoint> points) {
  for (const ContactPoint& p : points) {
    // Of a's point and b's from there to the end, and of their centres, should the points turn out of the way.
    const auto moved = [&](Index i, const Vec3& y) {
      const Vec3 arm = y - passage.c_at(i, p.part);
      const Vec3 turned = passage.R_at(i, 1) * (passage.R_at(i, p.part).transpose() * arm) - arm;
      return std::pair<Vec3, Vec3>((1 - p.part) * passage.way_of(i), turned);
    };
    const auto [way_a, turned_a] = moved(p.a, p.y_a - p.round_a * p.n);
    const auto [way_b, turned_b] = moved(p.b, p.y_b + p.round_b * p.n);
    const double straight = (way_a - way_b).dot(p.n);
    const double approach = straight + std::max(0.0, (turned_a - turned_b).dot(p.n));
    if (!(p.d - approach < passage.touching)) continue;
    const auto across = [&](Index i) {
      return thickness(model.shape[static_cast<std::size_t>(i)], passage.R_at(i, p.part).transpose() * p.n);
    };
    if (approach > 0.5 * std::min(across(p.a), across(p.b))) return true;
  }
  return false;
}

}  // namespace pabd
