// SPDX-License-Identifier: MIT
// Tab completion for shells, made from the options themselves.
#pragma once

#include <string>
#include <vector>

#include "app/cli/common.h"

namespace pabd::cli {

// What may stand behind an option or as an argument.
struct Completion {
  enum class Kind { none, words, list, scene, setting, file, folder };
  Kind kind = Kind::none;
  std::vector<std::string> words;  // of kind words; of kind list, joined by commas
};
Completion completion_of(const CLI::Option& option);

// "bash", "zsh", "fish": what the shell reads to complete the program. Throws Error(bad_input) for another one.
std::string completion_script(const CLI::App& program, const std::string& shell);

}  // namespace pabd::cli
