// SPDX-License-Identifier: MIT
// Spherical joint S(7): ‖y_i0 − y_j0‖ = 0. With a prescribed relative rotation R(θ), points at ± arm along up
// to three directions e of the joint's frame: those of j, y_j0 ± F_j e, meet those of i, y_i0 ± F_i R(θ) e
// (S(8–10), one on each side). One direction leaves j free to turn about it, two or three hold everything.
#include "sim/joint/expand.h"
#include "sim/math/so3.h"

namespace pabd {
namespace {

void expand_spherical(const Joint& joint, const PlacedFrame& fi, const PlacedFrame& fj, double time,
                      BondList& out) {
  out.add(fi.y, fj.y);
  if (!joint.turn) return;
  const Mat3 F = fi.F * exp_so3(joint.turn->at(time));
  for (int k = 0; k < 3; ++k) {
    if (joint.arms >> k & 1) hold_direction(joint, fj, fi.y, F, k, out);
  }
}

}  // namespace

const JointTraits joints::spherical{
    .help = "A ball joint: one point in common. With a drive, a prescribed rotation of j against i.",
    .translations = 0,
    .rotations = 3,
    .expand = expand_spherical,
    .measures = {},
    .turn = true};

}  // namespace pabd
