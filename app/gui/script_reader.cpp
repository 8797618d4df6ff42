// See script_reader.h.
#include "app/gui/script_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/gui/view_command.h"
#include "app/workbench/command_json.h"
#include "sim/error.h"
#include "sim/scene/document.h"

namespace pabd {
namespace {

using ActionJson = nlohmann::ordered_json;

constexpr std::string_view kOwn[] = {"key", "mouse", "type", "window", "frame", "expect", "wait", "until"};

[[noreturn]] void refuse(const std::string& what, const std::string& why) {
  throw Error(ExitCode::bad_input, what + ": " + why);
}

}  // namespace

std::vector<ActionJson> read_script(const std::string& json, const std::string& source) {
  (void)parse_document(json, source);  // refuses what is not JSON, too deep or too large, with its place
  ActionJson document = ActionJson::parse(json);  // keeps the order
  if (document.is_object() && document.contains("actions")) document = ActionJson(document["actions"]);
  if (!document.is_array()) refuse(source, "expected a list of actions, or an object with \"actions\"");
  std::vector<std::string_view> names(std::begin(kOwn), std::end(kOwn));
  for (const std::string_view name : command_names<Command>()) names.push_back(name);
  for (const std::string_view name : command_names<ViewCommand>()) names.push_back(name);
  for (std::size_t i = 0; i < document.size(); ++i) {
    const ActionJson& a = document[i];
    const std::string what = fmt::format("{}: action {}", source, i);
    if (!a.is_object() || !a.contains("do") || !a["do"].is_string())
      refuse(what, "expected an object with \"do\"");
    const std::string name = a["do"];
    if (std::find(names.begin(), names.end(), name) == names.end())
      refuse(what, fmt::format("there is no {}{}", in_quotes(name), did_you_mean(name, names)));
    Command command;
    ViewCommand view;
    if (!command_from_json(name, a, what, command)) command_from_json(name, a, what, view);
  }
  return {document.begin(), document.end()};
}

}  // namespace pabd
