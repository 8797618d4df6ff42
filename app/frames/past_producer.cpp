// See past_producer.h.
#include "app/frames/past_producer.h"

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

// The summaries behind `from`, up to moment `to`.
std::vector<StepSummary> reports(const Timeline& timeline, std::size_t from, std::size_t to) {
  std::vector<StepSummary> out;
  for (std::size_t i = from + 1; i <= to; ++i) {
    if (!timeline[i].start) out.push_back(timeline[i].report);
  }
  return out;
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
    out.push_back(std::clamp(moment, first, last));
  }
  return out;
}

PastProducer::PastProducer(Run a, std::optional<Run> b, const PastRange& range, bool iterations,
                           bool contacts)
    : a_(std::move(a)), b_(std::move(b)), moments_(moments_of_frames(a_.timeline(), range)) {
  const Timeline& timeline = a_.timeline();
  const std::size_t first = moments_.front();
  const bool regular = even(timeline, first, moments_.back());
  for (const std::size_t m : moments_) {
    // As FrameProducer's frames have it: not the sum of the steps.
    times_.push_back(regular && m > first ? timeline[first].report.time +
                                                timeline[first + 1].params->h * static_cast<double>(m - first)
                                          : timeline[m].report.time);
  }
  a_.observe(iterations, contacts);
  if (b_) b_->observe(iterations, contacts);
  reported_ = first;
  if (b_) reported_b_ = moment_in_step(timeline, first, b_->timeline());
  thread_ = std::thread([this] { run(); });
}

PastProducer::~PastProducer() {
  ready_.close();
  thread_.join();
}

std::optional<PastPacket> PastProducer::next(bool wait) {
  auto packet = wait ? ready_.pop() : ready_.try_pop();
  if (!packet && failed_) std::rethrow_exception(failure_);
  return packet;
}

// A to a moment. B is taken along from each moment to the next, as their distance is measured at all of them.
void PastProducer::go_to(std::size_t moment, std::vector<DistancePoint>& apart) {
  if (!b_) {
    if (moment != a_.cursor()) a_.seek(moment);
    return;
  }
  while (a_.cursor() < moment) {
    a_.seek(a_.cursor() + 1);
    const std::size_t moment_b = moment_in_step(a_.timeline(), a_.cursor(), b_->timeline());
    if (moment_b != b_->cursor()) b_->seek(moment_b);
    const double time = a_.state().time;
    if (a_.state().size() != b_->state().size()) continue;
    if (!is_common_time(time, b_->state().time, b_->timeline()[moment_b].params->h)) continue;
    const StateDistance distance = state_distance(a_.state(), b_->state());
    apart.push_back({time, distance.position, distance.angle});
  }
}

PastPacket PastProducer::pack(int frame) {
  const auto fill = [frame](const Run& run, std::size_t& reported, FramePacket& out) {
    out.frame = frame;
    out.state = run.state();
    out.report = run.report();
    out.since = reports(run.timeline(), reported, run.cursor());
    reported = std::max(reported, run.cursor());
  };
  PastPacket packet;
  const std::size_t moment = moments_[static_cast<std::size_t>(frame)];
  go_to(moment, packet.frame.apart);
  fill(a_, reported_, packet.frame);
  packet.model = a_.shared_model();
  packet.params = params_at(a_.timeline(), moment);
  if (b_) {
    packet.frame.b = std::make_shared<FramePacket>();
    fill(*b_, reported_b_, *packet.frame.b);
    packet.model_b = b_->shared_model();
    packet.params_b = params_at(b_->timeline(), b_->cursor());
  }
  return packet;
}

void PastProducer::run() {
  try {
    a_.seek(reported_);
    if (b_) b_->seek(reported_b_);
    for (int frame = 0; frame < count(); ++frame) {
      if (!ready_.push(pack(frame))) break;
    }
  } catch (...) {
    failure_ = std::current_exception();
    failed_ = true;
  }
  ready_.close();
}

}  // namespace pabd
