// SPDX-License-Identifier: MIT
// Values of a model as the JSON of scene files: SI units, angles in degrees. Internal to those who write it.
#pragma once

#include "sim/base/ordered_json.h"
#include "sim/scene/body_entry.h"
#include "sim/scene/joint_entry.h"

namespace pabd {

const char* to_string(BondPotential potential);

template <class T>
OrderedJson json_of(const T& number_or_text) {
  return number_or_text;
}
OrderedJson json_of(const Vec3& v);
OrderedJson json_of(JointType type);
OrderedJson json_of(BondPotential potential);
OrderedJson json_of(const spec::Color& color);  // "#rrggbb" where that is exact
OrderedJson json_of(const spec::Orientation& orientation);
OrderedJson json_of(const spec::BodyOrGroup& side);
template <class T>
OrderedJson json_of(const std::vector<T>& list) {
  OrderedJson out = OrderedJson::array();
  for (const T& item : list) out.push_back(json_of(item));
  return out;
}
template <class Value>
OrderedJson json_of(const Keyed<Value>& over_time) {
  if (over_time.keys.size() == 1) return {{"value", json_of(over_time.keys[0].second)}};
  OrderedJson keys = OrderedJson::array();
  for (const auto& [time, value] : over_time.keys) keys.push_back(OrderedJson::array({time, json_of(value)}));
  return {{"keys", std::move(keys)}};
}
spec::Orientation orientation_of(const Mat3& R);  // unit quaternion, w ≥ 0
inline OrderedJson json_of_rotation(const Mat3& R) { return json_of(orientation_of(R)); }

// Null for a hull or a compound: their files are not known. The keys of sizes are those of shape_kind.h.
OrderedJson json_of(const Shape& shape);

// A number where it is no more than that.
OrderedJson json_of(const SurfaceFriction& friction);

// `,` and "key": [ … ] with one entry a line; nothing without entries.
std::string list_text(const char* key, const std::vector<OrderedJson>& entries);

// As much as says the same: N and d_hat of hard bonds only.
spec::Law entry_of(const BondLaw& law);
// Adds its keys.
void add_law(const BondLaw& law, OrderedJson& out);

}  // namespace pabd
