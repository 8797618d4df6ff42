// SPDX-License-Identifier: MIT
// Numbers with units, as people type them into fields.
#pragma once

#include <string>
#include <string_view>

namespace pabd {

// What was typed into a field of that unit, as --set takes it: "5 cm" in a field of m is "0.05", "5 m" and "5" are "5".
// What is not of that unit stays as it was typed: --set refuses it with what it expects.
std::string typed_number(std::string_view text, std::string_view unit);

}  // namespace pabd
