// SPDX-License-Identifier: MIT
// Where pictures come from. A run as it is made, the past of one, a recording, each alone or with a second
// run beside it: all hand out the same frames, by one rule of which step belongs to which time
// (frame_schedule.h, app/session/step_at_time.h).
#pragma once

#include <functional>
#include <optional>

#include "app/plots/figures/difference.h"
#include "app/session/frame_view.h"
#include "app/session/run.h"

namespace pabd {

using DistanceList = SharedList<DistancePoint>;

// What one picture shows: a value, as its views are.
struct Frame {
  int number = 0;  // from 0
  FrameView a;
  std::optional<FrameView> b;  // a second run at the time of the first one
  DistanceList::View apart;    // how far the two are from each other at common times; oldest first
};

// Names the two A and B where there are two.
Frame make_frame(int number, FrameView a, std::optional<FrameView> b, const DistanceList& apart);

class FrameSource {
 public:
  using Stop = std::function<bool()>;

  virtual ~FrameSource() = default;

  // The next frame, in order. None after the last one, when `stop` says true (it is asked before and in every
  // step), or when a run left the numbers; it is not to be asked for more then.
  virtual std::optional<Frame> next(const Stop& stop) = 0;
};

// Adds how far two runs are apart, where they are at a common time.
void add_distance(const Run& a, const Run& b, DistanceList& distances);
// Before a frame: a plot shows no more of the past than this leaves.
void drop_old(DistanceList& distances);

}  // namespace pabd
