// SPDX-License-Identifier: MIT
// What the past of a run keeps of its steps: their summaries, oldest first.
#pragma once

#include "app/session/shared_list.h"
#include "sim/solver/report.h"

namespace pabd {

using ReportList = SharedList<StepSummary>;
// To be looked at from any thread.
using Reports = ReportList::View;

inline constexpr std::size_t kKeptReports = 20000;

// To the end of a list that is bounded, as a run may go on for days: at least the last `kept` stay, and at
// most twice as many.
inline void add_report(ReportList& list, const StepSummary& step, std::size_t kept = kKeptReports) {
  if (list.size() >= 2 * kept) list.drop_front(list.size() - kept);
  list.push_back(step);
}

}  // namespace pabd
