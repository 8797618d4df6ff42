// SPDX-License-Identifier: MIT
// See messages.h: what pages say, read with limits on everything.
#include "app/serve/messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/base/error.h"
#include "sim/base/utf8.h"
#include "sim/scene/document.h"

namespace pabd {
namespace {

constexpr DocumentLimits kLimits{kMostMessageBytes, 20'000, 24};
constexpr double kFarthest = 1e5;  // pixels from the window's corner
constexpr double kMostNotches = 100;

[[noreturn]] void refuse(const std::string& place, const std::string& expected) {
  throw Error(ErrorKind::bad_input, "message", fmt::format("\"{}\": expected {}", place, expected));
}

struct Reader {
  const Json& json;

  const Json& member(const char* name, const char* expected) const {
    const auto found = json.find(name);
    if (found == json.end()) refuse(name, expected);
    return *found;
  }
  double number(const char* name, double lo, double hi) const {
    const std::string expected = fmt::format("a number from {} to {}", lo, hi);
    const Json& value = member(name, expected.c_str());
    if (!value.is_number()) refuse(name, expected);
    const double x = value.get<double>();
    if (!(x >= lo && x <= hi)) refuse(name, expected);
    return x;
  }
  std::uint32_t count(const char* name, double most = 4294967295.0) const {
    const double x = number(name, 0, most);
    if (x != std::floor(x)) refuse(name, "a whole number");
    return static_cast<std::uint32_t>(x);
  }
  bool flag(const char* name) const {
    const Json& value = member(name, "true or false");
    if (!value.is_boolean()) refuse(name, "true or false");
    return value.get<bool>();
  }
  std::string text(const char* name, std::size_t most) const {
    const std::string expected = fmt::format("a text of at most {} bytes", most);
    const Json& value = member(name, expected.c_str());
    if (!value.is_string()) refuse(name, expected);
    const auto& out = value.get_ref<const std::string&>();
    if (out.size() > most || (!out.empty() && !is_utf8_text(out))) refuse(name, expected);
    return out;
  }
  Modifiers modifiers() const {
    const std::uint32_t bits = json.contains("mods") ? count("mods", 15) : 0;
    return {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0};
  }
  MouseMoved place() const {
    return {number("x", -kFarthest, kFarthest), number("y", -kFarthest, kFarthest)};
  }
  desk::Input input(std::vector<WindowEvent> events) const { return {std::move(events), count("s")}; }
  desk::Resize size() const {
    const std::string expected = fmt::format("[width, height], {} to {} pixels", kLeastSide, kLargestSide);
    const Json& value = member("size", expected.c_str());
    const auto fits = [](const Json& side) {
      return side.is_number_integer() && side >= kLeastSide && side <= kLargestSide;
    };
    if (!value.is_array() || value.size() != 2 || !fits(value[0]) || !fits(value[1]))
      refuse("size", expected);
    return {value[0].get<int>(), value[1].get<int>(), number("scale", 0.25, 8)};
  }
};

desk::Input read_button(const Reader& in) {
  const std::string name = in.text("b", 8);
  if (name != "left" && name != "middle" && name != "right") refuse("b", "left, middle or right");
  const MouseButton button = name == "left"     ? MouseButton::left
                             : name == "middle" ? MouseButton::middle
                                                : MouseButton::right;
  return in.input({in.place(), MouseClicked{button, in.flag("down"), in.modifiers()}});
}

desk::Input read_key(const Reader& in) {
  std::vector<WindowEvent> events;
  const std::string name = in.text("key", 32);
  const bool down = in.flag("down"), repeated = in.json.contains("repeat") && in.flag("repeat");
  const Modifiers modifiers = in.modifiers();
  try {
    events.push_back(KeyChanged{parse_key(name), modifiers, down, repeated});
  } catch (const Error&) {  // a key that the window does not use
  }
  return in.input(std::move(events));
}

// Without control characters: a line break is the key enter.
desk::Input read_typed(const Reader& in) {
  const std::string text = in.text("text", 1024);
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const char32_t c = next_character(text, i);
    if (c >= 0x20 && !(c >= 0x7f && c < 0xa0)) append_character(out, c);
  }
  return in.input(out.empty() ? std::vector<WindowEvent>{} : std::vector<WindowEvent>{TextTyped{out}});
}

message::Hello read_hello(const Reader& in) {
  message::Hello out;
  out.token = in.text("token", 64);
  out.size = in.size();
  out.id = in.text("id", 16);
  if (out.id.size() != 16 || out.id.find_first_not_of("0123456789abcdef") != std::string::npos)
    refuse("id", "16 hex digits");
  if (in.json.contains("dark")) out.dark = in.flag("dark");
  return out;
}

desk::Choose read_quality(const Reader& in) {
  const std::string mode = in.text("mode", 8);
  if (mode == "auto") return {Adaptation::Mode::automatic};
  if (mode == "fast") return {Adaptation::Mode::fast};
  if (mode == "fine") return {Adaptation::Mode::fine};
  refuse("mode", "auto, fast or fine");
}

desk::Run read_script(const Reader& in) {
  const Json& actions = in.member("actions", "a list of actions");
  if (!actions.is_array()) refuse("actions", "a list of actions");
  return {actions.dump(-1, ' ', false, Json::error_handler_t::replace), {}};
}

ClientMessage read(const Json& json) {
  if (!json.is_object()) throw Error(ErrorKind::bad_input, "message", "expected an object");
  const Reader in{json};
  const std::string t = in.text("t", 32);
  if (t == "move") return in.input({in.place()});
  if (t == "button") return read_button(in);
  if (t == "wheel")
    return in.input({MouseScrolled{in.number("x", -kMostNotches, kMostNotches),
                                   in.number("y", -kMostNotches, kMostNotches)}});
  if (t == "key") return read_key(in);
  if (t == "text") return read_typed(in);
  if (t == "leave") return desk::Input{{MouseLeft{}}};
  if (t == "ack")
    return desk::Shown{in.count("frame"), json.contains("shown_ms") ? in.number("shown_ms", 0, 1e9) : 0};
  if (t == "ping") return message::Ping{in.number("at", -1e15, 1e15)};
  if (t == "size") return in.size();
  if (t == "clipboard") return desk::Paste{in.text("text", kMostMessageBytes)};
  if (t == "ask_control") return message::AskControl{};
  if (t == "give_control") return message::GiveControl{};
  if (t == "quality") return read_quality(in);
  if (t == "open") return desk::Open{in.text("name", 256)};
  if (t == "script") return read_script(in);
  if (t == "hello") return read_hello(in);
  refuse("t", "the name of a message");
}

}  // namespace

std::string json_line(const OrderedJson& json) {
  return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

ClientMessage read_client_message(std::string_view text) {
  if (text.size() > kMostMessageBytes)
    throw Error(ErrorKind::bad_input, "message", fmt::format("longer than {} bytes", kMostMessageBytes));
  try {
    return read(parse_document(std::string(text), "message", kLimits));
  } catch (const Json::exception& error) {
    throw Error(ErrorKind::bad_input, "message", error.what());
  }
}

}  // namespace pabd
