// SPDX-License-Identifier: MIT
// The texts of --help: options in groups, in the words of their descriptions, wrapped at a width.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/cli/common.h"

namespace pabd::cli {

struct OptionGroup {
  std::string name;
  std::vector<const CLI::Option*> options;
};
// The options of a command that are no arguments, by group.
std::vector<OptionGroup> option_groups(const CLI::App& command);
std::vector<const CLI::Option*> arguments_of(const CLI::App& command);
std::vector<const CLI::App*> subcommands_of(const CLI::App& command);  // those in sight

// What an option takes, as help names it: "OUT"; empty for a flag.
std::string value_name(const CLI::Option& option);
// The description, and which options it goes with or without: "length (default 5 s); not with --frames".
std::string option_words(const CLI::Option& option);

// Breaks at blanks so that no line is wider than `columns`, where words allow; every line but the first is
// set in by `indent`. One character, one column: accents that stand alone have none.
std::string wrap(std::string_view text, int columns, int indent);

// `path`: the words that start the command, "pabd plot barrier".
std::string help_text(const CLI::App& command, const std::string& path, int columns);

// Writes the manual pages of a command and of those below it: "pabd-plot-barrier.1". Throws Error(file).
void write_manual(const CLI::App& command, const std::string& path, const std::string& folder);

// Of the terminal that standard output is, else what COLUMNS says, else 80; 40 … 120.
int help_columns();

}  // namespace pabd::cli
