// SPDX-License-Identifier: MIT
// See joint_reports.h.
#include "sim/solver/joint_reports.h"

#include "sim/solver/couplings.h"
#include "sim/solver/joint_set.h"

namespace pabd {

void report_joints(const Problem& p, const Iterate& it, const std::vector<Vec3>& solved,
                   std::vector<JointReport>& out) {
  out.clear();
  BondList list;
  for (std::size_t k = 0; k < p.joints.model.size(); ++k) {
    const auto number = static_cast<Index>(k);
    const Joint& joint = p.joints[number];
    const PlacedFrame frame = place(joint.on_i, it.pose[it.slot(joint.i)]);
    expand_at(p, it, number, list);
    JointReport report;
    report.axis = frame.F.col(0);
    // A solver that knows the force of a joint with one bond knows it better than its stretch does: that is
    // some rounding steps of a place.
    const bool known = list.count == 1 && !solved[k].isZero(0);
    for (int b = 0; b < list.count; ++b) {
      const PointBond& bond = list.bond[b];
      const Vec3 force = known ? solved[k] : Vec3(-evaluate(p.law_of(number), bond).gradient);
      report.force += force;
      report.moment += (bond.y_b - frame.y).cross(force);
    }
    if (const Index n = coupling_of(p, number); n >= 0) report.coupling = coupling_force(p, it, n);
    out.push_back(report);
  }
}

}  // namespace pabd
