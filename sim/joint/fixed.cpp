// SPDX-License-Identifier: MIT
// Fixed joint: a ball S(7) and, for each of the three rotations, points on both sides of the anchor S(8–10).
#include "sim/joint/expand.h"

namespace pabd {
namespace {

void expand_fixed(const Joint& joint, const PlacedFrame& fi, const PlacedFrame& fj, double, BondList& out) {
  out.add(fi.y, fj.y);
  for (int k = 0; k < 3; ++k) hold_direction(joint, fj, fi.y, fi.F, k, out);
}

}  // namespace

const JointTraits joints::fixed{.help = "The two bodies move as one.",
                                .translations = 0,
                                .rotations = 0,
                                .expand = expand_fixed,
                                .measures = {}};

}  // namespace pabd
