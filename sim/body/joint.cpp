// SPDX-License-Identifier: MIT
#include "sim/body/joint.h"

#include <algorithm>
#include <cassert>

namespace pabd {

const char* to_string(JointType type) {
  static constexpr const char* kWords[] = {
#define PABD_TYPE(name) #name,
      PABD_JOINT_TYPES(PABD_TYPE)
#undef PABD_TYPE
  };
  return kWords[static_cast<std::size_t>(type)];
}

std::optional<JointType> joint_type(std::string_view word) {
  for (const JointType type : kJointTypes)
    if (word == to_string(type)) return type;
  return std::nullopt;
}

template <class Value>
Value Keyed<Value>::at(double time) const {
  assert(!keys.empty());
  const auto after =
      std::upper_bound(keys.begin(), keys.end(), time,
                       [](double t, const std::pair<double, Value>& key) { return t < key.first; });
  if (after == keys.begin()) return keys.front().second;
  if (after == keys.end()) return keys.back().second;
  const auto& [t0, v0] = *(after - 1);
  const auto& [t1, v1] = *after;
  return v0 + (v1 - v0) * ((time - t0) / (t1 - t0));
}

template <class Value>
bool Keyed<Value>::turns_within(double from, double to) const {
  return keys.size() > 1 && std::any_of(keys.begin(), keys.end(), [&](const std::pair<double, Value>& key) {
           return key.first >= from && key.first < to;
         });
}

template struct Keyed<double>;
template struct Keyed<Vec3>;

}  // namespace pabd
