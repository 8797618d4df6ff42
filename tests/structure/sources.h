// SPDX-License-Identifier: MIT
// The project's C++ files as text.
#pragma once

#include <string>
#include <vector>

namespace pabd {

struct Source {
  std::string path;  // from the repository root
  std::string text;
  std::vector<std::string> includes;
  std::size_t lines = 0;
};

// Every C++ file of the project's own folders, sorted by path; read once.
const std::vector<Source>& sources();

}  // namespace pabd
