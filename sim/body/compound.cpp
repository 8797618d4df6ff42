// SPDX-License-Identifier: MIT
// Mass properties of several hulls together (the parallel axis theorem for second moments).
//
//   V_k, c_k, S_k   volume, centre of mass and second moment of part k      m³, m, m⁵
//   c               Σ V_k c_k / Σ V_k                                       m
//   S               Σ S_k + V_k (c_k − c)(c_k − c)ᵀ                         m⁵
#include "sim/body/compound.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <optional>

#include "sim/body/mass_properties.h"
#include "sim/body/shape_kind.h"

namespace pabd {

namespace {

Compound joined(const std::vector<Hull>& hulls, const std::optional<Vec3>& origin) {
  assert(!hulls.empty() && hulls.size() <= kMostParts);
  auto out = std::make_shared<CompoundData>();
  const Vec3 near = hulls.front().data->centroid;  // offsets are summed from here: nothing cancels
  Vec3 moment = Vec3::Zero();
  out->volume = 0;
  for (const Hull& hull : hulls) {
    out->volume += hull.data->volume;
    moment += hull.data->volume * (hull.data->centroid - near);
  }
  out->centroid = origin.value_or(near + moment / out->volume);
  out->second_moment.setZero();
  out->bounding_radius = 0;
  out->inner_radius = std::numeric_limits<double>::infinity();
  for (const Hull& hull : hulls) {
    const Vec3 offset = hull.data->centroid - out->centroid;
    out->parts.push_back({hull, offset});
    out->second_moment += hull.data->second_moment + hull.data->volume * offset * offset.transpose();
    for (const Vec3& v : hull.data->vertices) {
      out->bounding_radius = std::max(out->bounding_radius, (offset + v).norm());
    }
    out->inner_radius = std::min(out->inner_radius, hull.data->inner_radius);
  }
  return Compound{std::move(out)};
}

}  // namespace

const CompoundPart* off_centre(const Shape& shape) {
  const auto* compound = std::get_if<Compound>(&shape);
  if (!compound || compound->data->parts.size() != 1) return nullptr;
  const CompoundPart& part = compound->data->parts.front();
  return std::holds_alternative<Hull>(part.shape) ? nullptr : &part;
}

Compound with_centre_of_mass(const Shape& shape, const Vec3& com) {
  auto out = std::make_shared<CompoundData>();
  if (const auto* compound = std::get_if<Compound>(&shape)) {
    *out = *compound->data;
    for (CompoundPart& part : out->parts) part.offset -= com;
  } else {
    out->parts.push_back({shape, -com});
    out->volume = volume(shape);
    out->second_moment = kind_of(shape).second_moment(shape);
    out->inner_radius = inner_radius(shape);
  }
  out->centroid = com;
  // Of a sphere that holds it.
  out->bounding_radius = bounding_radius(shape) + com.norm();
  return Compound{std::move(out)};
}

Compound make_compound(const std::vector<Hull>& hulls) { return joined(hulls, {}); }
Compound make_compound_about(const std::vector<Hull>& hulls, const Vec3& origin) {
  return joined(hulls, origin);
}

}  // namespace pabd
