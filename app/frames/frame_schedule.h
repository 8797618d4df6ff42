// Which step a frame shows.
//
//   h      time step                  s
//   fps    frames a second            1/s
//   f      frame number, from 0       –
//
// Frame f shows the last step that is not after its time f/fps: step ⌊f/(fps h)⌋. Frame 0 is the initial
// state. There is no interpolation: every picture is a state that was computed.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pabd {

// Forgiven: a part of the time, so that h = 0.0166667 and 60 frames a second go together; at most a tenth of
// a step.
inline constexpr double kRoundedStep = 1e-5;

// Steps that fit into `time` seconds.
inline std::int64_t steps_until(double time, double h) {
  const double steps = time / h;
  return static_cast<std::int64_t>(std::floor(steps + std::min(kRoundedStep * steps, 0.1)));
}

inline std::int64_t step_of_frame(std::int64_t frame, double fps, double h) {
  return steps_until(static_cast<double>(frame) / fps, h);
}

}  // namespace pabd
