// SPDX-License-Identifier: MIT
// How much work a picture is worth.
#pragma once

#include <array>
#include <cstddef>

namespace pabd {

// The default is what files are made with. The settings change how smooth things look, not what is shown.
struct RenderQuality {
  int samples = 4;  // a pixel: 4 or 1
  // Shadows with edges over 6×6 texels, and darkness where bodies come close to the floor; else edges over
  // 2×2 texels only.
  bool soft_light = true;
  float tolerance = 0.35f;  // how far outlines of round bodies may be from the truth; pixels

  // For a window whose picture changes all the time, on a machine that draws without a GPU: six times as
  // fast.
  static constexpr RenderQuality live() { return {1, false, 0.8f}; }
};

// Chooses how much smaller than its place a live picture is drawn, so that it takes no longer than a budget
// on whatever machine it is. Scaling it costs a tenth of what drawing it does. Never swings between two
// sizes while the scene stays the same.
class LiveScale {
 public:
  explicit LiveScale(double budget_ms = 20) : budget_(budget_ms) {}

  double scale() const { return kScales[static_cast<std::size_t>(at_)]; }  // of both sides
  // Milliseconds that the last picture took, drawn at scale().
  void took(double ms);

 private:
  static constexpr std::array<double, 5> kScales = {1, 0.85, 0.7, 0.5, 0.35};
  double budget_;
  int at_ = 0;
  int votes_ = 0;  // pictures in a row that were too slow (> 0), or fast enough for the next size (< 0)
};

}  // namespace pabd
