// SPDX-License-Identifier: MIT
// Which step belongs to a time: the one rule for the frames of a run, for going back to a time, and for a
// second run B beside the first one, A (window, videos and `pabd render --ab` alike).
//
//   t      a time: of a frame, or where A is                  s
//   t_k    when step k ends, of length h; t_0 is the start    s
//
// It is the last step that is not after t: the largest k with t_k ≤ t. There is no interpolation: every
// picture is a state that was computed. So B is where A is or up to h_B behind, and the two have a time in
// common only where steps of both end.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pabd {

// Tolerance of times: they are sums of steps that were rounded when written, and h = 0.0166667 should fit 60 frames a
// second. A part of the time, at most a part of a step.
inline constexpr double kForgivenOfTime = 1e-5, kForgivenOfStep = 0.1;

inline double forgiven(double t, double h) {
  return std::min(kForgivenOfTime * std::abs(t), kForgivenOfStep * h);
}

// Whether a step of length h that ends at `end` is not after t.
inline bool is_reached(double end, double t, double h) { return end <= t + forgiven(t, h); }

// Whether two steps end at the same time; h is the length of B's.
inline bool is_common_time(double a, double b, double h) { return std::abs(a - b) <= forgiven(a, h); }

// k where all steps have the length h and t_0 = 0.
inline std::int64_t steps_until(double t, double h) {
  return static_cast<std::int64_t>(std::floor((t + forgiven(t, h)) / h));
}

// The step that frame f of a run from t = 0 shows: that of its time f/fps. Frame 0 is the initial state.
inline std::int64_t step_of_frame(std::int64_t frame, double fps, double h) {
  return steps_until(static_cast<double>(frame) / fps, h);
}

}  // namespace pabd
