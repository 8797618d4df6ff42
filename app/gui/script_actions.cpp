// SPDX-License-Identifier: MIT
// Reading and listing the actions of scripts: see script_actions.h.
#include "app/gui/script_actions.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/workbench/command_json.h"
#include "render/context/keyboard.h"
#include "sim/scene/document.h"
#include "sim/scene/text.h"

namespace pabd {
namespace {

using ActionJson = nlohmann::ordered_json;

constexpr int kMostFrames = 10000;
constexpr double kLongestWait = 3600;  // s

void check_point(const std::vector<double>& numbers, const char* field, const std::string& what) {
  if (numbers.size() != 2) refuse_action(what, fmt::format("\"{}\": expected [x, y] in pixels", field));
}

// What is wrong with an action however the program stands.
struct Checker {
  const std::string& what;

  template <class A>
  void operator()(const A&) const {}  // nothing
  void operator()(const action::Key& a) const { parse_key_chord(a.key); }
  void operator()(const action::Mouse& a) const {
    check_point(a.at, "at", what);
    if (!a.to.empty() || a.how == "drag") check_point(a.to, "to", what);
    parse_mouse_button(a.button);
    if (!a.with.empty()) parse_key_chord(a.with + "+a");
  }
  void operator()(const action::Window& a) const {
    if (!a.size.empty()) {
      check_point(a.size, "size", what);
      if (!(a.size[0] >= 64 && a.size[0] <= 8192 && a.size[1] >= 64 && a.size[1] <= 8192))
        refuse_action(what, "\"size\": expected 64 to 8192 pixels");
    }
    if (a.scale != 0 && !(a.scale >= 0.5 && a.scale <= 4))
      refuse_action(what, "\"scale\": expected 0.5 to 4");
  }
  void operator()(const action::Expect& a) const { condition(a); }
  void operator()(const action::Until& a) const {
    condition(a);
    if (!(a.seconds >= 0 && a.seconds <= kLongestWait))
      refuse_action(what, fmt::format("\"seconds\": expected 0 to {}", kLongestWait));
  }
  void operator()(const action::Wait& a) const {
    if (a.frames < 0 || a.frames > kMostFrames)
      refuse_action(what, fmt::format("\"frames\": expected 0 to {}", kMostFrames));
  }
  void condition(const action::Condition& a) const {
    if (!a.says_something()) refuse_action(what, "expected one of is, is_not, near, above, below, contains");
    if (a.within && !a.near) refuse_action(what, "\"within\" belongs to \"near\"; expected both");
  }
};

std::vector<std::string_view> all_names() {
  std::vector<std::string_view> names = command_names<ScriptAction>();
  for (const std::string_view name : command_names<Command>()) names.push_back(name);
  for (const std::string_view name : command_names<ViewCommand>()) names.push_back(name);
  return names;
}

}  // namespace

AnyAction parse_action(ActionJson a, const std::string& what) {
  a.erase(kMayFail);
  const std::string name = a["do"];
  Command command;
  if (command_from_json(name, a, what, command)) return command;
  ViewCommand view;
  if (command_from_json(name, a, what, view)) return view;
  ScriptAction own;
  if (!command_from_json(name, a, what, own))
    refuse_action(what, fmt::format("there is no {}{}", in_quotes(name), did_you_mean(name, all_names())));
  try {
    std::visit([](const auto& action) { check_words(action); }, own);
    std::visit(Checker{what}, own);
  } catch (const Error& error) {
    if (error.source() == what) throw;
    refuse_action(what, error.what());
  }
  return own;
}

std::vector<ActionJson> read_script(const std::string& json, const std::string& source) {
  (void)parse_document(json, source);  // refuses what is not JSON, too deep or too large, with its place
  ActionJson document = ActionJson::parse(json);  // keeps the order
  if (document.is_object() && document.contains("actions")) document = ActionJson(document["actions"]);
  if (!document.is_array())
    refuse_action(source, "expected a list of actions, or an object with \"actions\"");
  for (std::size_t i = 0; i < document.size(); ++i) {
    const ActionJson& a = document[i];
    const std::string what = fmt::format("{}: action {}", source, i);
    if (!a.is_object() || !a.contains("do") || !a["do"].is_string())
      refuse_action(what, "expected an object with \"do\"");
    if (a.contains(kMayFail) && !a[kMayFail].is_boolean())
      refuse_action(what, "\"may_fail\": expected true or false");
    (void)parse_action(a, what);
  }
  return {document.begin(), document.end()};
}

std::string action_list() {
  return "Of the simulation:\n" + command_list<Command>() + "Of the view:\n" + command_list<ViewCommand>() +
         "Of the script:\n" + command_list<ScriptAction>() +
         "Each may have\n"
         "      may_fail      true or false    the script goes on when it is refused or fails; e.g. true\n";
}

}  // namespace pabd
