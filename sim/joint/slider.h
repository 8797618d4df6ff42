// SPDX-License-Identifier: MIT
// What joints that move along an axis share.
#pragma once

#include "sim/joint/expand.h"

namespace pabd {

// The bonds of S(14–16): the offset free, limited or driven, the twist as `joint.twist` says.
void slide_along_axis(const Joint& joint, const PlacedFrame& fi, const PlacedFrame& fj, double time,
                      BondList& out);

}  // namespace pabd
