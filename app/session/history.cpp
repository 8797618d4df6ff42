// The bounded list of step reports.
#include "app/session/history.h"

namespace pabd {

void History::add(const StepSummary& step) {
  // Dropping half at once keeps the list contiguous at a constant cost a step.
  if (reports_.size() >= 2 * capacity_) {
    reports_.erase(reports_.begin(), reports_.end() - static_cast<std::ptrdiff_t>(capacity_));
  }
  reports_.push_back(step);
}

}  // namespace pabd
