// SPDX-License-Identifier: MIT
// Pictures that are computed from others in linear light.
#pragma once

#include "render/output/image.h"

namespace pabd {

// Half as wide and high; every pixel the mean of four. Odd last rows and columns are dropped.
Image halved(const Image& image);

// A picture without a background, from the same picture on black and on white: black = α c, white = α c + (1 − α).
// Precondition: both have the same size.
Image matte(const Image& on_black, const Image& on_white);

}  // namespace pabd
