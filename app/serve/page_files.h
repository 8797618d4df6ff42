// SPDX-License-Identifier: MIT
// The files of the page, which are part of the program.
#pragma once

#include <string_view>

namespace pabd {

struct PageFile {
  std::string_view name, type, bytes;
};

// Null when there is none of that name.
const PageFile* find_page_file(std::string_view name);

}  // namespace pabd
