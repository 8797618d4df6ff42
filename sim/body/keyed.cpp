// SPDX-License-Identifier: MIT
#include "sim/body/keyed.h"

#include <algorithm>
#include <cassert>

namespace pabd {

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
