// SPDX-License-Identifier: MIT
// The one font of the program, DejaVu Sans, embedded at build time so that the program runs where it is not
// installed.
#pragma once

#include <span>

namespace pabd {

// The bytes of the TrueType file; valid for the life of the program.
std::span<const unsigned char> font_bytes();

}  // namespace pabd
