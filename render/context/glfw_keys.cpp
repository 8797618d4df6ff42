// SPDX-License-Identifier: MIT
// GLFW's numbers of keys as our names.
#include "render/context/glfw_keys.h"

#include <GLFW/glfw3.h>

namespace pabd {
namespace {

struct Pair {
  int glfw;
  Key key;
};

constexpr Pair kPairs[] = {
    {GLFW_KEY_LEFT, Key::left},
    {GLFW_KEY_RIGHT, Key::right},
    {GLFW_KEY_UP, Key::up},
    {GLFW_KEY_DOWN, Key::down},
    {GLFW_KEY_HOME, Key::home},
    {GLFW_KEY_END, Key::end},
    {GLFW_KEY_PAGE_UP, Key::page_up},
    {GLFW_KEY_PAGE_DOWN, Key::page_down},
    {GLFW_KEY_INSERT, Key::insert},
    {GLFW_KEY_DELETE, Key::del},
    {GLFW_KEY_BACKSPACE, Key::backspace},
    {GLFW_KEY_SPACE, Key::space},
    {GLFW_KEY_ENTER, Key::enter},
    {GLFW_KEY_KP_ENTER, Key::enter},
    {GLFW_KEY_ESCAPE, Key::escape},
    {GLFW_KEY_TAB, Key::tab},
    {GLFW_KEY_MINUS, Key::minus},
    {GLFW_KEY_KP_SUBTRACT, Key::minus},
    {GLFW_KEY_EQUAL, Key::equal},
    {GLFW_KEY_KP_ADD, Key::equal},
    {GLFW_KEY_COMMA, Key::comma},
    {GLFW_KEY_PERIOD, Key::period},
    {GLFW_KEY_KP_DECIMAL, Key::period},
    {GLFW_KEY_SLASH, Key::slash},
    {GLFW_KEY_KP_DIVIDE, Key::slash},
    {GLFW_KEY_SEMICOLON, Key::semicolon},
    {GLFW_KEY_APOSTROPHE, Key::apostrophe},
    {GLFW_KEY_LEFT_BRACKET, Key::left_bracket},
    {GLFW_KEY_RIGHT_BRACKET, Key::right_bracket},
    {GLFW_KEY_BACKSLASH, Key::backslash},
    {GLFW_KEY_GRAVE_ACCENT, Key::grave},
    {GLFW_KEY_LEFT_CONTROL, Key::ctrl},
    {GLFW_KEY_RIGHT_CONTROL, Key::ctrl},
    {GLFW_KEY_LEFT_SHIFT, Key::shift},
    {GLFW_KEY_RIGHT_SHIFT, Key::shift},
    {GLFW_KEY_LEFT_ALT, Key::alt},
    {GLFW_KEY_RIGHT_ALT, Key::alt},
    {GLFW_KEY_LEFT_SUPER, Key::super},
    {GLFW_KEY_RIGHT_SUPER, Key::super},
};

Key shifted(Key first, int by) { return static_cast<Key>(static_cast<int>(first) + by); }

}  // namespace

Key key_of_glfw(int key, int scancode) {
  // On another layout than the US one, Ctrl+Z is where that layout has its Z.
  if (const char* name =
          key >= GLFW_KEY_SPACE && key <= GLFW_KEY_GRAVE_ACCENT ? glfwGetKeyName(key, scancode) : nullptr;
      name != nullptr && name[0] >= 'a' && name[0] <= 'z' && name[1] == '\0') {
    return shifted(Key::a, name[0] - 'a');
  }
  if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) return shifted(Key::a, key - GLFW_KEY_A);
  if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) return shifted(Key::digit_0, key - GLFW_KEY_0);
  if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) return shifted(Key::digit_0, key - GLFW_KEY_KP_0);
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return shifted(Key::f1, key - GLFW_KEY_F1);
  for (const Pair& pair : kPairs) {
    if (pair.glfw == key) return pair.key;
  }
  return Key::none;
}

Modifiers modifiers_of_glfw(int bits) {
  return {(bits & GLFW_MOD_CONTROL) != 0, (bits & GLFW_MOD_SHIFT) != 0, (bits & GLFW_MOD_ALT) != 0,
          (bits & GLFW_MOD_SUPER) != 0};
}

}  // namespace pabd
