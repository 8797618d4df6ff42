// SPDX-License-Identifier: MIT
// Which step a frame shows.
//
//   h      time step                  s
//   fps    frames a second            1/s
//   f      frame number, from 0       –
//
// Frame f shows the last step that is not after its time f/fps (step_at_time.h): step ⌊f/(fps h)⌋. Frame 0 is
// the initial state.
#pragma once

#include "app/session/step_at_time.h"

namespace pabd {

inline std::int64_t step_of_frame(std::int64_t frame, double fps, double h) {
  return steps_until(static_cast<double>(frame) / fps, h);
}

}  // namespace pabd
