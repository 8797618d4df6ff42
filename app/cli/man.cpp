// SPDX-License-Identifier: MIT
// The manual pages: the texts of --help as troff with the macros of man(7), for 'man pabd-render'.
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "app/cli/help_text.h"
#include "app/cli/streams.h"

namespace pabd::cli {
namespace {

constexpr int kManColumns = 78;

// A line as troff takes it: what it would read as a command is written out.
std::string troff(const std::string& line) {
  std::string out = line.starts_with('.') || line.starts_with('\'') ? "\\&" : "";
  for (const char c : line) {
    const char* written = c == '\\' ? "\\e" : c == '-' ? "\\-" : c == '\'' ? "\\(aq" : nullptr;
    out += written != nullptr ? written : std::string(1, c);
  }
  return out + "\n";
}

}  // namespace

void write_manual(const CLI::App& command, const std::string& path, const std::string& folder) {
  std::string name = path;
  std::replace(name.begin(), name.end(), ' ', '-');
  const std::string about = command.get_description();
  std::string page =
      fmt::format(".TH {} 1 \"\" \"pabd {}\" \"pabd\"\n.SH NAME\n{} \\- {}.SH DESCRIPTION\n.nf\n", name,
                  PABD_VERSION, name, troff(about));
  std::istringstream lines(help_text(command, path, kManColumns));
  for (std::string line; std::getline(lines, line);) page += troff(line);
  TextOutput file("FOLDER", folder + "/" + name + ".1", true);
  file.write(page + ".fi\n");
  file.finish();
  for (const CLI::App* each : subcommands_of(command))
    write_manual(*each, path + " " + each->get_name(), folder);
}

}  // namespace pabd::cli
