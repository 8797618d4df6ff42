// SPDX-License-Identifier: MIT
// How the scene is lit: one sun, a sky above and light thrown back from the floor. Linear-light RGB.
//
//   displayed = albedo · (ambient(n) + sun · max(n·l, 0) · visibility) + highlight
//   ambient(n) = mix(bounce, sky, ½ + ½ n·up)
#pragma once

namespace pabd::lighting {

inline constexpr float kSun[3] = {0.92f, 0.87f, 0.80f};
inline constexpr float kSky[3] = {0.47f, 0.50f, 0.55f};
inline constexpr float kBounce[3] = {0.30f, 0.29f, 0.28f};

// Background, from the top of the frame to its bottom, and the floor where it is fully lit.
inline constexpr float kBackgroundTop[3] = {0.62f, 0.68f, 0.75f};
inline constexpr float kBackgroundBottom[3] = {0.83f, 0.84f, 0.85f};
inline constexpr float kFloor[3] = {0.72f, 0.72f, 0.715f};

}  // namespace pabd::lighting
