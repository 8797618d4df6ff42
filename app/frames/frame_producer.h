// First stage of the render pipeline: simulates, in a thread of its own, and hands out what each frame shows.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "app/frames/bounded_queue.h"
#include "app/plots/figures/difference.h"
#include "app/session/session.h"

namespace pabd {

// A copy of everything one frame shows; the simulation is already further on when it is drawn.
struct FramePacket {
  int frame = 0;
  State state;
  StepReport report;                 // of the last step, with what the overlays asked for
  std::vector<StepSummary> since;    // of the steps since the packet before
  std::shared_ptr<FramePacket> b;    // the second run at the same time, if there is one
  std::vector<DistancePoint> apart;  // how far it is from this one, at common times since the packet before
};

// Frames [first, count) are handed out; those before are simulated only.
struct FrameRange {
  int first = 0;
  int count = 0;
  double fps = 60;
};

class FrameProducer {
 public:
  using StopRequested = std::function<bool()>;
  using Skipped = std::function<void(int frame, const StepReport& report)>;

  // Starts. `stop` is asked before and in every step, from any thread, `skipped` is told of frames before
  // `range.first`, in the producer's thread. `session` must outlive this and is not to be touched meanwhile,
  // `b` too: a second run in step with the first one (step_at_time.h); may be null.
  FrameProducer(Session& session, FrameRange range, StopRequested stop, Skipped skipped,
                Session* b = nullptr);
  ~FrameProducer();  // stops and joins
  FrameProducer(const FrameProducer&) = delete;
  FrameProducer& operator=(const FrameProducer&) = delete;

  // The next frame, in order; empty after the last one, or when stopped or diverged. Throws what the
  // simulation threw.
  std::optional<FramePacket> next();
  // Gives a packet's memory back.
  void recycle(FramePacket packet);

  // Ends the thread, in the middle of a step if need be.
  void stop();
  // These are valid after stop(), or after next() was empty.
  const Session* diverged() const { return diverged_; }  // the run that left the numbers; null: none
  double busy_seconds() const { return busy_seconds_; }  // spent on simulating and copying, not on waiting

 private:
  void run();
  bool advance_to(std::int64_t step);
  bool follow();
  bool make_step(Session& session, std::vector<StepSummary>& since);
  FramePacket pack(int frame);

  Session& session_;
  Session* const b_;
  const FrameRange range_;
  const StopRequested stop_requested_;
  const Skipped skipped_;
  BoundedQueue<FramePacket> ready_{3};
  BoundedQueue<FramePacket> spent_{8};  // more than there ever are packets: giving back never waits
  std::vector<StepSummary> since_, since_b_;
  std::vector<DistancePoint> apart_;
  std::atomic<bool> stopped_ = false;
  const Session* diverged_ = nullptr;
  double busy_seconds_ = 0;
  std::exception_ptr failure_;
  std::thread thread_;
};

}  // namespace pabd
