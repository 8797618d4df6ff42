// SPDX-License-Identifier: MIT
// What meshes become: a convex hull, or a compound of several. Mass properties are summed when they are made
// (hull_mass.cpp, compound.cpp).
#include "sim/body/compound.h"
#include "sim/body/shape_kind.h"

namespace pabd {
namespace {

constexpr std::array<std::string_view, 4> kMeshKeys{"type", "file", "scale", "parts"};

const HullData& hull(const Shape& shape) { return *as<Hull>(shape).data; }
const CompoundData& compound(const Shape& shape) { return *as<Compound>(shape).data; }

Aabb hull_bounds(const HullData& data, const Vec3& c, const Mat3& R) {
  Vec3 lo = Vec3::Constant(kInfinity), hi = -lo;
  for (const Vec3& vertex : data.vertices) {
    const Vec3 y = R * vertex;
    lo = lo.cwiseMin(y);
    hi = hi.cwiseMax(y);
  }
  return {c + lo, c + hi};
}

Aabb compound_bounds(const Shape& shape, const Vec3& c, const Mat3& R) {
  Vec3 lo = Vec3::Constant(kInfinity), hi = -lo;
  for (const CompoundPart& part : compound(shape).parts) {
    const Aabb box = bounds(part.shape, c + R * part.offset, R);
    lo = lo.cwiseMin(box.lo);
    hi = hi.cwiseMax(box.hi);
  }
  return {lo, hi};
}

std::optional<SurfaceHit> hull_hit(const HullData& data, const RayLine& line) {
  Interval cut;
  for (const HullFace& face : data.faces) clip(line, face.normal, face.offset, cut);
  return first_hit(cut);
}

// The first of any part: from inside that is where the ray leaves a part, perhaps into another one.
std::optional<SurfaceHit> compound_hit(const Shape& shape, const RayLine& line) {
  std::optional<SurfaceHit> first;
  for (const CompoundPart& part : compound(shape).parts) {
    const auto hit = kind_of(part.shape).hit(part.shape, RayLine{line.o - part.offset, line.u});
    if (hit && (!first || hit->t < first->t)) first = hit;
  }
  return first;
}

}  // namespace

extern const ShapeKind hull_kind, compound_kind;

constinit const ShapeKind hull_kind{
    .name = "mesh",
    .keys = kMeshKeys,
    .text = [](const Shape&) { return std::string("convex hull"); },
    .volume = [](const Shape& shape) { return hull(shape).volume; },
    .second_moment = [](const Shape& shape) { return hull(shape).second_moment; },
    .bounds = [](const Shape& shape, const Vec3& c, const Mat3& R) { return hull_bounds(hull(shape), c, R); },
    .bounding_radius = [](const Shape& shape) { return hull(shape).bounding_radius; },
    .inner_radius = [](const Shape& shape) { return hull(shape).inner_radius; },
    .hit = [](const Shape& shape, const RayLine& line) { return hull_hit(hull(shape), line); },
    .surface =
        [](const Shape& shape, std::vector<SurfacePart>& out) {
          out.push_back({.form = SurfaceForm::polyhedron, .hull = &as<Hull>(shape)});
        },
};

constinit const ShapeKind compound_kind{
    .name = "mesh",
    .keys = kMeshKeys,
    .text =
        [](const Shape& shape) {
          const CompoundPart* part = off_centre(shape);
          return part ? text_of(part->shape) + ", off its centre of mass" : std::string("compound of hulls");
        },
    .volume = [](const Shape& shape) { return compound(shape).volume; },
    .second_moment = [](const Shape& shape) { return compound(shape).second_moment; },
    .bounds = compound_bounds,
    .bounding_radius = [](const Shape& shape) { return compound(shape).bounding_radius; },
    .inner_radius = [](const Shape& shape) { return compound(shape).inner_radius; },
    .hit = compound_hit,
    .surface =
        [](const Shape& shape, std::vector<SurfacePart>& out) {
          for (const CompoundPart& part : compound(shape).parts) {
            const std::size_t first = out.size();
            kind_of(part.shape).surface(part.shape, out);
            for (std::size_t k = first; k < out.size(); ++k) out[k].at += part.offset;
          }
        },
};

}  // namespace pabd
