// The bounded list of step reports.
#include "app/session/history.h"

namespace pabd {

StepReport light_copy(const StepReport& report) {
  StepReport copy;
  copy.step = report.step;
  copy.time = report.time;
  copy.method = report.method;
  copy.status = report.status;
  copy.iterations = report.iterations;
  copy.kinetic = report.kinetic;
  copy.potential = report.potential;
  copy.elastic = report.elastic;
  copy.kappa = report.kappa;
  copy.contacts = report.contacts;
  copy.max_penetration = report.max_penetration;
  copy.min_gap = report.min_gap;
  copy.max_joint_error = report.max_joint_error;
  copy.residual = report.residual;
  copy.left_pairs = report.left_pairs;
  copy.too_dense = report.too_dense;
  copy.drive_work = report.drive_work;
  copy.capped_bonds = report.capped_bonds;
  copy.held_bodies = report.held_bodies;
  copy.friction_excess = report.friction_excess;
  copy.times = report.times;
  return copy;
}

void History::add(const StepReport& report) {
  // Dropping half at once keeps the list contiguous at a constant cost a step.
  if (reports_.size() >= 2 * capacity_) {
    reports_.erase(reports_.begin(), reports_.end() - static_cast<std::ptrdiff_t>(capacity_));
  }
  reports_.push_back(light_copy(report));
}

}  // namespace pabd
