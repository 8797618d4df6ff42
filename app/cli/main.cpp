// SPDX-License-Identifier: MIT
// The program: which subcommands there are, and what becomes of what they throw.
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/common.h"
#include "app/cli/completion.h"
#include "app/cli/help_text.h"
#include "app/cli/interrupt.h"
#include "app/cli/report_error.h"
#include "app/cli/streams.h"
#include "render/context/context.h"
#include "sim/scene/text.h"

namespace pabd::cli {
namespace {

// The subcommand the user was in, as typed: "pabd plot barrier".
std::string command_path(const CLI::App& app) {
  std::string path = "pabd";
  const CLI::App* command = &app;
  while (true) {
    const auto chosen = command->get_subcommands();
    if (chosen.empty()) return path;
    command = chosen.back();
    path += " " + command->get_name();
  }
}

const CLI::App* innermost(const CLI::App& app) {
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().back();
  return command;
}

std::vector<std::string> subcommands(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* choice : subcommands_of(command)) names.push_back(choice->get_name());
  return names;
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::string guess(const std::string& word, const std::vector<std::string>& names) {
  const std::vector<std::string_view> views(names.begin(), names.end());
  return did_you_mean(word, views);
}

// A word where a subcommand, or an option that there is, is expected; empty without one.
std::string unknown_word(const CLI::App& command) {
  const std::vector<std::string> rest = command.remaining();
  if (rest.empty()) return "";
  const std::string& word = rest.front();
  if (word.starts_with("--")) {
    const std::string name = word.substr(0, word.find('='));
    return fmt::format("{}: no such option{}", printable(word), guess(name, option_names(command)));
  }
  const std::vector<std::string> names = subcommands(command);
  if (names.empty() || word.starts_with("-")) return "";
  return fmt::format("{}: no such command{}", printable(word), guess(word, names));
}

// What is wrong with the command line, with the choices where a subcommand is missing.
std::string usage_message(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = *innermost(app);
  std::string message = unknown_word(command);
  if (message.empty()) {
    message = error.what();  // of several lines
    std::replace(message.begin(), message.end(), '\n', ' ');
    const std::vector<std::string> choices = subcommands(command);
    for (std::size_t i = 0; error.get_name() == "RequiredError" && i < choices.size(); ++i)
      message += (i == 0 ? ": " : i + 1 < choices.size() ? ", " : " or ") + choices[i];
  }
  return fmt::format("{}; '{} --help' shows how it is used", message, command_path(app));
}

int run_program(int argc, char** argv) {
  CLI::App app;
  Action action;
  set_up_program(app, action);
  // Of the shells' completion and of whoever builds the program; not in the help.
  const std::string_view hidden = argc > 1 ? argv[1] : "";
  if (hidden == "--complete") {
    write_stdout(completions(app, {argv + 2, argv + argc}));
    return 0;
  }
  if (hidden == "--manual" && argc == 3) {
    write_manual(app, app.get_name(), argv[2]);
    return 0;
  }

  // "pabd help plot barrier" is "pabd plot barrier --help".
  std::vector<std::string> words(argv + 1, argv + argc);
  const bool asks = !words.empty() && words.front() == kHelpWord;
  if (asks) std::rotate(words.begin(), words.begin() + 1, words.end());
  if (asks) words.back() = "--help";
  std::reverse(words.begin(), words.end());  // as CLI11 takes them

  try {
    app.parse(std::move(words));
  } catch (const CLI::CallForHelp& help) {
    if (asks && !unknown_word(*innermost(app)).empty())
      return report_error(ErrorKind::bad_input, usage_message(app, help));
    write_stdout(help_text(*innermost(app), command_path(app), help_columns()));
    return 0;
  } catch (const CLI::CallForVersion&) {
    write_stdout("pabd " PABD_VERSION "\n");
    return 0;
  } catch (const CLI::ParseError& error) {
    return report_error(ErrorKind::bad_input, usage_message(app, error));
  }
  return action();
}

}  // namespace
}  // namespace pabd::cli

int main(int argc, char** argv) {
  constexpr const char* kTryContexts = "--try-contexts";  // of this program itself only
  if (argc > 1 && std::string_view(argv[1]) == kTryContexts)
    pabd::try_headless_contexts({argv + 2, argv + argc});
  pabd::set_context_trial({"/proc/self/exe", kTryContexts});
  // A reader that went away shows up as a failed write, which is reported like every other.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);  // the same for a file that may not grow (ulimit -f)
  pabd::cli::install_signal_handlers();
  try {
    return pabd::cli::run_program(argc, argv);
  } catch (...) {
    return pabd::cli::report_error(std::current_exception());
  }
}
