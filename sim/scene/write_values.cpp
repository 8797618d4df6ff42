// See write_values.h.
#include "sim/scene/write_values.h"

namespace pabd {
namespace {

struct ShapeJson {
  OrderedJson operator()(const Box& box) const { return {{"type", "box"}, {"size", json_of(2 * box.half)}}; }
  OrderedJson operator()(const Sphere& sphere) const {
    return {{"type", "sphere"}, {"radius", sphere.radius}};
  }
  OrderedJson operator()(const Capsule& capsule) const {
    return {{"type", "capsule"}, {"radius", capsule.radius}, {"length", capsule.length}};
  }
  OrderedJson operator()(const Plane& plane) const {
    return {{"type", "plane"}, {"normal", json_of(plane.normal)}, {"offset", plane.offset}};
  }
  OrderedJson operator()(const auto&) const { return nullptr; }
};

}  // namespace

OrderedJson json_of(const Vec3& v) { return OrderedJson::array({v.x(), v.y(), v.z()}); }

OrderedJson json_of_rotation(const Mat3& R) {
  Quat q(R);
  q.normalize();
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  return OrderedJson::array({q.w(), q.x(), q.y(), q.z()});
}

OrderedJson json_of(const Shape& shape) { return std::visit(ShapeJson{}, shape); }

void add_law(const BondLaw& law, OrderedJson& out) {
  out["potential"] = law.potential == BondPotential::soft ? "soft" : "hard";
  out["kappa"] = law.kappa;
  if (law.potential == BondPotential::soft) return;
  out["N"] = law.N;
  out["d_hat"] = law.d_hat;
}

}  // namespace pabd
