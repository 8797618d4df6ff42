// SPDX-License-Identifier: MIT
// What a page may say: text messages of the subprotocol pabd.1, read with limits on everything. Knows no
// network.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "render/context/keyboard.h"

namespace pabd {

inline constexpr std::size_t kMostMessageBytes = 64 * 1024;
inline constexpr std::size_t kMostHelloBytes = 4 * 1024;
inline constexpr int kLeastSide = 64, kLargestSide = 8192;  // pixels of a window that may be asked for

namespace message {

struct Hello {
  std::string token;
  int width = 0, height = 0;
  double scale = 1;
  std::string id;            // hex digits that the page keeps
  std::optional<bool> dark;  // what the browser prefers
};
// Input; `stamp` comes back with the first frame that shows it.
struct Move {
  double x = 0, y = 0;
  std::uint32_t stamp = 0;
};
struct Button {
  MouseButton button = MouseButton::left;
  bool down = false;
  double x = 0, y = 0;
  Modifiers modifiers;
  std::uint32_t stamp = 0;
};
struct Wheel {
  double x = 0, y = 0;  // notches
  std::uint32_t stamp = 0;
};
struct KeyPress {
  Key key = Key::none;  // none: one that the window does not know
  bool down = false, repeated = false;
  Modifiers modifiers;
  std::uint32_t stamp = 0;
};
struct Text {
  std::string text;  // UTF-8 without control characters
  std::uint32_t stamp = 0;
};
struct Leave {};
struct Size {
  int width = 0, height = 0;
  double scale = 1;
};
struct Clipboard {
  std::string text;
};
struct Ack {
  std::uint32_t frame = 0;
  double shown_ms = 0;  // that the page took
};
struct AskControl {};
struct GiveControl {};
struct Quality {
  std::string mode;  // auto, fast, fine
};
struct Open {
  std::string name;
};
struct Actions {
  std::string json;
};
struct Ping {
  double at = 0;
};

}  // namespace message

using ClientMessage =
    std::variant<message::Hello, message::Move, message::Button, message::Wheel, message::KeyPress,
                 message::Text, message::Leave, message::Size, message::Clipboard, message::Ack,
                 message::AskControl, message::GiveControl, message::Quality, message::Open, message::Actions,
                 message::Ping>;

// Throws Error(bad_input), in one line, for everything that is no message; members that nobody asked for are
// passed over. No other exception, whatever the text.
ClientMessage read_client_message(std::string_view text);

}  // namespace pabd
