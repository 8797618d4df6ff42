// SPDX-License-Identifier: MIT
// See significant.h.
#include "app/gui/significant.h"

#include <cmath>

namespace pabd {

double significant(double x, int digits) {
  if (x == 0 || !std::isfinite(x)) return x;
  const int last =
      static_cast<int>(std::floor(std::log10(std::abs(x)))) - digits + 1;  // power of the last digit
  // Powers of ten up to 1e22 are exact, so that one rounding remains.
  const double power = std::pow(10.0, std::abs(last));
  return last < 0 ? std::round(x * power) / power : std::round(x / power) * power;
}

}  // namespace pabd
