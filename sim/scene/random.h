// SPDX-License-Identifier: MIT
// Random numbers that are the same on every platform: splitmix64 and plain arithmetic, no library
// distribution.
#pragma once

#include <cmath>
#include <cstdint>

#include "sim/base/hash.h"
#include "sim/math/types.h"

namespace pabd {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() { return mixed(state_ += 0x9e3779b97f4a7c15ull); }

  double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }  // [0, 1)
  double symmetric() { return 2 * uniform() - 1; }                          // [−1, 1)

  // Uniform over all rotations: a point in the unit 4-ball, scaled to its surface.
  Mat3 rotation() {
    for (;;) {
      const double w = symmetric(), x = symmetric(), y = symmetric(), z = symmetric();
      const double n2 = w * w + x * x + y * y + z * z;
      if (n2 > 1 || n2 < 1e-4) continue;
      const double n = std::sqrt(n2);
      return Quat(w / n, x / n, y / n, z / n).toRotationMatrix();
    }
  }

 private:
  std::uint64_t state_;
};

}  // namespace pabd
