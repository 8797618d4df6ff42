// SPDX-License-Identifier: MIT
#include "sim/body/surface_friction.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pabd {

double combined(FrictionRule rule, double a, double b) {
  switch (rule) {
    case FrictionRule::geometric_mean:
      return std::sqrt(a * b);
    case FrictionRule::average:
      return 0.5 * (a + b);
    case FrictionRule::min:
      return std::min(a, b);
    case FrictionRule::max:
      return std::max(a, b);
    case FrictionRule::product:
      return a * b;
  }
  return a;
}

const char* to_string(FrictionRule rule) {
  static constexpr const char* kWords[] = {"geometric_mean", "average", "min", "max", "product"};
  return kWords[static_cast<std::size_t>(rule)];
}

SurfaceFriction combined(FrictionRule rule, const SurfaceFriction& a, const SurfaceFriction& b) {
  return {combined(rule, a.mu_static, b.mu_static), combined(rule, a.mu_dynamic, b.mu_dynamic),
          combined(rule, a.torsional, b.torsional), combined(rule, a.rolling, b.rolling)};
}

}  // namespace pabd
