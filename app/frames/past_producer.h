// Frames of a run that was made already: winds a copy of it through its past, in a thread of its own, and
// hands out what each frame shows. The same frames as FrameProducer simulates.
#pragma once

#include <atomic>
#include <exception>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "app/frames/bounded_queue.h"
#include "app/frames/frame_producer.h"
#include "app/session/run.h"

namespace pabd {

// Which part of the past, in seconds of the simulation; a negative end means the first or last moment.
struct PastRange {
  double from = -1, to = -1;
  double fps = 60;
};

// Which moment each frame shows. Where all steps are of the same length, those that `pabd render` shows; else
// the last one that is not after the frame's time. T seconds have T·fps frames, one at least.
std::vector<std::size_t> moments_of_frames(const Timeline& timeline, const PastRange& range);

// A frame, and what it was made with where that differs from other frames.
struct PastPacket {
  FramePacket frame;
  std::shared_ptr<const Model> model, model_b;  // the latter null without a second run
  Params params, params_b;
};

class PastProducer {
 public:
  // Starts. `iterations`, `contacts`: what reports carry.
  PastProducer(Run a, std::optional<Run> b, const PastRange& range, bool iterations, bool contacts);
  ~PastProducer();  // stops and joins
  PastProducer(const PastProducer&) = delete;
  PastProducer& operator=(const PastProducer&) = delete;

  int count() const { return static_cast<int>(moments_.size()); }
  // Of the simulation at a frame; s.
  double time(int frame) const { return times_[static_cast<std::size_t>(frame)]; }

  // The next frame, in order; empty when it is not ready, or with `wait` only after the last one. Throws what
  // the thread threw.
  std::optional<PastPacket> next(bool wait);

 private:
  void run();
  void go_to(std::size_t moment, std::vector<DistancePoint>& apart);
  PastPacket pack(int frame);

  Run a_;
  std::optional<Run> b_;
  std::vector<std::size_t> moments_;
  std::vector<double> times_;
  std::size_t reported_ = 0, reported_b_ = 0;  // moments whose summaries were handed out
  BoundedQueue<PastPacket> ready_{3};
  std::atomic<bool> failed_ = false;
  std::exception_ptr failure_;  // set before failed_ is
  std::thread thread_;
};

}  // namespace pabd
