// SPDX-License-Identifier: MIT
// See help_text.h.
#include "app/cli/help_text.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>

#include "app/cli/streams.h"
#include "app/plots/rich_text.h"

namespace pabd::cli {
namespace {

constexpr int kLeastColumns = 40, kMostColumns = 120, kColumns = 80;
constexpr int kWidestTerm = 24;

int columns_of(std::string_view text) {
  int n = 0;
  // d̂ comes as one sign.
  for (const char32_t c : decode_text(text)) n += c < 0x300 || c > 0x36f ? 1 : 0;
  return n;
}

std::string term_of(const CLI::Option& option) {
  std::string out;
  for (const std::string& name : option.get_snames()) out += (out.empty() ? "-" : ", -") + name;
  for (const std::string& name : option.get_lnames()) out += (out.empty() ? "--" : ", --") + name;
  if (out.empty()) return option.get_single_name();
  const std::string value = value_name(option);
  return value.empty() ? out : out + " " + value;
}

struct Row {
  std::string term, words;
};

std::string rows_text(const char* title, const std::vector<Row>& rows, int columns) {
  if (rows.empty()) return "";
  int widest = 0;
  for (const Row& row : rows) {
    const int width = columns_of(row.term);
    if (width <= kWidestTerm) widest = std::max(widest, width);
  }
  const int indent = 2 + widest + 2;
  std::string out = std::string("\n") + title + ":\n";
  for (const Row& row : rows) {
    const int width = columns_of(row.term);
    out += "  " + row.term;
    out += width > widest ? "\n" + std::string(static_cast<std::size_t>(indent), ' ')
                          : std::string(static_cast<std::size_t>(indent - 2 - width), ' ');
    out += wrap(row.words, columns - indent, indent) + "\n";
  }
  return out;
}

std::string usage(const CLI::App& command, const std::string& path, int columns) {
  std::string out = path + " [OPTIONS]";
  const bool commands = !subcommands_of(command).empty(), both = commands && !arguments_of(command).empty();
  if (commands && !both) return "Usage: " + out + " COMMAND\n";
  for (const OptionGroup& group : option_groups(command)) {
    for (const CLI::Option* option : group.options) {
      if (!option->get_required()) continue;
      const auto& short_names = option->get_snames();
      out += short_names.empty() ? " --" + option->get_lnames().front() : " -" + short_names.front();
      out += " " + value_name(*option);
    }
  }
  for (const CLI::Option* option : arguments_of(command)) {
    const std::string name = option->get_single_name() + (option->get_expected_max() > 1 ? "…" : "");
    out += option->get_required() || both ? " " + name : " [" + name + "]";
  }
  out = "Usage: " + wrap(out, columns - 7, 7) + "\n";
  return both ? out + "       " + path + " COMMAND\n" : out;
}

// Examples stay as they can be copied; all else is wrapped.
std::string footer_text(const std::string& footer, int columns) {
  std::string out;
  std::istringstream lines(footer);
  for (std::string line; std::getline(lines, line);)
    out += (line.starts_with("  ") ? line : wrap(line, columns, 0)) + "\n";
  return out.empty() ? out : "\n" + out;
}

std::string names_of(const std::set<CLI::Option*>& options) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options) names.push_back(option->get_name());
  std::sort(names.begin(), names.end());
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : ", ") + name;
  return out;
}

}  // namespace

std::vector<OptionGroup> option_groups(const CLI::App& command) {
  std::vector<OptionGroup> out;
  for (const char* name : {group::kOutput, group::kPicture, group::kVideo, group::kSimulation})
    out.push_back({name, {}});
  OptionGroup last{group::kGeneral, {}};
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional() || option->get_group().empty()) continue;
    // What CLI11 adds itself stays in its own group.
    const bool general = option == command.get_help_ptr() || option == command.get_version_ptr();
    const std::string name = general ? group::kGeneral : option->get_group();
    if (name == group::kGeneral) {
      last.options.push_back(option);
      continue;
    }
    auto found = std::find_if(out.begin(), out.end(), [&](const OptionGroup& g) { return g.name == name; });
    if (found == out.end()) found = out.insert(out.end(), {name, {}});
    found->options.push_back(option);
  }
  out.push_back(last);
  std::erase_if(out, [](const OptionGroup& g) { return g.options.empty(); });
  return out;
}

std::vector<const CLI::Option*> arguments_of(const CLI::App& command) {
  std::vector<const CLI::Option*> out;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional() && !option->get_group().empty()) out.push_back(option);
  }
  return out;
}

std::vector<const CLI::App*> subcommands_of(const CLI::App& command) {
  return command.get_subcommands([](const CLI::App* each) { return !each->get_group().empty(); });
}

std::string value_name(const CLI::Option& option) {
  if (option.get_type_size() == 0) return "";
  const std::string type = option.get_type_name();
  std::size_t end = type.find(':');  // what is allowed is for the description to say
  if (end != std::string::npos && end > 0 && type[end - 1] == '[') end = type.find(':', end + 1);
  return type.substr(0, end);
}

std::string option_words(const CLI::Option& option) {
  std::string out = option.get_description();
  if (!option.get_excludes().empty()) out += "; not with " + names_of(option.get_excludes());
  if (!option.get_needs().empty()) out += "; only with " + names_of(option.get_needs());
  return out;
}

std::string wrap(std::string_view text, int columns, int indent) {
  std::string out;
  int used = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = text.find_first_not_of(' ', at);
    if (begin == text.npos) break;
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string_view word = text.substr(begin, end - begin);
    const int width = columns_of(word);
    if (used > 0 && used + 1 + width > columns) {
      out += "\n" + std::string(static_cast<std::size_t>(indent), ' ');
      used = 0;
    }
    if (used > 0) out += ' ';
    out += word;
    used += (used > 0 ? 1 : 0) + width;
    at = end;
  }
  return out;
}

std::string help_text(const CLI::App& command, const std::string& path, int columns) {
  std::string out = wrap(command.get_description(), columns, 0) + "\n\n" + usage(command, path, columns);
  std::vector<Row> rows;
  for (const CLI::App* each : subcommands_of(command))
    rows.push_back({each->get_name(), each->get_description()});
  out += rows_text("Commands", rows, columns);
  rows.clear();
  for (const CLI::Option* option : arguments_of(command))
    rows.push_back({term_of(*option), option_words(*option)});
  out += rows_text("Arguments", rows, columns);
  for (const OptionGroup& group : option_groups(command)) {
    rows.clear();
    for (const CLI::Option* option : group.options) rows.push_back({term_of(*option), option_words(*option)});
    out += rows_text(group.name.c_str(), rows, columns);
  }
  return out + footer_text(command.get_footer(), columns);
}

int help_columns() {
  int columns = 0;
  winsize size = {};
  if (stdout_is_terminal() && ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0) columns = size.ws_col;
  if (columns <= 0) {
    const char* said = std::getenv("COLUMNS");
    columns = said == nullptr ? 0 : std::atoi(said);
  }
  return columns <= 0 ? kColumns : std::clamp(columns, kLeastColumns, kMostColumns);
}

}  // namespace pabd::cli
