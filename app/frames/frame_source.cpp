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
  return {number, std::move(a), std::move(b), {}, apart.view()};
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

void RunSource::Shown::widen_span() {
  const StepReport& report = run.report();
  if (!report.records.empty()) widen(span, report, !run.model().joints.empty());
}

void RunSource::Shown::remember() {
  before = std::move(now);
  now = {};
  now.time = run.state().time;
  now.c = run.state().c;
  now.R = run.state().R;
}

FrameView RunSource::Shown::view_at(double time) const {
  FrameView out = view();
  if (before.c.size() != now.c.size()) return out;
  const double u = std::clamp((time - before.time) / (now.time - before.time), 0.0, 1.0);
  State state = *out.state;
  state.time = time;
  for (std::size_t i = 0; i < now.c.size(); ++i) {
    state.c[i] = (1 - u) * before.c[i] + u * now.c[i];
    state.R[i] = Quat(before.R[i]).slerp(u, Quat(now.R[i])).toRotationMatrix();
  }
  const auto carry = [&](Index body, Vec3& p) {
    if (body < 0 || body >= state.size()) return;
    const auto i = static_cast<std::size_t>(body);
    p = state.c[i] + state.R[i] * (now.R[i].transpose() * (p - now.c[i]));
  };
  for (ContactReport& contact : out.report.contact_reports) {
    carry(contact.a, contact.y_a);
    carry(contact.b, contact.y_b);
  }
  out.state = std::make_shared<const State>(std::move(state));
  return out;
}

Frame RunSource::frame(int number, FrameView a, std::optional<FrameView> b) const {
  Frame out = make_frame(number, std::move(a), std::move(b), apart_);
  out.span = a_.span;
  if (!b_) return out;
  out.span = {std::max(a_.span.iterations, b_->span.iterations), std::min(a_.span.lo, b_->span.lo),
              std::max(a_.span.hi, b_->span.hi)};
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
                       const TrailRecorder& trails, Stepped stepped)
    : RunSource(std::move(a), std::move(b), trails),
      range_(range),
      skipped_(std::move(skipped)),
      stepped_(std::move(stepped)),
      first_step_(a_.run.state().step) {
  for (Shown* shown : {&a_, b_ ? &*b_ : nullptr}) {
    if (!shown) continue;
    shown->trails.add(shown->run.model(), shown->run.state());
    shown->remember();
  }
}

std::optional<Frame> LiveSource::next(const Stop& stop) {
  a_.run.stop_when(stop);
  if (b_) b_->run.stop_when(stop);
  drop_old_distances();
  while (next_ < range_.count) {
    const int frame = next_++;
    const double h = a_.run.params().h, time = range_.time(frame);
    const std::int64_t steps = steps_until(time, h);
    const double left = time - h * static_cast<double>(steps);
    const bool between = !range_.pace.is_real_time() && left > forgiven(time, h);
    if (!advance_to(first_step_ + steps + (between ? 1 : 0), stop)) return {};
    a_.widen_span();
    if (b_) b_->widen_span();
    if (frame >= range_.first) {
      const auto view = [&](const Shown& shown) {
        return between ? shown.view_at(a_.run.state().time - h + left) : shown.view();
      };
      std::optional<FrameView> b;
      if (b_) b = view(*b_);
      return RunSource::frame(frame, view(a_), std::move(b));
    }
    if (skipped_) skipped_(frame + 1, a_.run.report());
  }
  return {};
}

bool LiveSource::advance_to(std::int64_t step, const Stop& stop) {
  const auto made = [this](Shown& shown) {
    add_report(shown.reports, shown.run.report().summary());
    if (stepped_) stepped_(shown.run.report(), &shown != &a_);
    if (!range_.pace.is_real_time()) shown.remember();
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
                       const TrailRecorder& trails, bool bodies)
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
  a_.run.observe(iterations, contacts, bodies);
  if (!b_) return;
  last_b_ = moment_in_step(timeline, first, b_->run.timeline());
  b_->run.observe(iterations, contacts, bodies);
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
    shown.widen_span();
    shown.trails.add(run.model(), run.state());
    FrameView out = shown.view();
    out.params = params_at(run.timeline(), run.cursor());
    out.kappa = resolve_kappa(*out.model, out.params);
    return out;
  };
  std::optional<FrameView> b;
  if (b_) b = view(*b_, last_b_);
  return RunSource::frame(frame, view(a_, last_a_), std::move(b));
}

}  // namespace pabd
