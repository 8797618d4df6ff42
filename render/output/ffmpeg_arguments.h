// SPDX-License-Identifier: MIT
// The command line of an encoder.
#pragma once

#include <string>
#include <vector>

namespace pabd {

using Arguments = std::vector<std::string>;

inline void append(Arguments& arguments, const Arguments& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
}

}  // namespace pabd
