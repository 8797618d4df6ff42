// SPDX-License-Identifier: MIT
// A thread that asks a source for frames and keeps a few ready, so that simulation and drawing overlap.
#pragma once

#include <atomic>
#include <exception>
#include <thread>

#include "app/frames/bounded_queue.h"
#include "app/frames/frame_source.h"

namespace pabd {

class FrameThread {
 public:
  // Starts the thread. `source` must outlive this and must not be used until stop(); the thread calls `stop`.
  explicit FrameThread(FrameSource& source, FrameSource::Stop stop = {});
  ~FrameThread();  // as stop()
  FrameThread(const FrameThread&) = delete;
  FrameThread& operator=(const FrameThread&) = delete;

  // The next frame, in order; empty when it is not ready, or with `wait` after the last one. Rethrows what the source
  // threw.
  std::optional<Frame> next(bool wait);

  // Ends the thread, in the middle of a step if need be.
  void stop();
  // Time spent in the source, without waiting; valid after stop(), or after next(true) was empty.
  double busy_seconds() const { return busy_seconds_; }

 private:
  void run();

  FrameSource& source_;
  const FrameSource::Stop asked_to_stop_;
  BoundedQueue<Frame> ready_{3};
  std::atomic<bool> stopped_ = false, failed_ = false;
  std::exception_ptr failure_;  // set before failed_ is
  double busy_seconds_ = 0;
  std::thread thread_;
};

}  // namespace pabd
