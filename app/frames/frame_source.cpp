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

Frame make_frame(int number, std::vector<FrameView> runs, const DistanceList& apart) {
  const bool compared = runs.size() == 2;
  if (compared) {
    runs[0].label = std::string("A");
    runs[1].label = std::string("B");
  }
  return {number, std::move(runs), compared, {}, apart.view()};
}

std::vector<Run> runs_of(Run a, std::optional<Run> b) {
  std::vector<Run> out;
  out.push_back(std::move(a));
  if (b) out.push_back(*std::move(b));
  return out;
}

RunSource::RunSource(std::vector<Run> runs, const TrailRecorder& trails, bool grid) : grid_(grid) {
  for (Run& run : runs) shown_.push_back({std::move(run), trails});
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

Frame RunSource::frame(int number, std::vector<FrameView> views) const {
  Frame out = grid_ ? Frame{.number = number, .runs = std::move(views), .apart = {}}
                    : make_frame(number, std::move(views), apart_);
  for (const Shown& shown : shown_) {
    const ConvergenceSpan& span = shown.span;
    out.span = {std::max(out.span.iterations, span.iterations), std::min(out.span.lo, span.lo),
                std::max(out.span.hi, span.hi)};
  }
  return out;
}

void RunSource::drop_old_distances() {
  if (apart_.size() >= kMostDistances) apart_.drop_front(kMostDistances / 2);
}

void RunSource::measure_distance() {
  if (grid_ || shown_.size() != 2) return;
  const Run &a = shown_[0].run, &b = shown_[1].run;
  if (!at_common_time(a, b)) return;
  const StateDistance apart = state_distance(a.state(), b.state());
  apart_.push_back({a.state().time, apart.position, apart.angle});
}

// ---- as it is made ----

LiveSource::LiveSource(std::vector<Run> runs, const FrameRange& range, Skipped skipped,
                       const TrailRecorder& trails, Stepped stepped, bool grid)
    : RunSource(std::move(runs), trails, grid),
      range_(range),
      skipped_(std::move(skipped)),
      stepped_(std::move(stepped)),
      first_step_(shown_.front().run.state().step) {
  for (Shown& shown : shown_) {
    shown.trails.add(shown.run.model(), shown.run.state());
    shown.remember();
  }
}

std::optional<Frame> LiveSource::next(const Stop& stop) {
  for (Shown& shown : shown_) shown.run.stop_when(stop);
  drop_old_distances();
  while (next_ < range_.count) {
    const int frame = next_++;
    const double time = range_.time(frame);
    if (!advance_to(time, stop)) return {};
    for (Shown& shown : shown_) shown.widen_span();
    if (frame >= range_.first) return RunSource::frame(frame, views_at(time));
    if (skipped_) skipped_(frame + 1, shown_.front().run.report());
  }
  return {};
}

// Which step a time is in, and how far; of a run from the first frame on.
LiveSource::Place LiveSource::place(const Run& run, double time) const {
  const double h = run.params().h;
  const std::int64_t steps = steps_until(time, h);
  const double left = time - h * static_cast<double>(steps);
  const bool between = !range_.pace.is_real_time() && left > forgiven(time, h);
  return {first_step_ + steps + (between ? 1 : 0), between ? std::optional(left - h) : std::nullopt};
}

std::vector<FrameView> LiveSource::views_at(double time) const {
  std::vector<FrameView> out;
  const Run& leader = shown_[leader_].run;
  const auto before_end = place(leader, time).before_end;
  for (const Shown& shown : shown_) {
    const bool on_the_way = before_end && !ended(shown);
    out.push_back(on_the_way ? shown.view_at(leader.state().time + *before_end) : shown.view());
  }
  return out;
}

// The first run that has not ended leads.
bool LiveSource::advance_to(double time, const Stop& stop) {
  for (; leader_ < shown_.size(); ++leader_) {
    Shown& leader = shown_[leader_];
    while (!ended(leader) && leader.run.state().step < place(leader.run, time).step) {
      if (!advance(stop)) return false;
    }
    if (!ended(leader)) return true;
  }
  leader_ = 0;
  return false;
}

bool LiveSource::advance(const Stop& stop) {
  const auto made = [this](Shown& shown) {
    add_report(shown.reports, shown.run.report().summary());
    if (stepped_) stepped_(shown.run.report(), static_cast<std::size_t>(&shown - shown_.data()));
    if (!range_.pace.is_real_time()) shown.remember();
    shown.trails.add(shown.run.model(), shown.run.state());
  };
  const auto goes_on = [&](const Shown& shown) { return grid_ && ended(shown); };
  Shown& leader = shown_[leader_];
  if (stop()) return false;
  if (!leader.run.advance()) return goes_on(leader);
  made(leader);
  for (std::size_t k = leader_ + 1; k < shown_.size(); ++k) {
    Shown& shown = shown_[k];
    if (ended(shown)) continue;
    if (!follow(leader.run, shown.run, [&] { made(shown); }) && !goes_on(shown)) return false;
  }
  measure_distance();
  return true;
}

std::vector<LiveSource::Diverged> LiveSource::diverged() const {
  std::vector<Diverged> out;
  for (std::size_t k = 0; k < shown_.size(); ++k) {
    if (ended(shown_[k])) out.push_back({shown_[k].run.report().summary(), k});
  }
  return out;
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

PastSource::PastSource(std::vector<Run> runs, const PastRange& range, bool iterations, bool contacts,
                       const TrailRecorder& trails, bool bodies)
    : RunSource(std::move(runs), trails), moments_(moments_of_frames(shown_.front().run.timeline(), range)) {
  const Timeline& timeline = shown_.front().run.timeline();
  const std::size_t first = moments_.front();
  const bool regular = even(timeline, first, moments_.back());
  for (const std::size_t m : moments_) {
    // As LiveSource's frames have it: not the sum of the steps.
    times_.push_back(regular && m > first ? timeline[first].report.time +
                                                timeline[first + 1].params->h * static_cast<double>(m - first)
                                          : timeline[m].report.time);
  }
  for (Shown& shown : shown_) {
    const Timeline& own = shown.run.timeline();
    last_.push_back(&own == &timeline ? first : moment_in_step(timeline, first, own));
    shown.run.observe(iterations, contacts, bodies);
  }
}

// The first run to a moment. Others are taken along from each moment to the next, as their distance is measured at all of
// them.
bool PastSource::go_to(std::size_t moment, const Stop& stop) {
  Run& a = shown_.front().run;
  const bool alone = shown_.size() == 1;
  while (a.cursor() < moment) {
    if (stop()) return false;
    a.seek(alone ? moment : a.timeline().next_kept(a.cursor()));
    for (std::size_t k = 1; k < shown_.size(); ++k) rejoin(a, shown_[k].run);
    measure_distance();
  }
  return true;
}

std::optional<Frame> PastSource::next(const Stop& stop) {
  if (next_ == count()) return {};
  if (next_ == 0) {
    for (std::size_t k = 0; k < shown_.size(); ++k) shown_[k].run.seek(last_[k]);
  }
  drop_old_distances();
  const int frame = next_++;
  if (!go_to(moments_[static_cast<std::size_t>(frame)], stop)) return {};
  std::vector<FrameView> views;
  for (std::size_t k = 0; k < shown_.size(); ++k) {
    Shown& shown = shown_[k];
    const Run& run = shown.run;
    for (std::size_t i = last_[k] + 1; i <= run.cursor(); ++i) {
      if (!run.timeline()[i].start) add_report(shown.reports, run.timeline()[i].report);
    }
    last_[k] = std::max(last_[k], run.cursor());
    shown.widen_span();
    shown.trails.add(run.model(), run.state());
    FrameView& view = views.emplace_back(shown.view());
    view.params = params_at(run.timeline(), run.cursor());
    view.kappa = resolve_kappa(*view.model, view.params);
  }
  return RunSource::frame(frame, std::move(views));
}

}  // namespace pabd
