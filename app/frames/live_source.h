// SPDX-License-Identifier: MIT
// Frames of a run, or of two in step, that are simulated as they are asked for.
#pragma once

#include "app/frames/frame_source.h"

namespace pabd {

// Frames [first, count) are handed out; those before are simulated only.
struct FrameRange {
  int first = 0;
  int count = 0;
  double fps = 60;
};

class LiveSource : public FrameSource {
 public:
  using Skipped = std::function<void(int frames, const StepSummary& step)>;

  // The runs go on from where they are; no past is needed of them (kNoPast). `skipped` is told how many
  // frames before `range.first` are made, in the thread that asks for frames.
  // `trails`: what leaves a trail in each run, and for how long, in every step.
  LiveSource(Run a, std::optional<Run> b, const FrameRange& range, Skipped skipped = {},
             const TrailRecorder& trails = {});

  std::optional<Frame> next(const Stop& stop) override;

  // The step that left the numbers, and whether it was one of the second run; none: none did.
  struct Diverged {
    StepSummary step;
    bool in_b = false;
  };
  std::optional<Diverged> diverged() const;

 private:
  bool advance_to(std::int64_t step, const Stop& stop);
  Frame now(int frame) const;

  Run a_;
  std::optional<Run> b_;
  const FrameRange range_;
  const Skipped skipped_;
  const std::int64_t first_step_;  // a state that a run continues from may be at any step
  int next_ = 0;
  ReportList reports_a_, reports_b_;
  TrailRecorder trails_a_, trails_b_;
  DistanceList apart_;
};

}  // namespace pabd
