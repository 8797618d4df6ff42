// SPDX-License-Identifier: MIT
// See client_message.h.
#include "app/serve/client_message.h"

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
  double number_or(const char* name, double lo, double hi, double otherwise) const {
    return json.contains(name) ? number(name, lo, hi) : otherwise;
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
  std::uint32_t stamp() const { return count("s"); }
  void size(int& width, int& height) const {
    const std::string expected = fmt::format("[width, height], {} to {} pixels", kLeastSide, kLargestSide);
    const Json& value = member("size", expected.c_str());
    const auto fits = [](const Json& side) {
      return side.is_number_integer() && side >= kLeastSide && side <= kLargestSide;
    };
    if (!value.is_array() || value.size() != 2 || !fits(value[0]) || !fits(value[1]))
      refuse("size", expected);
    width = value[0].get<int>();
    height = value[1].get<int>();
  }
  double scale() const { return number("scale", 0.25, 8); }
};

MouseButton button_of(const std::string& name) {
  if (name == "left") return MouseButton::left;
  if (name == "middle") return MouseButton::middle;
  if (name == "right") return MouseButton::right;
  refuse("b", "left, middle or right");
}

Key key_of(const std::string& name) {
  try {
    return parse_key(name);
  } catch (const Error&) {
    return Key::none;  // keyboards have more keys than the window
  }
}

// What is typed is characters: a line break is the key enter.
std::string typed(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const char32_t c = next_character(text, i);
    if (c >= 0x20 && !(c >= 0x7f && c < 0xa0)) append_character(out, c);
  }
  return out;
}

bool is_hex(const std::string& text, std::size_t digits) {
  return text.size() == digits && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

message::Hello read_hello(const Reader& in) {
  message::Hello out;
  out.token = in.text("token", 64);
  in.size(out.width, out.height);
  out.scale = in.scale();
  out.id = in.text("id", 16);
  if (!is_hex(out.id, 16)) refuse("id", "16 hex digits");
  if (in.json.contains("dark")) out.dark = in.flag("dark");
  return out;
}

message::Size read_size(const Reader& in) {
  message::Size out;
  in.size(out.width, out.height);
  out.scale = in.scale();
  return out;
}

message::Quality read_quality(const Reader& in) {
  const std::string mode = in.text("mode", 8);
  if (mode != "auto" && mode != "fast" && mode != "fine") refuse("mode", "auto, fast or fine");
  return {mode};
}

message::Actions read_actions(const Reader& in) {
  const Json& actions = in.member("actions", "a list of actions");
  if (!actions.is_array()) refuse("actions", "a list of actions");
  return {actions.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

ClientMessage read(const Json& json) {
  if (!json.is_object()) throw Error(ErrorKind::bad_input, "message", "expected an object");
  const Reader in{json};
  const std::string t = in.text("t", 32);
  const auto x = [&] { return in.number("x", -kFarthest, kFarthest); };
  const auto y = [&] { return in.number("y", -kFarthest, kFarthest); };
  if (t == "move") return message::Move{x(), y(), in.stamp()};
  if (t == "button")
    return message::Button{button_of(in.text("b", 8)), in.flag("down"), x(), y(), in.modifiers(), in.stamp()};
  if (t == "wheel")
    return message::Wheel{in.number("x", -kMostNotches, kMostNotches),
                          in.number("y", -kMostNotches, kMostNotches), in.stamp()};
  if (t == "key")
    return message::KeyPress{key_of(in.text("key", 32)), in.flag("down"),
                             json.contains("repeat") && in.flag("repeat"), in.modifiers(), in.stamp()};
  if (t == "text") return message::Text{typed(in.text("text", 1024)), in.stamp()};
  if (t == "ack") return message::Ack{in.count("frame"), in.number_or("shown_ms", 0, 1e9, 0)};
  if (t == "ping") return message::Ping{in.number("at", -1e15, 1e15)};
  if (t == "leave") return message::Leave{};
  if (t == "size") return read_size(in);
  if (t == "clipboard") return message::Clipboard{in.text("text", kMostMessageBytes)};
  if (t == "ask_control") return message::AskControl{};
  if (t == "give_control") return message::GiveControl{};
  if (t == "quality") return read_quality(in);
  if (t == "open") return message::Open{in.text("name", 256)};
  if (t == "script") return read_actions(in);
  if (t == "hello") return read_hello(in);
  refuse("t", "the name of a message");
}

}  // namespace

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
