// SPDX-License-Identifier: MIT
// Actions of a script beside commands: input, frames, expectations. The same form as app/workbench/command.h.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/gui/view_command.h"
#include "app/workbench/command.h"
#include "sim/base/error.h"

namespace pabd::action {

using command::Field;
using command::may;
using command::need;

inline constexpr command::Choice kKeyMotions[] = {{"press"}, {"hold"}, {"release"}};
inline constexpr command::Choice kMouseMotions[] = {{"move"},  {"press"},        {"release"},
                                                    {"click"}, {"double_click"}, {"drag"}};
inline constexpr command::Choice kDragEnds[] = {{"release"}, {"hold"}};
inline constexpr command::Choice kFrameParts[] = {{"window"},  {"left"},    {"right_top"}, {"right_bottom"},
                                                  {"picture"}, {"toolbar"}, {"timeline"}};

struct Key {
  static constexpr const char* name = "key";
  std::string key, how = "press";
  void fields(auto&& f) {
    f(need("key", "with ctrl+, shift+, alt+ before it", R"("ctrl+z")"), key);
    f(may("how", kKeyMotions, R"("hold")", "a press is released at once"), how);
  }
};
struct Mouse {
  static constexpr const char* name = "mouse";
  std::vector<double> at, to;
  std::string how = "move", button = "left", with, end = "release";
  double wheel = 0;
  void fields(auto&& f) {
    f(need("at", "[x, y] in pixels from the top left of the window", "[640, 360]"), at);
    f(may("how", kMouseMotions, R"("click")", "with \"to\" it drags"), how);
    f(may("to", "[x, y] in pixels: where it is dragged to", "[700, 360]"), to);
    f(may("end", kDragEnds, R"("hold")", "of a drag"), end);
    f(may("button", "left, middle or right", R"("right")"), button);
    f(may("with", "keys that are held meanwhile", R"("ctrl")"), with);
    f(may("wheel", "notches; up is positive", "2"), wheel);
  }
};
struct Type {
  static constexpr const char* name = "type";
  std::string text;
  void fields(auto&& f) { f(need("text", "what is typed", R"("12.5")"), text); }
};
struct Window {
  static constexpr const char* name = "window";
  std::vector<double> size;
  double scale = 0;
  void fields(auto&& f) {
    f(may("size", "[width, height] in pixels, 64 to 8192", "[1280, 720]"), size);
    f(may("scale", "what the screen asks for, 0.5 to 4", "2"), scale);
  }
};
struct Frame {
  static constexpr const char* name = "frame";
  std::string path, of = "window";
  void fields(auto&& f) {
    f(need("path", ".png file", R"("panel.png")"), path);
    f(may("of", kFrameParts, R"("picture")"), of);
  }
};

// What a value of the state is expected to be; all that is given must hold.
struct Condition {
  std::string at;
  std::optional<nlohmann::ordered_json> is, is_not;
  std::optional<double> near, within, above, below;
  std::optional<std::string> contains;
  void condition_fields(auto&& f) {
    f(need("at", "JSON pointer into the state", R"("/a/report/max_penetration")"), at);
    f(may("is", "equal to", "0"), is);
    f(may("is_not", "not equal to", "1"), is_not);
    f(may("near", "about, in the unit of the value", "0.04"), near);
    f(may("within", "of near: largest distance from it, in the unit of the value; else 1e-9", "0.001"),
      within);
    f(may("above", "greater than, in the unit of the value", "0"), above);
    f(may("below", "less than, in the unit of the value", "0.001"), below);
    f(may("contains", "a part of the text", R"("saved")"), contains);
  }
  bool says_something() const { return is || is_not || near || above || below || contains; }
};
struct Expect : Condition {
  static constexpr const char* name = "expect";
  void fields(auto&& f) { condition_fields(f); }
};
struct Until : Condition {
  static constexpr const char* name = "until";
  double seconds = 60;
  void fields(auto&& f) {
    condition_fields(f);
    f(may("seconds", "wall clock, s: how long to wait at most; else 60", "300"), seconds);
  }
};
struct Print {
  static constexpr const char* name = "print";
  std::string at;
  void fields(auto&& f) {
    f(need("at", "JSON pointer into the state", R"("/a/report/max_penetration")"), at);
  }
};
struct Wait {
  static constexpr const char* name = "wait";
  int frames = 1;
  void fields(auto&& f) { f(may("frames", "frames that are drawn, at most 10000", "3"), frames); }
};

}  // namespace pabd::action

namespace pabd {

// Throws Error(bad_input) "WHAT: WHY".
[[noreturn]] inline void refuse_action(const std::string& what, const std::string& why) {
  throw Error(ErrorKind::bad_input, what, why);
}

// Every action may have it: the script goes on although the action is refused or fails.
inline constexpr const char* kMayFail = "may_fail";

using ScriptAction = std::variant<action::Key, action::Mouse, action::Type, action::Window, action::Frame,
                                  action::Expect, action::Until, action::Print, action::Wait>;
using AnyAction = std::variant<Command, ViewCommand, ScriptAction>;

// Precondition: `a` is an object whose "do" is a text. Throws Error(bad_input) that begins with `what` when
// it is no action, or one that is wrong however the program stands.
AnyAction parse_action(nlohmann::ordered_json a, const std::string& what);

// The actions of a script: a JSON list, or an object with "actions". Throws Error(bad_input) with number and place.
std::vector<nlohmann::ordered_json> read_script(const std::string& json, const std::string& source);

// Every action with its fields, their types, meanings, units and examples, for people.
std::string action_list();

}  // namespace pabd
