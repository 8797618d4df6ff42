// SPDX-License-Identifier: MIT
// See completion.h. Each shell gets a table of the commands and their options. Names of scenes are asked of the
// program when they are needed: 'pabd scenes --names'.
#include "app/cli/completion.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "app/cli/help_text.h"
#include "app/overlay/panel_choice.h"
#include "render/output/video_options.h"
#include "sim/base/error.h"
#include "sim/base/shell_quoted.h"
#include "sim/solver/parameter_table.h"

namespace pabd::cli {
namespace {

using Words = std::vector<std::string>;

std::string joined(const Words& words, const char* between) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : between) + word;
  return out;
}

Words split(const std::string& text, char at) {
  Words out;
  std::istringstream in(text);
  for (std::string word; std::getline(in, word, at);) out.push_back(word);
  return out;
}

Words overlay_words() {
  Words out = {"contacts", "bonds", "plots", "all", "none"};
  for (const OverlayPanel* panel : overlay_panels())
    if (!panel->name.empty()) out.emplace_back(panel->name);
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

// "contact.kappa=", …: everything that --set takes while it runs.
Words setting_words() {
  Words out;
  for (const ParameterRow& row : parameter_table()) out.push_back(std::string(row.key) + "=");
  return out;
}

// The words that CLI::IsMember puts into the name of the type: "NAME:{auto,egl,osmesa}".
Words members(const CLI::Option& option) {
  const std::string type = option.get_type_size() == 0 ? "" : option.get_type_name();
  const auto open = type.find('{'), close = type.find('}');
  if (open == type.npos || close == type.npos) return {};
  return split(type.substr(open + 1, close - open - 1), ',');
}

struct Command {
  Words path;  // "pabd", "plot", "barrier"
  const CLI::App* app;
};

void add_commands(const CLI::App& app, Words path, std::vector<Command>& out) {
  path.push_back(app.get_name());
  out.push_back({path, &app});
  for (const CLI::App* each : subcommands_of(app)) add_commands(*each, path, out);
}

std::vector<Command> commands_of(const CLI::App& program) {
  std::vector<Command> out;
  add_commands(program, {}, out);
  return out;
}

Words names_of(const CLI::Option& option) {
  Words out;
  for (const std::string& name : option.get_snames()) out.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) out.push_back("--" + name);
  return out;
}

std::vector<const CLI::Option*> options_of(const CLI::App& command) {
  std::vector<const CLI::Option*> out;
  for (const OptionGroup& group : option_groups(command))
    out.insert(out.end(), group.options.begin(), group.options.end());
  return out;
}

Completion argument_of(const CLI::App& command) {
  const auto arguments = arguments_of(command);
  return arguments.empty() ? Completion{} : completion_of(*arguments.front());
}

std::string first_sentence(const std::string& words) {
  const std::string line = words.substr(0, words.find("; "));
  return line.substr(0, line.find(". "));
}

// -- bash ---------------------------------------------------------------------------------------------------

std::string bash_action(const Completion& c) {
  using Kind = Completion::Kind;
  switch (c.kind) {
    case Kind::none:
      return "COMPREPLY=()";
    case Kind::words:
      return "__pabd_words " + sh_quoted(joined(c.words, " "));
    case Kind::list:
      return "__pabd_list " + sh_quoted(joined(c.words, " "));
    case Kind::scene:
      return "__pabd_scenes";
    case Kind::setting:
      return "compopt -o nospace 2>/dev/null; __pabd_words " + sh_quoted(joined(c.words, " "));
    case Kind::file:
      return "__pabd_files";
    case Kind::folder:
      return "__pabd_folders";
  }
  return "";
}

std::string bash_script(const CLI::App& program) {
  std::string out =
      "# Tab completion of pabd for bash: source it, or put it into a folder of bash-completion.\n"
      "__pabd_words() { mapfile -t COMPREPLY < <(compgen -W \"$1\" -- \"$cur\"); }\n"
      "__pabd_list() {\n"
      "  local before=\"\"\n"
      "  [[ $cur == *,* ]] && before=\"${cur%,*},\"\n"
      "  compopt -o nospace 2>/dev/null\n"
      "  mapfile -t COMPREPLY < <(compgen -P \"$before\" -W \"$1\" -- \"${cur##*,}\")\n"
      "}\n"
      "__pabd_files() { compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -f -- \"$cur\"); "
      "}\n"
      "__pabd_folders() { compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -d -- "
      "\"$cur\"); }\n"
      "__pabd_scenes() {\n"
      "  compopt -o filenames 2>/dev/null\n"
      "  mapfile -t COMPREPLY < <(compgen -W \"$(\"${COMP_WORDS[0]}\" scenes --names 2>/dev/null)\" -- "
      "\"$cur\"; "
      "for i in json urdf xml; do compgen -f -X \"!*.$i\" -- \"$cur\"; done; compgen -d -- \"$cur\")\n"
      "}\n"
      "_pabd() {\n"
      "  local cur=\"${COMP_WORDS[COMP_CWORD]}\" previous=\"${COMP_WORDS[COMP_CWORD-1]}\" path=pabd i\n"
      "  COMPREPLY=()\n"
      "  for ((i = 1; i < COMP_CWORD; i++)); do\n"
      "    case \"$path ${COMP_WORDS[i]}\" in\n";
  const auto commands = commands_of(program);
  for (const Command& command : commands) {
    if (command.path.size() > 1)
      out += fmt::format("      {0}) path={0} ;;\n", sh_quoted(joined(command.path, " ")));
  }
  out += "    esac\n  done\n  case \"$path $previous\" in\n";
  for (const Command& command : commands) {
    for (const CLI::Option* option : options_of(*command.app)) {
      if (value_name(*option).empty()) continue;  // a flag
      Words patterns;
      for (const std::string& name : names_of(*option))
        patterns.push_back(sh_quoted(joined(command.path, " ") + " " + name));
      out +=
          fmt::format("    {}) {}; return ;;\n", joined(patterns, "|"), bash_action(completion_of(*option)));
    }
  }
  out += "  esac\n  case \"$path\" in\n";
  for (const Command& command : commands) {
    Words options;
    for (const CLI::Option* option : options_of(*command.app)) {
      for (const std::string& name : names_of(*option)) options.push_back(name);
    }
    Words names;
    for (const CLI::App* each : subcommands_of(*command.app)) names.push_back(each->get_name());
    const Completion argument = argument_of(*command.app);
    std::string other =
        names.empty() ? bash_action(argument) : "__pabd_words " + sh_quoted(joined(names, " "));
    if (!names.empty() && argument.kind != Completion::Kind::none)
      other +=
          "; local names=(\"${COMPREPLY[@]}\"); " + bash_action(argument) + "; COMPREPLY+=(\"${names[@]}\")";
    out += fmt::format("    {})\n      if [[ $cur == -* ]]; then __pabd_words {}; else {}; fi ;;\n",
                       sh_quoted(joined(command.path, " ")), sh_quoted(joined(options, " ")), other);
  }
  return out + "  esac\n}\ncomplete -F _pabd pabd\n";
}

// -- zsh ----------------------------------------------------------------------------------------------------

// Within a specification of _arguments colons and brackets mean something.
std::string zsh_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == ':' || c == '[' || c == ']' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

std::string zsh_action(const Completion& c) {
  using Kind = Completion::Kind;
  switch (c.kind) {
    case Kind::none:
      return " ";
    case Kind::words:
      return "(" + joined(c.words, " ") + ")";
    case Kind::list:
      return "_values -s , word " + joined(c.words, " ");
    case Kind::scene:
      return "__pabd_scenes";
    case Kind::setting:
      return "compadd -S \"\" -- " + joined(c.words, " ");
    case Kind::file:
      return "_files";
    case Kind::folder:
      return "_files -/";
  }
  return "";
}

std::string function_name(const Words& path) {
  std::string name = "_" + joined(path, "_");
  return name;
}

// What _arguments is told of a command's options.
std::string zsh_options(const CLI::App& command) {
  std::string out;
  for (const CLI::Option* option : options_of(command)) {
    const bool flag = value_name(*option).empty();
    const Words names = names_of(*option);
    const bool again = option->get_expected_max() > 1 || option->get_items_expected_max() > 1;
    for (const std::string& name : names) {
      std::string spec = (again              ? "*"
                          : names.size() > 1 ? "(" + joined(names, " ") + ")"
                                             : "") +
                         name + "[" + zsh_text(first_sentence(option->get_description())) + "]";
      if (!flag) spec += ":" + zsh_text(value_name(*option)) + ":" + zsh_action(completion_of(*option));
      out += " \\\n    " + sh_quoted(spec);
    }
  }
  return out;
}

std::string zsh_function(const Command& command) {
  const auto below = subcommands_of(*command.app);
  const auto arguments = arguments_of(*command.app);
  const std::string options = zsh_options(*command.app);
  std::string out = function_name(command.path) + "() {\n";
  if (below.empty()) {
    out += "  _arguments -s" + options;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      const CLI::Option& argument = *arguments[i];
      const std::string place = argument.get_expected_max() > 1 ? "*" : std::to_string(i + 1);
      out += " \\\n    " + sh_quoted(place + ":" + zsh_text(argument.get_single_name()) + ":" +
                                     zsh_action(completion_of(argument)));
    }
    return out + "\n}\n";
  }
  out += "  local line state\n  _arguments -s -C" + options +
         " \\\n    '1:command:->command' '*::arguments:->arguments'\n  case $state in\n    command)\n"
         "      local -a commands=(\n";
  for (const CLI::App* each : below)
    out += "        " + sh_quoted(each->get_name() + ":" + zsh_text(each->get_description())) + "\n";
  // In place of a command there may be an argument, and options behind it.
  const std::string describe = "_describe command commands";
  out += "      )\n      " +
         (arguments.empty() ? describe
                            : "_alternative 'commands:command:{" + describe + "}' " +
                                  sh_quoted("arguments:" + zsh_text(arguments.front()->get_single_name()) +
                                            ":" + zsh_action(completion_of(*arguments.front())))) +
         " ;;\n    arguments)\n      case $line[1] in\n";
  for (const CLI::App* each : below) {
    Words path = command.path;
    path.push_back(each->get_name());
    out += fmt::format("        {}) {} ;;\n", each->get_name(), function_name(path));
  }
  if (!arguments.empty()) out += "        *) _arguments -s" + options + " ;;\n";
  return out + "      esac ;;\n  esac\n}\n";
}

std::string zsh_script(const CLI::App& program) {
  std::string out =
      "#compdef pabd\n# Tab completion of pabd for zsh: into a folder of $fpath, as _pabd.\n"
      "__pabd_scenes() {\n"
      "  local -a names=(${(f)\"$(_call_program scenes pabd scenes --names 2>/dev/null)\"})\n"
      "  compadd -a names\n  _files -g '*.(json|urdf|xml)'\n}\n";
  for (const Command& command : commands_of(program)) out += zsh_function(command);
  return out + "if [[ $funcstack[1] == _pabd ]]; then _pabd \"$@\"; else compdef _pabd pabd; fi\n";
}

// -- fish ---------------------------------------------------------------------------------------------------

std::string fish_quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') out += '\\';
    out += c;
  }
  return out + "'";
}

std::string fish_action(const Completion& c) {
  using Kind = Completion::Kind;
  switch (c.kind) {
    case Kind::none:
      return " -x";
    case Kind::words:
    case Kind::setting:
      return " -x -a " + fish_quoted(joined(c.words, " "));
    case Kind::list:
      return " -x -a " + fish_quoted("(__fish_append , " + joined(c.words, " ") + ")");
    case Kind::scene:
      return " -k -a '(pabd scenes --names; __fish_complete_suffix .json)' -f";
    case Kind::file:
      return " -r -F";
    case Kind::folder:
      return " -x -a '(__fish_complete_directories)'";
  }
  return "";
}

// True while the command line is in this command: all words of its path were seen, none of a command below it.
std::string fish_condition(const Command& command) {
  std::string out;
  for (std::size_t i = 1; i < command.path.size(); ++i)
    out += (out.empty() ? "" : "; and ") + std::string("__fish_seen_subcommand_from ") + command.path[i];
  Words below;
  for (const CLI::App* each : subcommands_of(*command.app)) below.push_back(each->get_name());
  if (!below.empty())
    out +=
        (out.empty() ? "" : "; and ") + std::string("not __fish_seen_subcommand_from ") + joined(below, " ");
  return out;
}

std::string fish_script(const CLI::App& program) {
  std::string out =
      "# Tab completion of pabd for fish: into ~/.config/fish/completions, as pabd.fish.\ncomplete -c pabd "
      "-f\n";
  for (const Command& command : commands_of(program)) {
    const std::string start = "complete -c pabd -n " + fish_quoted(fish_condition(command));
    for (const CLI::App* each : subcommands_of(*command.app))
      out += fmt::format("{} -a {} -d {}\n", start, each->get_name(), fish_quoted(each->get_description()));
    for (const CLI::Option* option : options_of(*command.app)) {
      std::string names;
      for (const std::string& name : option->get_snames()) names += " -s " + name;
      for (const std::string& name : option->get_lnames()) names += " -l " + name;
      const bool flag = value_name(*option).empty();
      out += fmt::format("{}{}{} -d {}\n", start, names, flag ? "" : fish_action(completion_of(*option)),
                         fish_quoted(first_sentence(option->get_description())));
    }
    const Completion argument = argument_of(*command.app);
    if (argument.kind != Completion::Kind::none) out += start + fish_action(argument) + "\n";
  }
  return out;
}

}  // namespace

Completion completion_of(const CLI::Option& option) {
  using Kind = Completion::Kind;
  if (const Words words = members(option); !words.empty()) return {Kind::words, words};
  const std::string name = option.get_single_name();
  const std::string type = value_name(option);
  if (name == "SCENE") return {Kind::scene, {}};
  if (name == "set") return {Kind::setting, setting_words()};
  if (name == "overlay") return {Kind::list, overlay_words()};
  if (name == "camera") return {Kind::words, {"front", "side", "top", "iso", "orbit:"}};
  if (name == "ab-view") return {Kind::words, {"side", "ghost"}};
  if (name == "preset") return {Kind::words, preset_names()};
  if (name == "method") return {Kind::list, {"sissm", "descent", "newton"}};
  if (name == "kind") {
    Words words;
    for (const BarrierKind kind : kBarrierKinds) words.emplace_back(to_string(kind));
    return {Kind::list, words};
  }
  if (type == "FOLDER" || name == "FOLDER") return {Kind::folder, {}};
  const bool file = type == "OUT" || type == "CSV" || type == "JSON" || type.find('.') != type.npos;
  if (file || name == "PLAN" || name == "ROBOT" || name == "ACTUAL" || name == "EXPECTED")
    return {Kind::file, {}};
  return {};
}

std::string completion_script(const CLI::App& program, const std::string& shell) {
  if (shell == "bash") return bash_script(program);
  if (shell == "zsh") return zsh_script(program);
  if (shell == "fish") return fish_script(program);
  throw Error(ErrorKind::bad_input, fmt::format("completion {}: expected bash, zsh or fish", shell));
}

}  // namespace pabd::cli
