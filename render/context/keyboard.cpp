// SPDX-License-Identifier: MIT
// Names of keys.
#include "render/context/keyboard.h"

#include <algorithm>
#include <array>

#include "sim/base/error.h"

namespace pabd {
namespace {

// By Key.
constexpr std::array<const char*, kKeyCount> kNames = {
    // clang-format off
    "none",
    "a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l", "m",
    "n", "o", "p", "q", "r", "s", "t", "u", "v", "w", "x", "y", "z",
    "0", "1", "2", "3", "4", "5", "6", "7", "8", "9",
    "F1", "F2", "F3", "F4", "F5", "F6", "F7", "F8", "F9", "F10", "F11", "F12",
    "left", "right", "up", "down", "home", "end", "page_up", "page_down", "insert", "delete", "backspace",
    "space", "enter", "escape", "tab",
    "-", "=", ",", ".", "/", ";", "'", "[", "]", "\\", "`",
    "ctrl", "shift", "alt", "super",
    // clang-format on
};
static_assert(kNames.back() != nullptr);  // one name a key

constexpr std::array<const char*, 3> kButtons = {"left", "right", "middle"};

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool same(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

template <std::size_t N>
std::size_t find(const std::array<const char*, N>& names, std::string_view text) {
  return static_cast<std::size_t>(
      std::find_if(names.begin(), names.end(), [&](const char* name) { return same(name, text); }) -
      names.begin());
}

}  // namespace

std::string to_string(Key key) { return kNames[static_cast<std::size_t>(key)]; }

std::string to_string(const KeyChord& chord) {
  std::string text;
  if (chord.modifiers.ctrl) text += "ctrl+";
  if (chord.modifiers.shift) text += "shift+";
  if (chord.modifiers.alt) text += "alt+";
  if (chord.modifiers.super) text += "super+";
  return text + to_string(chord.key);
}

std::string to_string(MouseButton button) { return kButtons[static_cast<std::size_t>(button)]; }

Key parse_key(std::string_view text) {
  const std::size_t at = find(kNames, text);
  if (at > 0 && at < kNames.size()) return static_cast<Key>(at);
  throw Error(
      ErrorKind::bad_input,
      "key '" + std::string(text) +
          "' is unknown; expected a letter, a digit, F1 to F12, a sign such as '/', left, right, up, down, "
          "home, end, page_up, page_down, insert, delete, backspace, space, enter, escape, tab, ctrl, "
          "shift, alt or super");
}

KeyChord parse_key_chord(std::string_view text) {
  if (text == "?") text = "shift+/";  // as help writes it
  KeyChord chord;
  for (std::size_t plus = text.find('+'); plus != std::string_view::npos; plus = text.find('+')) {
    const std::string_view word = text.substr(0, plus);
    Modifiers& m = chord.modifiers;
    bool* const flag = same(word, "ctrl")    ? &m.ctrl
                       : same(word, "shift") ? &m.shift
                       : same(word, "alt")   ? &m.alt
                       : same(word, "super") ? &m.super
                                             : nullptr;
    if (flag == nullptr || *flag) {
      throw Error(ErrorKind::bad_input,
                  "modifier '" + std::string(word) +
                      "' before a '+': expected ctrl, shift, alt or super, each once, as in "
                      "'ctrl+shift+s'");
    }
    *flag = true;
    text.remove_prefix(plus + 1);
  }
  chord.key = parse_key(text);
  return chord;
}

MouseButton parse_mouse_button(std::string_view text) {
  const std::size_t at = find(kButtons, text);
  if (at < kButtons.size()) return static_cast<MouseButton>(at);
  throw Error(ErrorKind::bad_input,
              "mouse button '" + std::string(text) + "' is unknown; expected left, right or middle");
}

}  // namespace pabd
