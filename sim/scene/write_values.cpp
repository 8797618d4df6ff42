// SPDX-License-Identifier: MIT
// See write_values.h.
#include "sim/scene/write_values.h"

#include <fmt/format.h>

#include "sim/body/shape_kind.h"
#include "sim/scene/fields.h"

namespace pabd {
OrderedJson json_of(const Vec3& v) { return OrderedJson::array({v.x(), v.y(), v.z()}); }

OrderedJson json_of(JointType type) { return to_string(type); }
OrderedJson json_of(BondPotential potential) { return to_string(potential); }

OrderedJson json_of(const spec::Color& color) {
  const Vec3 bytes = 255 * color.rgb, whole = bytes.array().round();
  if (whole / 255 != color.rgb) return json_of(color.rgb);
  return fmt::format("#{:02x}{:02x}{:02x}", static_cast<int>(whole.x()), static_cast<int>(whole.y()),
                     static_cast<int>(whole.z()));
}

OrderedJson json_of(const spec::Orientation& orientation) {
  if (const auto* q = std::get_if<std::array<double, 4>>(&orientation)) return *q;
  if (const auto* turn = std::get_if<spec::AxisAngle>(&orientation)) return json_of_entry(*turn);
  return json_of_entry(std::get<spec::Euler>(orientation));
}

OrderedJson json_of(const spec::BodyOrGroup& side) {
  if (const auto* group = std::get_if<spec::Group>(&side)) return json_of_entry(*group);
  return std::get<std::string>(side);
}

spec::Orientation orientation_of(const Mat3& R) {
  Quat q(R);
  q.normalize();
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  return {q.w(), q.x(), q.y(), q.z()};
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

std::string list_text(const char* key, const std::vector<OrderedJson>& entries) {
  if (entries.empty()) return {};
  std::string out = fmt::format(",\n  \"{}\": [", key);
  for (const OrderedJson& entry : entries)
    out += (&entry == entries.data() ? "\n    " : ",\n    ") + entry.dump();
  return out + "\n  ]";
}

spec::Law entry_of(const BondLaw& law) {
  if (law.potential == BondPotential::soft) return {.potential = law.potential, .kappa = law.kappa};
  return {law.potential, law.kappa, law.N, law.d_hat};
}

void add_law(const BondLaw& law, OrderedJson& out) { entry_of(law).fields(FieldWriter(out)); }

}  // namespace pabd
