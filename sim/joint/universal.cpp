// SPDX-License-Identifier: MIT
// Universal joint: a ball S(7), and two axes that stay square to each other, n on i and e on j. The points at
// ± arm on them are √2 arm apart exactly where they do: ‖a n − a e‖² = 2a² (1 − n·e). So two distance bonds S(1),
// from y_i + a n to y_j + a e and from y_i − a n to y_j − a e, hold the rotation about n × e. Their forces are
// opposite: they make a moment and no force.
#include <cmath>

#include "sim/joint/expand.h"

namespace pabd {
namespace {

void expand_universal(const Joint& joint, const PlacedFrame& fi, const PlacedFrame& fj, double,
                      BondList& out) {
  out.add(fi.y, fj.y);
  for (const double side : {1.0, -1.0}) {
    if (side < 0 && !joint.symmetric) break;
    out.add(fi.y + side * joint.arm * fi.F.col(0), fj.y + side * joint.arm * fj.F.col(1)).length =
        std::sqrt(2.0) * joint.arm;
  }
}

// F_j = F_i R(φ about n) R(ψ about e): the cross has turned by φ on i, and j by ψ on the cross.
AnglePlane second_plane(const PlacedFrame& fi, const PlacedFrame& fj) {
  return {fi.F.col(0), fj.F.col(1).cross(fi.F.col(0))};
}
double second_angle(const PlacedFrame& fi, const PlacedFrame& fj) {
  const AnglePlane plane = second_plane(fi, fj);
  const Vec3 n = fj.F.col(0);
  return std::atan2(n.dot(plane.ahead), n.dot(plane.zero));
}

constexpr JointMeasure kUniversalMeasures[] = {{.of = JointMeasure::Of::angle,
                                                .words = "angle φ",
                                                .help = "Of the second axis about the first",
                                                .value = joint_angle,
                                                .plane = angle_plane},
                                               {.of = JointMeasure::Of::angle,
                                                .words = "angle ψ",
                                                .help = "Of j about the second axis",
                                                .value = second_angle,
                                                .plane = second_plane}};

}  // namespace

const JointTraits joints::universal{
    .help =
        "A cross: one point in common, and axis on i stays square to second_axis on j. It leaves the turns "
        "about both free and hands on the third.",
    .translations = 0,
    .rotations = 2,
    .expand = expand_universal,
    .measures = kUniversalMeasures,
    .axes = 2};

}  // namespace pabd
