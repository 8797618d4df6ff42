// SPDX-License-Identifier: MIT
// See mass_properties.h: the closed forms stand with each kind of shape.
#include "sim/body/mass_properties.h"

#include <cassert>

#include "sim/body/shape_kind.h"

namespace pabd {

double volume(const Shape& shape) { return kind_of(shape).volume(shape); }

MassProperties mass_properties(const Shape& shape, double density) {
  assert(density > 0 && !is_plane(shape));
  return {density * volume(shape), density * kind_of(shape).second_moment(shape)};
}

}  // namespace pabd
