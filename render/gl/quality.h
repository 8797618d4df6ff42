// How much work a picture is worth.
#pragma once

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

}  // namespace pabd
