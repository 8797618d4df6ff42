// SPDX-License-Identifier: MIT
// What a frame of the window costs, part by part: smoothed milliseconds.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>

#include "app/gui/gui_layout.h"

namespace pabd {

struct GuiFrame;

class FrameCosts {
 public:
  enum Part : std::uint8_t { interface, picture, compose, other, kParts };  // other: showing it, waiting

  // Before anything of a frame.
  void begin();
  // The time since the last call belongs to `part`.
  void done(Part part);

  double ms(Part part) const { return ms_[part]; }
  double frames_a_second() const { return frame_ > 0 ? 1 / frame_ : 0; }

 private:
  using Clock = std::chrono::steady_clock;
  std::array<double, kParts> ms_{}, now_{};
  double frame_ = 0;  // s
  Clock::time_point begun_{}, last_{};
};

// The list of them, over the picture's top left corner; dashes in a `steady` window.
void draw_costs(GuiFrame& frame, const Rect& view);

}  // namespace pabd
