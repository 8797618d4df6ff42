// SPDX-License-Identifier: MIT
// See past_source.h.
#include "app/frames/past_source.h"

#include <algorithm>
#include <utility>

#include "app/frames/frame_schedule.h"

namespace pabd {
namespace {

// From moment i to moment k every step counts one and takes the same time.
bool even(const Timeline& timeline, std::size_t i, std::size_t k) {
  for (std::size_t m = i + 1; m <= k; ++m) {
    const bool next = timeline[m].report.step - timeline[i].report.step == static_cast<std::int64_t>(m - i);
    if (!next || timeline[m].params->h != timeline[i + 1].params->h) return false;
  }
  return true;
}

std::pair<std::size_t, std::size_t> ends(const Timeline& timeline, const PastRange& range) {
  const std::size_t first = range.from < 0 ? 0 : timeline.at_time(range.from);
  const std::size_t last = range.to < 0 ? timeline.size() - 1 : timeline.at_time(range.to);
  return {first, std::max(first, last)};
}

// What the first step is made with: a start only has what was in force before.
const Params& params_at(const Timeline& timeline, std::size_t i) {
  const bool start = timeline[i].start && i + 1 < timeline.size();
  return *timeline[start ? i + 1 : i].params;
}

}  // namespace

std::vector<std::size_t> moments_of_frames(const Timeline& timeline, const PastRange& range) {
  const auto [first, last] = ends(timeline, range);
  const double start = timeline[first].report.time;
  const bool regular = even(timeline, first, last);
  const double h = first < last ? timeline[first + 1].params->h : 1;
  const double length = regular ? h * static_cast<double>(last - first) : timeline[last].report.time - start;
  const auto count = std::max<std::int64_t>(1, first < last ? steps_until(length, 1 / range.fps) : 1);
  std::vector<std::size_t> out;
  for (std::int64_t frame = 0; frame < count; ++frame) {
    const std::size_t moment = regular ? first + static_cast<std::size_t>(step_of_frame(frame, range.fps, h))
                                       : timeline.at_time(start + static_cast<double>(frame) / range.fps);
    out.push_back(timeline.kept(std::clamp(moment, first, last)));
  }
  return out;
}

PastSource::PastSource(Run a, std::optional<Run> b, const PastRange& range, bool iterations, bool contacts,
                       const TrailRecorder& trails)
    : a_{std::move(a), 0, {}, trails}, moments_(moments_of_frames(a_.run.timeline(), range)) {
  const Timeline& timeline = a_.run.timeline();
  const std::size_t first = moments_.front();
  const bool regular = even(timeline, first, moments_.back());
  for (const std::size_t m : moments_) {
    // As LiveSource's frames have it: not the sum of the steps.
    times_.push_back(regular && m > first ? timeline[first].report.time +
                                                timeline[first + 1].params->h * static_cast<double>(m - first)
                                          : timeline[m].report.time);
  }
  a_.last = first;
  a_.run.observe(iterations, contacts);
  if (!b) return;
  b_ = Seen{std::move(*b), 0, {}, trails};
  b_->last = moment_in_step(timeline, first, b_->run.timeline());
  b_->run.observe(iterations, contacts);
}

// A to a moment. B is taken along from each moment to the next, as their distance is measured at all of them.
bool PastSource::go_to(std::size_t moment, const Stop& stop) {
  Run& a = a_.run;
  while (a.cursor() < moment) {
    if (stop()) return false;
    a.seek(b_ ? a.timeline().next_kept(a.cursor()) : moment);
    if (!b_) continue;
    rejoin(a, b_->run);
    add_distance(a, b_->run, apart_);
  }
  return true;
}

FrameView PastSource::Seen::view() {
  const Timeline& timeline = run.timeline();
  for (std::size_t i = last + 1; i <= run.cursor(); ++i) {
    if (!timeline[i].start) add_report(reports, timeline[i].report);
  }
  last = std::max(last, run.cursor());
  FrameView out = run.view();
  out.params = params_at(timeline, run.cursor());
  out.kappa = resolve_kappa(*out.model, out.params);
  out.history = reports.view();
  trails.add(*out.model, out.state);
  out.trails = trails.trails();
  return out;
}

std::optional<Frame> PastSource::next(const Stop& stop) {
  if (next_ == count()) return {};
  if (next_ == 0) {
    a_.run.seek(a_.last);
    if (b_) b_->run.seek(b_->last);
  }
  drop_old(apart_);
  const int frame = next_++;
  if (!go_to(moments_[static_cast<std::size_t>(frame)], stop)) return {};
  std::optional<FrameView> b;
  if (b_) b = b_->view();
  return make_frame(frame, a_.view(), std::move(b), apart_);
}

}  // namespace pabd
