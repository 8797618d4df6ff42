// SPDX-License-Identifier: MIT
// Random vectors that every compiler draws alike: the order in which the arguments of a call are evaluated is
// not defined, so numbers are drawn one after the other, each into a variable.
#pragma once

#include "sim/math/types.h"

namespace pabd::testing {

// x, y and z, drawn in this order.
template <class Draw>
Vec3 draw_vector(Draw&& draw) {
  const double x = draw(), y = draw(), z = draw();
  return {x, y, z};
}

}  // namespace pabd::testing
