// SPDX-License-Identifier: MIT
// See frame_thread.h.
#include "app/frames/frame_thread.h"

#include <chrono>
#include <utility>

namespace pabd {

FrameThread::FrameThread(FrameSource& source, FrameSource::Stop stop)
    : source_(source), asked_to_stop_(std::move(stop)) {
  thread_ = std::thread([this] { run(); });
}

FrameThread::~FrameThread() { stop(); }

void FrameThread::stop() {
  stopped_ = true;
  ready_.close();
  if (thread_.joinable()) thread_.join();
}

std::optional<Frame> FrameThread::next(bool wait) {
  auto frame = wait ? ready_.pop() : ready_.try_pop();
  if (!frame && failed_) std::rethrow_exception(failure_);
  return frame;
}

void FrameThread::run() {
  using Clock = std::chrono::steady_clock;
  const auto stop = [this] { return stopped_ || (asked_to_stop_ && asked_to_stop_()); };
  try {
    for (std::optional<Frame> frame;;) {
      const auto start = Clock::now();
      frame = source_.next(stop);
      busy_seconds_ += std::chrono::duration<double>(Clock::now() - start).count();
      if (!frame || !ready_.push(*std::move(frame))) break;
    }
  } catch (...) {
    failure_ = std::current_exception();
    failed_ = true;
  }
  ready_.close();
}

}  // namespace pabd
