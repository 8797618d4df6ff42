// The reports of a run, without their heavy members, for plots over time. Bounded: a run may go on for days.
#pragma once

#include <cstddef>
#include <vector>

#include "sim/solver/report.h"

namespace pabd {

class History {
 public:
  // Keeps at least the last `capacity` reports (and at most twice as many).
  explicit History(std::size_t capacity = 20000) : capacity_(capacity) {}

  void add(const StepReport& report);
  void clear() { reports_.clear(); }

  // Oldest first; records and contact_reports of every entry are empty.
  const std::vector<StepReport>& reports() const { return reports_; }

 private:
  std::size_t capacity_;
  std::vector<StepReport> reports_;
};

// A copy of everything but the two vectors.
StepReport light_copy(const StepReport& report);

}  // namespace pabd
