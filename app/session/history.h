// Summaries of the steps of a run, for plots over time. Bounded: a run may go on for days.
#pragma once

#include <cstddef>
#include <vector>

#include "sim/solver/report.h"

namespace pabd {

class History {
 public:
  // Keeps at least the last `capacity` reports (and at most twice as many).
  explicit History(std::size_t capacity = 20000) : capacity_(capacity) {}

  void add(const StepSummary& step);
  void clear() { reports_.clear(); }

  // Oldest first.
  const std::vector<StepSummary>& reports() const { return reports_; }

 private:
  std::size_t capacity_;
  std::vector<StepSummary> reports_;
};

}  // namespace pabd
