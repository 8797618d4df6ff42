// SPDX-License-Identifier: MIT
// See frame_source.h.
#include "app/frames/frame_source.h"

#include <algorithm>
#include <utility>

#include "app/session/step_at_time.h"

namespace pabd {
namespace {

constexpr std::size_t kMostDistances = 40000;

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

Frame make_frame(int number, FrameView a, std::optional<FrameView> b, const DistanceList& apart) {
  if (b) {
    a.label = std::string("A");
    b->label = std::string("B");
  }
  return {number, std::move(a), std::move(b), apart.view()};
}

RunSource::RunSource(Run a, std::optional<Run> b, const TrailRecorder& trails) : a_{std::move(a), trails} {
  if (b) b_ = Shown{std::move(*b), trails};
}

FrameView RunSource::Shown::view() const {
  FrameView out = run.view();
  out.history = reports.view();
  out.trails = trails.trails();
  return out;
}

void RunSource::drop_old_distances() {
  if (apart_.size() >= kMostDistances) apart_.drop_front(kMostDistances / 2);
}

void RunSource::measure_distance() {
  const Run &a = a_.run, &b = b_->run;
  if (!at_common_time(a, b)) return;
  const StateDistance apart = state_distance(a.state(), b.state());
  apart_.push_back({a.state().time, apart.position, apart.angle});
}

// ---- as it is made ----

LiveSource::LiveSource(Run a, std::optional<Run> b, const FrameRange& range, Skipped skipped,
                       const TrailRecorder& trails)
    : RunSource(std::move(a), std::move(b), trails),
      range_(range),
      skipped_(std::move(skipped)),
      first_step_(a_.run.state().step) {
  a_.trails.add(a_.run.model(), a_.run.state());
  if (b_) b_->trails.add(b_->run.model(), b_->run.state());
}

std::optional<Frame> LiveSource::next(const Stop& stop) {
  a_.run.stop_when(stop);
  if (b_) b_->run.stop_when(stop);
  drop_old_distances();
  while (next_ < range_.count) {
    const int frame = next_++;
    if (!advance_to(first_step_ + step_of_frame(frame, range_.fps, a_.run.params().h), stop)) return {};
    if (frame >= range_.first) {
      std::optional<FrameView> b;
      if (b_) b = b_->view();
      return make_frame(frame, a_.view(), std::move(b), apart_);
    }
    if (skipped_) skipped_(frame + 1, a_.run.report());
  }
  return {};
}

bool LiveSource::advance_to(std::int64_t step, const Stop& stop) {
  const auto made = [](Shown& shown) {
    add_report(shown.reports, shown.run.report().summary());
    shown.trails.add(shown.run.model(), shown.run.state());
  };
  while (a_.run.state().step < step) {
    if (stop() || !a_.run.advance()) return false;
    made(a_);
    if (!b_) continue;
    if (!follow(a_.run, b_->run, [&] { made(*b_); })) return false;
    measure_distance();
  }
  return true;
}

std::optional<LiveSource::Diverged> LiveSource::diverged() const {
  for (const Shown* shown : {&a_, b_ ? &*b_ : nullptr}) {
    if (shown && shown->run.report().status == StepStatus::non_finite)
      return Diverged{shown->run.report().summary(), shown != &a_};
  }
  return {};
}

// ---- as it was made ----

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
    : RunSource(std::move(a), std::move(b), trails), moments_(moments_of_frames(a_.run.timeline(), range)) {
  const Timeline& timeline = a_.run.timeline();
  const std::size_t first = moments_.front();
  const bool regular = even(timeline, first, moments_.back());
  for (const std::size_t m : moments_) {
    // As LiveSource's frames have it: not the sum of the steps.
    times_.push_back(regular && m > first ? timeline[first].report.time +
                                                timeline[first + 1].params->h * static_cast<double>(m - first)
                                          : timeline[m].report.time);
  }
  last_a_ = first;
  a_.run.observe(iterations, contacts);
  if (!b_) return;
  last_b_ = moment_in_step(timeline, first, b_->run.timeline());
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
    measure_distance();
  }
  return true;
}

std::optional<Frame> PastSource::next(const Stop& stop) {
  if (next_ == count()) return {};
  if (next_ == 0) {
    a_.run.seek(last_a_);
    if (b_) b_->run.seek(last_b_);
  }
  drop_old_distances();
  const int frame = next_++;
  if (!go_to(moments_[static_cast<std::size_t>(frame)], stop)) return {};
  const auto view = [](Shown& shown, std::size_t& last) {
    const Run& run = shown.run;
    for (std::size_t i = last + 1; i <= run.cursor(); ++i) {
      if (!run.timeline()[i].start) add_report(shown.reports, run.timeline()[i].report);
    }
    last = std::max(last, run.cursor());
    shown.trails.add(run.model(), run.state());
    FrameView out = shown.view();
    out.params = params_at(run.timeline(), run.cursor());
    out.kappa = resolve_kappa(*out.model, out.params);
    return out;
  };
  std::optional<FrameView> b;
  if (b_) b = view(*b_, last_b_);
  return make_frame(frame, view(a_, last_a_), std::move(b), apart_);
}

}  // namespace pabd
