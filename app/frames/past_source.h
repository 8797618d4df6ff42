// SPDX-License-Identifier: MIT
// Frames of a run that was made already, in this process or in a recording: it is wound through its past.
// They are the frames that LiveSource simulates.
#pragma once

#include <vector>

#include "app/frames/frame_source.h"

namespace pabd {

// Which part of the past, in seconds of the simulation; a negative end means the first or last moment.
struct PastRange {
  double from = -1, to = -1;
  double fps = 60;
};

// Which moment each frame shows. Where all steps are of the same length, those that `pabd render` shows; else
// the last one that is not after the frame's time. T seconds have T·fps frames, one at least. Of what a device made,
// frames show what is kept (Timeline::kept).
std::vector<std::size_t> moments_of_frames(const Timeline& timeline, const PastRange& range);

class PastSource : public FrameSource {
 public:
  // `iterations`, `contacts`: what reports carry. The parameters of a frame are those that its last step was
  // made with. `trails`: what leaves one, from frame to frame.
  PastSource(Run a, std::optional<Run> b, const PastRange& range, bool iterations, bool contacts,
             const TrailRecorder& trails = {});

  std::optional<Frame> next(const Stop& stop) override;

  // These never change.
  int count() const { return static_cast<int>(moments_.size()); }
  // Of the simulation at a frame; s.
  double time(int frame) const { return times_[static_cast<std::size_t>(frame)]; }

 private:
  // A run, and what was seen of its past.
  struct Seen {
    Run run;
    std::size_t last;  // moment up to which reports has them
    ReportList reports;
    TrailRecorder trails;

    FrameView view();
  };
  bool go_to(std::size_t moment, const Stop& stop);

  Seen a_;
  std::optional<Seen> b_;
  std::vector<std::size_t> moments_;
  std::vector<double> times_;
  int next_ = 0;
  DistanceList apart_;
};

}  // namespace pabd
