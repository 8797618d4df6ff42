// SPDX-License-Identifier: MIT
// See session_source.h.
#include "app/export/session_source.h"

#include <utility>

#include "app/session/step_at_time.h"

namespace pabd {

SessionSource::SessionSource(Session session, std::int64_t count, double fps, Stepped stepped)
    : session_(std::move(session)),
      count_(count),
      fps_(fps),
      stepped_(std::move(stepped)),
      first_step_(session_.state().step) {}

std::optional<Frame> SessionSource::next(const Stop& stop) {
  if (next_ == count_ || diverged_) return {};
  session_.stop_when(stop);
  const std::int64_t step = first_step_ + step_of_frame(next_, fps_, session_.params().h);
  while (session_.state().step < step) {
    if (stop()) return {};
    const StepReport& report = session_.step();
    if (report.status == StepStatus::interrupted) return {};
    if (report.status == StepStatus::non_finite) {
      diverged_ = report.summary();
      return {};
    }
    if (stepped_) stepped_(report, false);
  }
  return make_frame(static_cast<int>(next_++), {session_.view()});
}

}  // namespace pabd
