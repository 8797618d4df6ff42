// SPDX-License-Identifier: MIT
// A picture without a background, from the same picture on black and on white.
#pragma once

#include "render/output/image.h"

namespace pabd {

// For each pixel, in linear light: black = α c, white = α c + (1 − α). Precondition: both have the same size.
Image matte(const Image& on_black, const Image& on_white);

}  // namespace pabd
