// SPDX-License-Identifier: MIT
// Images for encoders that want even sides.
#pragma once

#include "render/output/image.h"

namespace pabd {

// With more columns at the right and rows below, which repeat the last ones: black there would be seen in what is
// encoded. Precondition: not smaller, not empty. Colours only.
Image extended(const Image& image, int width, int height);

}  // namespace pabd
