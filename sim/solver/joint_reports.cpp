// See joint_reports.h.
#include "sim/solver/joint_reports.h"

#include "sim/solver/joint_set.h"

namespace pabd {

void report_joints(const SolveContext& s, std::vector<JointReport>& out) {
  out.clear();
  BondList list;
  for (std::size_t k = 0; k < s.model.joints.size(); ++k) {
    const Joint& joint = s.model.joints[k];
    const PlacedFrame frame = place(joint.on_i, s.w.pose[s.w.slot(joint.i)]);
    expand_at(s, static_cast<Index>(k), kWorld, {}, list);
    JointReport report;
    report.axis = frame.F.col(0);
    for (int b = 0; b < list.count; ++b) {
      const PointBond& bond = list.bond[b];
      const Vec3 force = -evaluate(law_of(s.w, static_cast<Index>(k)), bond).gradient;
      report.force += force;
      report.moment += (bond.y_b - frame.y).cross(force);
    }
    out.push_back(report);
  }
}

}  // namespace pabd
