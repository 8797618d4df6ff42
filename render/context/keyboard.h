// SPDX-License-Identifier: MIT
// Keys, modifiers and mouse buttons by names of our own: the window sends them, tables of keys and scripts
// name them. No window system in here.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace pabd {

// Letters and digits by what is printed on them; the others by place on a US keyboard. Keys of the number pad
// are those of the main block.
enum class Key : std::uint8_t {
  none,
  // clang-format off
  a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z,
  digit_0, digit_1, digit_2, digit_3, digit_4, digit_5, digit_6, digit_7, digit_8, digit_9,
  f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12,
  // clang-format on
  left,
  right,
  up,
  down,
  home,
  end,
  page_up,
  page_down,
  insert,
  del,
  backspace,
  space,
  enter,
  escape,
  tab,
  minus,
  equal,
  comma,
  period,
  slash,
  semicolon,
  apostrophe,
  left_bracket,
  right_bracket,
  backslash,
  grave,
  ctrl,
  shift,
  alt,
  super,
};
inline constexpr int kKeyCount = static_cast<int>(Key::super) + 1;

struct Modifiers {
  bool ctrl = false, shift = false, alt = false, super = false;
  bool operator==(const Modifiers&) const = default;
};

struct KeyChord {
  Key key = Key::none;
  Modifiers modifiers;
  bool operator==(const KeyChord&) const = default;
};

enum class MouseButton : std::uint8_t { left, right, middle };

// "a", "7", "F12", "space", "page_up", "/"; "none".
std::string to_string(Key key);
// "ctrl+shift+s": modifiers in the order ctrl, shift, alt, super, then the key.
std::string to_string(const KeyChord& chord);
std::string to_string(MouseButton button);  // "left", "right", "middle"

// The reverse; upper and lower case are the same. Throws Error(bad_input) with the text and what was
// expected.
Key parse_key(std::string_view text);
KeyChord parse_key_chord(std::string_view text);
MouseButton parse_mouse_button(std::string_view text);

}  // namespace pabd
