// SPDX-License-Identifier: MIT
// How many, as people say it.
#pragma once

#include <concepts>
#include <string>
#include <string_view>

namespace pabd {

// "1 frame", "0 frames", "3 bodies": a plural that adds s is made from `one`, any other is
// given as `many`.
inline std::string counted(std::integral auto n, std::string_view one, std::string_view many = "") {
  std::string out = std::to_string(n) + " ";
  out += n == 1 || many.empty() ? one : many;
  if (n != 1 && many.empty()) out += 's';
  return out;
}

}  // namespace pabd
