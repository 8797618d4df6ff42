// Which step a frame shows.
//
//   h      time step                  s
//   fps    frames a second            1/s
//   f      frame number, from 0       –
//
// Frame f shows the last step that is not after its time f/fps: step ⌊f/(fps h)⌋. Frame 0 is the initial
// state. There is no interpolation: every picture is a state that was computed.
#pragma once

#include <cmath>
#include <cstdint>

namespace pabd::cli {

// A millionth of a step is forgiven, so that h = 0.0166666666666667 and 60 frames a second go together.
inline constexpr double kStepTolerance = 1e-6;

// Steps that fit into `time` seconds.
inline std::int64_t steps_until(double time, double h) {
  return static_cast<std::int64_t>(std::floor(time / h + kStepTolerance));
}

inline std::int64_t step_of_frame(std::int64_t frame, double fps, double h) {
  return steps_until(static_cast<double>(frame) / fps, h);
}

}  // namespace pabd::cli
