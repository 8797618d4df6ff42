// SPDX-License-Identifier: MIT
// See write_values.h.
#include "sim/scene/write_values.h"

#include "sim/body/shape_kind.h"

namespace pabd {
OrderedJson json_of(const Vec3& v) { return OrderedJson::array({v.x(), v.y(), v.z()}); }

OrderedJson json_of_rotation(const Mat3& R) {
  Quat q(R);
  q.normalize();
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  return OrderedJson::array({q.w(), q.x(), q.y(), q.z()});
}

OrderedJson json_of(const Shape& shape) {
  const ShapeKind& kind = kind_of(shape);
  OrderedJson out{{"type", kind.name}};
  if (is_plane(shape)) {
    out["normal"] = json_of(as<Plane>(shape).normal);
    out["offset"] = as<Plane>(shape).offset;
    return out;
  }
  if (!kind.sizes_of) return nullptr;
  const Sizes sizes = kind.sizes_of(shape);
  const double* next = sizes.data();
  for (const ShapeSize& size : kind.sizes) {
    if (size.count == 1) {
      out[std::string(size.key)] = *next;
    } else {
      out[std::string(size.key)] = std::vector<double>(next, next + size.count);
    }
    next += size.count;
  }
  return out;
}

OrderedJson json_of(const SurfaceFriction& friction) {
  if (friction == SurfaceFriction{friction.mu_static, friction.mu_static}) return friction.mu_static;
  OrderedJson out = {{"static", friction.mu_static}, {"dynamic", friction.mu_dynamic}};
  if (friction.torsional > 0) out["torsional"] = friction.torsional;
  if (friction.rolling > 0) out["rolling"] = friction.rolling;
  return out;
}

void add_law(const BondLaw& law, OrderedJson& out) {
  out["potential"] = law.potential == BondPotential::soft ? "soft" : "hard";
  out["kappa"] = law.kappa;
  if (law.potential == BondPotential::soft) return;
  out["N"] = law.N;
  out["d_hat"] = law.d_hat;
}

}  // namespace pabd
