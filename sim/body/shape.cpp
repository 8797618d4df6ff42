// Bounds and radii of the shapes.
//
//   c, R   pose of the body                              m, rotation body → world
//   half   half edge lengths of a box                    m
//   y      axis of a capsule, the body's own y axis      unit
#include "sim/body/shape.h"

#include "sim/body/compound.h"

#include <limits>

namespace pabd {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Half extent of the bounds along the three world axes: the support function of the shape in x, y and z.
Vec3 extent(const Box& box, const Mat3& R) { return R.cwiseAbs() * box.half; }
Vec3 extent(const Sphere& sphere, const Mat3&) { return Vec3::Constant(sphere.radius); }
Vec3 extent(const Capsule& capsule, const Mat3& R) {
  return (0.5 * capsule.length) * R.col(1).cwiseAbs() + Vec3::Constant(capsule.radius);
}
Vec3 extent(const Plane&, const Mat3&) { return Vec3::Constant(kInfinity); }
Vec3 extent(const Hull& hull, const Mat3&) { return Vec3::Constant(hull.data->bounding_radius); }
Vec3 extent(const Compound& compound, const Mat3&) { return Vec3::Constant(compound.data->bounding_radius); }

struct BoundingRadius {
  double operator()(const Box& box) const { return box.half.norm(); }
  double operator()(const Sphere& sphere) const { return sphere.radius; }
  double operator()(const Capsule& capsule) const { return 0.5 * capsule.length + capsule.radius; }
  double operator()(const Plane&) const { return kInfinity; }
  double operator()(const Hull& hull) const { return hull.data->bounding_radius; }
  double operator()(const Compound& compound) const { return compound.data->bounding_radius; }
};

struct InnerRadius {
  double operator()(const Box& box) const { return box.half.minCoeff(); }
  double operator()(const Sphere& sphere) const { return sphere.radius; }
  double operator()(const Capsule& capsule) const { return capsule.radius; }
  double operator()(const Plane&) const { return kInfinity; }
  double operator()(const Hull& hull) const { return hull.data->inner_radius; }
  double operator()(const Compound& compound) const { return compound.data->inner_radius; }
};

Aabb hull_bounds(const HullData& hull, const Vec3& c, const Mat3& R) {
  Vec3 lo = Vec3::Constant(kInfinity), hi = -lo;
  for (const Vec3& vertex : hull.vertices) {
    const Vec3 y = R * vertex;
    lo = lo.cwiseMin(y);
    hi = hi.cwiseMax(y);
  }
  return {c + lo, c + hi};
}

Aabb compound_bounds(const CompoundData& compound, const Vec3& c, const Mat3& R) {
  Vec3 lo = Vec3::Constant(kInfinity), hi = -lo;
  for (const CompoundPart& part : compound.parts) {
    const Aabb box = hull_bounds(*part.hull.data, c + R * part.offset, R);
    lo = lo.cwiseMin(box.lo);
    hi = hi.cwiseMax(box.hi);
  }
  return {lo, hi};
}

}  // namespace

Aabb bounds(const Shape& shape, const Vec3& c, const Mat3& R) {
  if (const auto* hull = std::get_if<Hull>(&shape)) return hull_bounds(*hull->data, c, R);
  if (const auto* compound = std::get_if<Compound>(&shape)) return compound_bounds(*compound->data, c, R);
  const Vec3 e = std::visit([&](const auto& s) { return extent(s, R); }, shape);
  return {c - e, c + e};
}

double bounding_radius(const Shape& shape) { return std::visit(BoundingRadius{}, shape); }

double inner_radius(const Shape& shape) { return std::visit(InnerRadius{}, shape); }

}  // namespace pabd
