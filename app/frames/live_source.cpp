// SPDX-License-Identifier: MIT
// See live_source.h.
#include "app/frames/live_source.h"

#include <utility>

#include "app/frames/frame_schedule.h"

namespace pabd {

LiveSource::LiveSource(Run a, std::optional<Run> b, const FrameRange& range, Skipped skipped,
                       const TrailRecorder& trails)
    : a_(std::move(a)),
      b_(std::move(b)),
      range_(range),
      skipped_(std::move(skipped)),
      first_step_(a_.state().step),
      trails_a_(trails),
      trails_b_(trails) {
  trails_a_.add(a_.model(), a_.state());
  if (b_) trails_b_.add(b_->model(), b_->state());
}

std::optional<Frame> LiveSource::next(const Stop& stop) {
  a_.stop_when(stop);
  if (b_) b_->stop_when(stop);
  drop_old(apart_);
  while (next_ < range_.count) {
    const int frame = next_++;
    if (!advance_to(first_step_ + step_of_frame(frame, range_.fps, a_.params().h), stop)) return {};
    if (frame >= range_.first) return now(frame);
    if (skipped_) skipped_(frame + 1, a_.report());
  }
  return {};
}

bool LiveSource::advance_to(std::int64_t step, const Stop& stop) {
  while (a_.state().step < step) {
    if (stop() || !a_.advance()) return false;
    add_report(reports_a_, a_.report().summary());
    trails_a_.add(a_.model(), a_.state());
    if (!b_) continue;
    if (!follow(a_, *b_, [this] {
          add_report(reports_b_, b_->report().summary());
          trails_b_.add(b_->model(), b_->state());
        }))
      return false;
    add_distance(a_, *b_, apart_);
  }
  return true;
}

Frame LiveSource::now(int frame) const {
  const auto view = [](const Run& run, const ReportList& reports, const TrailRecorder& trails) {
    FrameView out = run.view();
    out.history = reports.view();
    out.trails = trails.trails();
    return out;
  };
  std::optional<FrameView> b;
  if (b_) b = view(*b_, reports_b_, trails_b_);
  return make_frame(frame, view(a_, reports_a_, trails_a_), std::move(b), apart_);
}

std::optional<LiveSource::Diverged> LiveSource::diverged() const {
  for (const Run* run : {&a_, b_ ? &*b_ : nullptr}) {
    if (run && run->report().status == StepStatus::non_finite)
      return Diverged{run->report().summary(), run != &a_};
  }
  return {};
}

}  // namespace pabd
