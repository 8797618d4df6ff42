// SPDX-License-Identifier: MIT
// Distance joint S(1): ‖y_i − y_j‖ = l. Soft it is a spring.
#include "sim/joint/expand.h"

namespace pabd {
namespace {

void expand_distance(const Joint& joint, const PlacedFrame& fi, const PlacedFrame& fj, double,
                     BondList& out) {
  out.add(fi.y, fj.y).length = joint.length;
}

constexpr JointMeasure kDistanceMeasures[] = {
    {.of = JointMeasure::Of::length,
     .words = "length",
     .help = nullptr,
     .value = [](const PlacedFrame& fi, const PlacedFrame& fj) { return (fj.y - fi.y).norm(); }}};

}  // namespace

const JointTraits joints::distance{.help = "Two points at a distance: a rod, or with a small kappa a spring.",
                                   .translations = 2,
                                   .rotations = 3,
                                   .expand = expand_distance,
                                   .measures = kDistanceMeasures,
                                   .points = true};

}  // namespace pabd
