// SPDX-License-Identifier: MIT
#include "sim/scene/read_external.h"

#include "sim/scene/read_joint.h"

namespace pabd {
namespace {

// A vector, or what a drive has: { "value" } or { "keys" }.
std::optional<Keyed<Vec3>> read_over_time(const ObjectReader& in, std::string_view key, const char* unit,
                                          bool fixed) {
  const auto node = in.find(key);
  if (!node) return std::nullopt;
  if (fixed) in.fail_key(key, "a fixed body does not move; remove this key");
  const Range range{-kMostForce, kMostForce, unit};
  if (node->value().is_object()) return read_vectors(*node, range);
  if (!node->value().is_array())
    node->fail_expected("three numbers, or { \"keys\": [[time, [x, y, z]], …] }");
  const Vec3 value = node->vec3(range);
  in.record(key, value);
  return Keyed<Vec3>{{{0, value}}};
}

}  // namespace

std::optional<ExternalForce> read_external(const ObjectReader& in, bool fixed) {
  ExternalForce out{read_over_time(in, "force", "N", fixed), read_over_time(in, "torque", "N m", fixed)};
  if (!out.force && !out.torque) return std::nullopt;
  return out;
}

}  // namespace pabd
