// The simulation stage.
#include "app/frames/frame_producer.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/frames/frame_schedule.h"

namespace pabd {

FrameProducer::FrameProducer(Session& session, FrameRange range, StopRequested stop, Skipped skipped,
                             Session* b)
    : session_(session),
      b_(b),
      range_(range),
      stop_requested_(std::move(stop)),
      skipped_(std::move(skipped)) {
  thread_ = std::thread([this] { run(); });
}

FrameProducer::~FrameProducer() { stop(); }

void FrameProducer::stop() {
  stopped_ = true;
  ready_.close();
  if (thread_.joinable()) thread_.join();
}

std::optional<FramePacket> FrameProducer::next() {
  auto packet = ready_.pop();
  if (!packet && failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
  return packet;
}

void FrameProducer::recycle(FramePacket packet) { spent_.push(std::move(packet)); }

// False when the run ends here.
bool FrameProducer::make_step(Session& session, std::vector<StepSummary>& since) {
  if (stopped_ || stop_requested_()) return false;
  session.stop_when([this] { return stopped_ || stop_requested_(); });
  const StepReport& report = session.step();
  if (report.status == StepStatus::interrupted) return false;
  if (report.status == StepStatus::non_finite) {
    diverged_ = &session;
    return false;
  }
  since.push_back(report.summary());
  return true;
}

bool FrameProducer::advance_to(std::int64_t step) {
  while (session_.state().step < step) {
    if (!make_step(session_, since_) || !follow()) return false;
  }
  return true;
}

// The second run to the time of the first one.
bool FrameProducer::follow() {
  if (!b_) return true;
  const double time = session_.state().time, h = b_->params().h;
  while (is_reached(b_->state().time + h, time, h)) {
    if (!make_step(*b_, since_b_)) return false;
  }
  if (!is_common_time(time, b_->state().time, h)) return true;
  const StateDistance apart = state_distance(session_.state(), b_->state());
  apart_.push_back({time, apart.position, apart.angle});
  return true;
}

FramePacket FrameProducer::pack(int frame) {
  FramePacket packet = spent_.try_pop().value_or(FramePacket{});
  packet.frame = frame;
  packet.state = session_.state();
  packet.report = session_.report();
  packet.since.clear();
  std::swap(packet.since, since_);
  if (b_) {
    if (!packet.b) packet.b = std::make_shared<FramePacket>();
    packet.b->frame = frame;
    packet.b->state = b_->state();
    packet.b->report = b_->report();
    packet.b->since.clear();
    std::swap(packet.b->since, since_b_);
    packet.apart.clear();
    std::swap(packet.apart, apart_);
  }
  return packet;
}

void FrameProducer::run() {
  using Clock = std::chrono::steady_clock;
  try {
    const std::int64_t first_step = session_.state().step;
    for (int frame = 0; frame < range_.count; ++frame) {
      const auto start = Clock::now();
      // A state that a run continues from may be at any step: frames count from it.
      if (!advance_to(first_step + step_of_frame(frame, range_.fps, session_.params().h))) break;
      std::optional<FramePacket> packet;
      if (frame >= range_.first) packet = pack(frame);
      busy_seconds_ += std::chrono::duration<double>(Clock::now() - start).count();
      if (!packet) {
        skipped_(frame, session_.report());
      } else if (!ready_.push(*std::move(packet))) {
        break;
      }
    }
  } catch (...) {
    failure_ = std::current_exception();
  }
  ready_.close();
}

}  // namespace pabd
