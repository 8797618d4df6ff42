// SPDX-License-Identifier: MIT
// Tab completion for shells, read off the options themselves.
#pragma once

#include <string>
#include <vector>

#include "app/cli/common.h"

namespace pabd::cli {

// In place of the first word: "pabd help plot".
inline constexpr const char* kHelpWord = "help";

// What may stand in place of the last of `words`, which follow "pabd"; it may be empty. Lines: see completion.cpp.
std::string completions(const CLI::App& program, const std::vector<std::string>& words);

}  // namespace pabd::cli
