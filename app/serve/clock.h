// SPDX-License-Identifier: MIT
// Seconds of a steady clock.
#pragma once

#include <chrono>

namespace pabd {

inline double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace pabd
