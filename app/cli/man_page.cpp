// SPDX-License-Identifier: MIT
// See man_page.h.
#include "app/cli/man_page.h"

#include <fmt/format.h>

#include <sstream>

#include "app/cli/help_text.h"
#include "app/plots/rich_text.h"

namespace pabd::cli {
namespace {

// "pabd plot barrier": the words that start a command.
std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : between) + word;
  return out;
}

// "-o, --out OUT", or in short "-o OUT"; "SCENE".
std::string signature(const CLI::Option& option, bool in_short = false) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("\\fB\\-" + troff(name) + "\\fR");
  for (const std::string& name : option.get_lnames()) names.push_back("\\fB\\-\\-" + troff(name) + "\\fR");
  if (names.empty()) return "\\fI" + troff(option.get_single_name()) + "\\fR";
  if (in_short) names.resize(1);
  const std::string type = value_name(option);
  return joined(names, ", ") + (type.empty() ? "" : " \\fI" + troff(type) + "\\fR");
}

std::string entry(const std::string& term, const std::string& words) {
  return ".TP\n" + term + "\n" + troff(words) + "\n";
}

std::string entries(const std::vector<const CLI::Option*>& options) {
  std::string out;
  for (const CLI::Option* option : options) out += entry(signature(*option), option_words(*option));
  return out;
}

// A section of arguments, and one of options with a part for each group.
std::string options_sections(const CLI::App& command) {
  const auto arguments = arguments_of(command);
  std::string out = arguments.empty() ? "" : ".SH ARGUMENTS\n" + entries(arguments);
  out += ".SH OPTIONS\n";
  for (const OptionGroup& group : option_groups(command))
    out += ".SS " + troff(group.name) + "\n" + entries(group.options);
  return out;
}

std::string synopsis(const CLI::App& command, const std::string& path) {
  std::string out = ".B " + troff(path) + "\n";
  const std::string below = out + "\\fICOMMAND\\fR [\\fIOPTIONS\\fR]\n";
  const bool commands = !subcommands_of(command).empty(), both = commands && !arguments_of(command).empty();
  if (commands && !both) return below;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional() || !option->get_required()) continue;
    out += signature(*option, true) + "\n";
  }
  out += "[\\fIOPTIONS\\fR]\n";
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional()) continue;
    out += option->get_required() || both ? signature(*option) : "[" + signature(*option) + "]";
    out += "\n";
  }
  return both ? out + ".br\n" + below : out;
}

// What stands below the options: "Examples:" and lines of two blanks, then perhaps "Exit codes: …".
std::string footer_sections(const std::string& footer) {
  std::string out;
  bool listing = false;
  const auto end_listing = [&] {
    if (listing) out += ".fi\n.RE\n";
    listing = false;
  };
  std::istringstream lines(footer);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("Example")) {
      out += ".SH EXAMPLES\n.RS\n.nf\n";
      listing = true;
    } else if (line.starts_with("Exit codes: ")) {
      end_listing();
      out += ".SH EXIT STATUS\n" + troff(line.substr(line.find(' ', 5) + 1)) + "\n";
    } else {
      const std::size_t first = line.find_first_not_of(' ');
      if (first != line.npos) out += troff(line.substr(first)) + "\n";
    }
  }
  end_listing();
  return out;
}

ManPage page_of(const CLI::App& command, const std::vector<std::string>& words,
                const std::vector<std::string>& see_also) {
  const std::string name = joined(words, "-");
  ManPage page;
  page.file = name + ".1";
  page.text = fmt::format(".TH {} 1 \"\" \"pabd {}\" \"pabd\"\n.SH NAME\n{} \\- {}\n.SH SYNOPSIS\n{}",
                          troff(name), PABD_VERSION, troff(name), troff(command.get_description()),
                          synopsis(command, joined(words, " ")));
  std::string commands;
  for (const CLI::App* each : subcommands_of(command))
    commands += entry("\\fB" + troff(each->get_name()) + "\\fR", each->get_description());
  if (!commands.empty()) page.text += ".SH COMMANDS\n" + commands;
  page.text += options_sections(command) + footer_sections(command.get_footer());
  page.text += ".SH SEE ALSO\n";
  for (std::size_t i = 0; i < see_also.size(); ++i)
    page.text += ".BR " + troff(see_also[i]) + " (1)" + (i + 1 < see_also.size() ? " ,\n" : "\n");
  return page;
}

// The page of a command, then those of the commands below it. `above`: the page of what it belongs to.
void add_pages(const CLI::App& command, std::vector<std::string> words, const std::string& above,
               std::vector<ManPage>& out) {
  std::vector<std::string> others;
  if (!above.empty()) others.push_back(above);
  for (const CLI::App* each : subcommands_of(command))
    others.push_back(joined(words, "-") + "-" + each->get_name());
  out.push_back(page_of(command, words, others));
  for (const CLI::App* each : subcommands_of(command)) {
    std::vector<std::string> longer = words;
    longer.push_back(each->get_name());
    add_pages(*each, longer, joined(words, "-"), out);
  }
}

}  // namespace

std::string troff(std::string_view text) {
  std::string out = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
  for (const char32_t c : decode_text(text)) {
    if (c == kDHat) {
      out += "d\\[u0302]";
    } else if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else if (c == '\'') {
      out += "\\(aq";
    } else if (c == '^') {
      out += "\\(ha";
    } else if (c == '~') {
      out += "\\(ti";
    } else if (c < 0x80) {
      out += static_cast<char>(c);
    } else {
      out += fmt::format("\\[u{:04X}]", static_cast<unsigned>(c));
    }
  }
  return out;
}

std::vector<ManPage> man_pages(const CLI::App& program) {
  std::vector<ManPage> out;
  add_pages(program, {program.get_name()}, "", out);
  return out;
}

}  // namespace pabd::cli
