// SPDX-License-Identifier: MIT
// What one picture shows: a run, two that are compared, or a grid of runs, at one time.
#pragma once

#include <vector>

#include "app/plots/figures/convergence.h"
#include "app/plots/figures/difference.h"
#include "app/session/frame_view.h"

namespace pabd {

using DistanceList = SharedList<DistancePoint>;

// A value, as its views are.
struct Frame {
  int number = 0;               // from 0
  std::vector<FrameView> runs;  // one at least; the others at the time of the first one
  bool compared = false;        // two, A and B
  ConvergenceSpan span = {};    // of the steps up to here whose iterations are recorded, of all runs
  DistanceList::View apart;     // how far A and B are from each other at common times; oldest first

  const FrameView& a() const { return runs.front(); }
  const FrameView* b() const { return compared ? &runs[1] : nullptr; }  // null: there is none
  // The one that run is compared with; null: none.
  const FrameView* beside(std::size_t run) const { return compared ? &runs[1 - run] : nullptr; }
};

// Of one run, or of two to be compared, which get their names A and B.
Frame make_frame(int number, std::vector<FrameView> runs, const DistanceList& apart = {});

}  // namespace pabd
