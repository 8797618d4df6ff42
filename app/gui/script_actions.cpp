// SPDX-License-Identifier: MIT
// Reading and listing the actions of scripts: see script_actions.h.
#include "app/gui/script_actions.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/workbench/command_json.h"
#include "render/context/keyboard.h"
#include "sim/scene/text.h"

namespace pabd {
namespace {

using ActionJson = nlohmann::ordered_json;

constexpr int kMostFrames = 10000;
constexpr double kLongestWait = 3600;  // s

void check_point(const std::vector<double>& numbers, const char* field, const std::string& what) {
  if (numbers.size() != 2) refuse_action(what, fmt::format("\"{}\": expected [x, y] in pixels", field));
}

void check_word(const std::string& word, std::initializer_list<std::string_view> words, const char* field,
                const std::string& what) {
  const std::vector<std::string_view> list(words);
  if (std::find(list.begin(), list.end(), word) == list.end())
    refuse_action(what, fmt::format("\"{}\": {} is not one of {}", field, in_quotes(word), one_of(list)));
}

// What is wrong with an action however the program stands.
struct Checker {
  const std::string& what;

  void operator()(const action::Key& a) const {
    parse_key_chord(a.key);
    check_word(a.how, {"press", "hold", "release"}, "how", what);
  }
  void operator()(const action::Mouse& a) const {
    check_point(a.at, "at", what);
    if (!a.to.empty() || a.how == "drag") check_point(a.to, "to", what);
    if (!a.how.empty())
      check_word(a.how, {"move", "press", "release", "click", "double_click", "drag"}, "how", what);
    check_word(a.end, {"release", "hold"}, "end", what);
    parse_mouse_button(a.button);
    if (!a.with.empty()) parse_key_chord(a.with + "+a");
  }
  void operator()(const action::Type&) const {}
  void operator()(const action::Window& a) const {
    if (!a.size.empty()) {
      check_point(a.size, "size", what);
      if (!(a.size[0] >= 64 && a.size[0] <= 8192 && a.size[1] >= 64 && a.size[1] <= 8192))
        refuse_action(what, "\"size\": expected 64 to 8192 pixels");
    }
    if (a.scale != 0 && !(a.scale >= 0.5 && a.scale <= 4))
      refuse_action(what, "\"scale\": expected 0.5 to 4");
  }
  void operator()(const action::Frame& a) const {
    check_word(a.of, {"window", "left", "right_top", "right_bottom", "picture", "toolbar", "timeline"}, "of",
               what);
  }
  void operator()(const action::Expect& a) const { condition(a); }
  void operator()(const action::Until& a) const {
    condition(a);
    if (!(a.seconds >= 0 && a.seconds <= kLongestWait))
      refuse_action(what, fmt::format("\"seconds\": expected 0 to {}", kLongestWait));
  }
  void operator()(const action::Print&) const {}
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
    std::visit(Checker{what}, own);
  } catch (const Error& error) {
    if (error.source() == what) throw;
    refuse_action(what, error.what());
  }
  return own;
}

std::string action_list() {
  return "Of the simulation:\n" + command_list<Command>() + "Of the view:\n" + command_list<ViewCommand>() +
         "Of the script:\n" + command_list<ScriptAction>() +
         "Each may have\n"
         "      may_fail      true or false    the script goes on when it is refused or fails; e.g. true\n";
}

}  // namespace pabd
