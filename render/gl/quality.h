// SPDX-License-Identifier: MIT
// How much work a picture is worth.
#pragma once

#include <array>
#include <cstddef>

namespace pabd {

// How smooth things look, not what is shown: draft has jagged edges and hard shadows; good, the default, what files are
// made with; best four samples a pixel, at three times the time.
enum class Quality { draft, good, best };

struct RenderQuality {
  Quality level = Quality::good;
  float tolerance = 0.35f;  // how far outlines of round bodies may be from the truth; pixels
  int shadow_side =
      0;  // of the shadow map, for scenes of very many small bodies: a multiple of 8 texels. 0: 512

  // A pixel. `software`: drawn by the processor, for which more than one is dear.
  constexpr int samples(bool software) const {
    return level == Quality::best || (level == Quality::good && !software) ? 4 : 1;
  }
  // Edges are smoothed along the outlines that are found in the picture, where one sample leaves them jagged.
  constexpr bool smooth_outlines() const { return level == Quality::good; }
  // Darkness where bodies come close to the floor.
  constexpr bool soft_light() const { return level != Quality::draft; }
  // Of a side of the shadow map, whose edges are 6 texels wide, in drafts 2.
  constexpr int shadow_texels() const { return shadow_side > 0 ? shadow_side : 512; }

  // For a window whose picture changes all the time, on a machine that draws without a GPU.
  static constexpr RenderQuality live() { return {Quality::draft, 0.8f}; }

  bool operator==(const RenderQuality&) const = default;
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
