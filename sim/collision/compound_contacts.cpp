// SPDX-License-Identifier: MIT
// A compound against anything: each of its parts as a hull of its own.
//
// A part's contacts are named by hashing their feature with the numbers of the parts, because one hull's
// names fill the 31 bits that there are. Two equal names in one pair (odds of 1e-6 for fifty contacts) are
// told apart by counting up.
#include "sim/body/compound.h"

#include "sim/base/hash.h"
#include "sim/collision/narrow_phase.h"

namespace pabd::narrow {
namespace {

constexpr std::uint32_t kNameBits = 0x3fffffffu;  // room above for counting up

std::uint32_t part_name(std::uint32_t part, std::uint32_t feature) {
  const std::uint64_t both = static_cast<std::uint64_t>(part) << 32 | feature;
  return static_cast<std::uint32_t>(mixed(both + 0x9e3779b97f4a7c15u)) & kNameBits;
}

// Contacts of one hull with a shape that is no compound.
struct HullAgainst {
  const Placed<Hull>& hull;
  const Vec3& c;  // pose and number of the other body
  const Mat3& R;
  Index number;
  bool first;
  double reach;
  Contacts& out;

  template <class ShapeType>
  Placed<ShapeType> placed(const ShapeType& shape) const {
    return {shape, c, R, number, first};
  }
  void operator()(const Box& box) const { hull_box(hull, placed(box), reach, out); }
  void operator()(const Sphere& sphere) const { hull_sphere(hull, placed(sphere), reach, out); }
  void operator()(const Capsule& capsule) const { hull_capsule(hull, placed(capsule), reach, out); }
  void operator()(const Plane& plane) const { hull_plane(placed(plane), hull, reach, out); }
  void operator()(const Hull& other) const {
    if (hull.first) return hull_hull(hull, placed(other), reach, out);
    hull_hull(placed(other), hull, reach, out);
  }
  void operator()(const Compound&) const {}  // comes part by part
  void operator()(const Solid&) const {}     // comes as a hull
};

// All parts of `compound` against one thing within `radius` of c: `meet` is given each part that is near
// enough. `row` tells the parts of the other body apart.
template <class Meet>
void each_part(const Placed<Compound>& compound, const Vec3& c, const Mat3& R, Index number, double radius,
               std::uint32_t row, double reach, Contacts& out, const Meet& meet) {
  std::uint32_t name = row * static_cast<std::uint32_t>(kMostParts);
  for (const CompoundPart& part : compound.shape.data->parts) {
    const Vec3 centre = compound.c + compound.R * part.offset;
    const std::uint32_t own_name = name++;
    const double near = part.hull().data->bounding_radius + radius + reach;
    if ((centre - c).squaredNorm() > near * near) continue;
    const std::size_t start = out.size();
    const Placed<Hull> hull{part.hull(), centre, compound.R, compound.number, compound.first};
    meet(HullAgainst{hull, c, R, number, !compound.first, reach, out});
    for (std::size_t k = start; k < out.size(); ++k) out[k].feature = part_name(own_name, out[k].feature);
  }
}

}  // namespace

void compound_shape(const Placed<Compound>& compound, const Placed<Shape>& other, double reach,
                    Contacts& out) {
  const std::size_t start = out.size();
  if (const auto* second = std::get_if<Compound>(&other.shape)) {
    std::uint32_t row = 0;
    for (const CompoundPart& part : second->data->parts) {
      each_part(compound, other.c + other.R * part.offset, other.R, other.number,
                part.hull().data->bounding_radius, row++, reach, out,
                [&](const HullAgainst& hull) { hull(part.hull()); });
    }
  } else {
    // A plane is everywhere: its radius is infinite.
    each_part(compound, other.c, other.R, other.number, bounding_radius(other.shape), 0, reach, out,
              [&](const HullAgainst& hull) { std::visit(hull, other.shape); });
  }
  const auto by_name = [](const ContactPoint& p, const ContactPoint& q) { return p.feature < q.feature; };
  std::sort(out.begin() + static_cast<std::ptrdiff_t>(start), out.end(), by_name);
  for (std::size_t k = start + 1; k < out.size(); ++k) {
    if (out[k].feature <= out[k - 1].feature) out[k].feature = out[k - 1].feature + 1;
  }
}

}  // namespace pabd::narrow
