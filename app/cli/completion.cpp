// SPDX-License-Identifier: MIT
// Tab completion. The shells' scripts (completion/) ask 'pabd --complete WORD…' for what may stand in place of the last
// word: a line each, and a tabulator before its description. Names of files are left to the shell: a line "\tfiles" or
// "\tfolders" asks for them.
#include "app/cli/completion.h"

#include <algorithm>

#include "app/cli/help_text.h"
#include "app/cli/scene_lookup.h"
#include "app/overlay/panel_choice.h"
#include "render/output/video_options.h"
#include "sim/solver/parameter_table.h"

namespace pabd::cli {
namespace {

using Words = std::vector<std::string>;

constexpr const char *kFiles = "\tfiles", *kFolders = "\tfolders";

Words overlay_words() {
  Words out = {"contacts", "bonds", "plots", "all", "none"};
  for (const OverlayPanel* panel : overlay_panels())
    if (!panel->name.empty() && panel->name != "contacts") out.emplace_back(panel->name);
  return out;
}

// The words that CLI::IsMember puts into the name of the type: "NAME:{auto,egl,osmesa}".
Words members(const CLI::Option& option) {
  const std::string type = option.get_type_size() == 0 ? "" : option.get_type_name();
  const auto open = type.find('{'), close = type.find('}');
  if (open == type.npos || close == type.npos) return {};
  return CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
}

// What may stand behind an option or as an argument.
Words values_of(const CLI::Option& option) {
  if (Words words = members(option); !words.empty()) return words;
  const std::string name = option.get_single_name();
  const std::string type = value_name(option);
  Words out;
  if (name == "SCENE") {
    for (const auto& file : shipped_scenes()) out.push_back(file.stem().string());
    out.emplace_back(kFiles);
    return out;
  }
  if (name == "set") {
    for (const ParameterRow& row : parameter_table()) out.push_back(std::string(row.key) + "=");
    return out;
  }
  if (name == "overlay") return overlay_words();
  if (name == "camera") return {"front", "side", "top", "iso", "orbit:"};
  if (name == "ab-view") return {"side", "ghost"};
  if (name == "preset") return preset_names();
  if (type == "FOLDER" || name == "FOLDER") return {kFolders};
  const bool file = type == "OUT" || type == "CSV" || type == "JSON" || type.find('.') != type.npos;
  if (file || name == "PLAN" || name == "ROBOT" || name == "ACTUAL" || name == "EXPECTED") return {kFiles};
  return {};
}

std::string first_sentence(const std::string& words) {
  const std::string line = words.substr(0, words.find("; "));
  return line.substr(0, line.find(". "));
}

// An option of the command that has this name, "-o" or "--out".
const CLI::Option* option_named(const CLI::App& command, const std::string& name) {
  return name.starts_with('-') ? command.get_option_no_throw(name) : nullptr;
}

// Lists grow behind their last comma.
bool is_list(const CLI::Option& option) { return value_name(option) == "LIST"; }

}  // namespace

std::string completions(const CLI::App& program, const std::vector<std::string>& words) {
  if (words.empty()) return "";
  if (words.size() > 1 && words.front() == kHelpWord)
    return completions(program, {words.begin() + 1, words.end()});
  const CLI::App* command = &program;
  const CLI::Option* waiting = nullptr;  // the option whose value comes next
  std::size_t arguments = 0;             // that stand there already
  for (std::size_t k = 0; k + 1 < words.size(); ++k) {
    if (waiting != nullptr) {
      waiting = nullptr;
      continue;
    }
    const auto below = subcommands_of(*command);
    const auto chosen = std::find_if(below.begin(), below.end(),
                                     [&](const CLI::App* each) { return each->get_name() == words[k]; });
    if (chosen != below.end() && arguments == 0) {
      command = *chosen;
    } else if (const CLI::Option* option = option_named(*command, words[k])) {
      if (!value_name(*option).empty()) waiting = option;
    } else if (!words[k].starts_with('-')) {
      ++arguments;
    }
  }

  std::string typed = words.back(), before, out;
  const auto offer = [&](const std::string& word, const std::string& about = "") {
    if (word.starts_with('\t')) {
      out += word + "\n";
    } else if (word.starts_with(typed)) {
      out += before + word + (about.empty() ? "" : "\t" + about) + "\n";
    }
  };
  if (waiting != nullptr) {
    if (is_list(*waiting) && typed.find(',') != typed.npos) {
      before = typed.substr(0, typed.rfind(',') + 1);
      typed.erase(0, before.size());
    }
    for (const std::string& word : values_of(*waiting)) offer(word);
    return out;
  }
  if (typed.starts_with('-')) {
    for (const OptionGroup& group : option_groups(*command)) {
      for (const CLI::Option* option : group.options) {
        for (const std::string& name : option->get_snames())
          offer("-" + name, first_sentence(option->get_description()));
        for (const std::string& name : option->get_lnames())
          offer("--" + name, first_sentence(option->get_description()));
      }
    }
    return out;
  }
  if (arguments == 0)
    for (const CLI::App* each : subcommands_of(*command)) offer(each->get_name(), each->get_description());
  const auto expected = arguments_of(*command);
  const bool more = !expected.empty() && expected.back()->get_expected_max() > 1;
  if (arguments < expected.size() || more) {
    for (const std::string& word : values_of(*expected[std::min(arguments, expected.size() - 1)]))
      offer(word);
  }
  return out;
}

}  // namespace pabd::cli
