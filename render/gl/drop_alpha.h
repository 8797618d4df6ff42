// SPDX-License-Identifier: MIT
// From the pixels that GL hands out to those of an Image.
#pragma once

#include <cstdint>

#include "sim/math/team.h"

namespace pabd {

// Copies rows of (r, g, b, a), the lowest first, to rows of (r, g, b), the highest first; the same bytes with any number
// of threads.
void drop_alpha(const std::uint8_t* rgba, int width, int height, Team& team, int threads, std::uint8_t* rgb);

// With how many threads it is fastest where so many CPUs are: 1 for frames of less than a million pixels, which take less
// than half a millisecond; at most 8, as then it is memory that is slow.
int drop_alpha_threads(int width, int height, int cpus);

}  // namespace pabd
