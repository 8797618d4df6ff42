// SPDX-License-Identifier: MIT
// Manual pages from the texts of --help.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/cli/common.h"

namespace pabd::cli {

// Text as troff takes it: what it would read as a command, and what is not ASCII, is written out.
std::string troff(std::string_view text);

struct ManPage {
  std::string file;  // "pabd-plot-barrier.1"
  std::string text;  // troff with the macros of man(7)
};

// A page for the program and for every command in sight, in the order of the help.
std::vector<ManPage> man_pages(const CLI::App& program);

}  // namespace pabd::cli
