// SPDX-License-Identifier: MIT
// Can ffmpeg encode so on this machine?
#pragma once

#include <string>
#include <vector>

namespace pabd {

// Encodes one frame for nobody, with what ffmpeg is told before its input and for its output. What is against it, in
// one line; empty: it can.
std::string encoder_complaint(const std::vector<std::string>& device, const std::vector<std::string>& codec);

}  // namespace pabd
