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
#include <cstddef>
#include <cstdint>
#include <functional>

namespace pabd {

class Run;
class Timeline;

// Times are sums of steps, and steps are rounded where they are written: h = 0.0166667 and 60 frames a second
// go together. Forgiven: a part of the time, at most a part of a step.
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

// The moment of B's past that belongs to moment i of A's.
std::size_t moment_in_step(const Timeline& a, std::size_t i, const Timeline& b);

// B to where A went on to, as far as B has been there already.
void rejoin(const Run& a, Run& b);
// And from there with new steps; `made` is called after each. False when one could not be made
// (Run::advance).
bool follow(const Run& a, Run& b, const std::function<void()>& made = {});

// Whether the steps that led A and B to where they are end at the same time, with the same number of bodies:
// then the two states can be compared.
bool at_common_time(const Run& a, const Run& b);

}  // namespace pabd
