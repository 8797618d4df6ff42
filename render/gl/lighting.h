// SPDX-License-Identifier: MIT
// How the studio is lit, as shaders and tests take it: one sun, a sky above and light thrown back from the floor.
// Linear-light RGB; what the numbers mean is said in render/visual/picture_theme.h.
#pragma once

#include "render/visual/picture_theme.h"

namespace pabd::lighting {

inline constexpr const float (&kSun)[3] = kStudioTheme.sun;
inline constexpr const float (&kSky)[3] = kStudioTheme.sky;
inline constexpr const float (&kBounce)[3] = kStudioTheme.bounce;
inline constexpr const float (&kBackgroundTop)[3] = kStudioTheme.top;
inline constexpr const float (&kBackgroundBottom)[3] = kStudioTheme.bottom;
inline constexpr const float (&kFloor)[3] = kStudioTheme.floor;

}  // namespace pabd::lighting
