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

// The light reports behind `from`, up to moment `to`.
std::vector<StepReport> reports(const Timeline& timeline, std::size_t from, std::size_t to) {
  std::vector<StepReport> out;
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
  if (b_) reported_b_ = b_->timeline().at_time(timeline[first].report.time);
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

PastPacket PastProducer::pack(int frame) {
  const auto fill = [frame](Run& run, std::size_t moment, std::size_t& reported, FramePacket& out) {
    run.seek(moment);
    out.frame = frame;
    out.state = run.state();
    out.report = run.report();
    out.since = reports(run.timeline(), reported, moment);
    reported = std::max(reported, moment);
  };
  PastPacket packet;
  const std::size_t moment = moments_[static_cast<std::size_t>(frame)];
  fill(a_, moment, reported_, packet.frame);
  packet.model = a_.shared_model();
  packet.params = params_at(a_.timeline(), moment);
  if (b_) {
    packet.frame.b = std::make_shared<FramePacket>();
    const std::size_t moment_b = b_->timeline().at_time(a_.state().time);
    fill(*b_, moment_b, reported_b_, *packet.frame.b);
    packet.model_b = b_->shared_model();
    packet.params_b = params_at(b_->timeline(), moment_b);
    const StateDistance apart = state_distance(a_.state(), b_->state());
    packet.frame.apart = {{a_.state().time, apart.position, apart.angle}};
  }
  return packet;
}

void PastProducer::run() {
  try {
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
