// SPDX-License-Identifier: MIT
// See imgui_input.h.
#include "app/gui/imgui_input.h"

#include "app/overlay/imgui_canvas.h"

namespace pabd {
namespace {

constexpr float kOutside = -3.4e38f;  // what ImGui calls no mouse

int button_index(MouseButton button) {
  return button == MouseButton::left ? 0 : button == MouseButton::right ? 1 : 2;
}

struct Feeder {
  ImGuiIO& io;
  void operator()(const MouseMoved& e) const {
    io.MousePos = {static_cast<float>(e.x), static_cast<float>(e.y)};
  }
  void operator()(const MouseLeft&) const { io.MousePos = {kOutside, kOutside}; }
  void operator()(const MouseClicked& e) const {
    io.MouseDown[button_index(e.button)] = e.pressed;
    modifiers(e.modifiers);
  }
  void operator()(const MouseScrolled& e) const {
    io.MouseWheel += static_cast<float>(e.y);
    io.MouseWheelH += static_cast<float>(e.x);
  }
  void operator()(const KeyChanged& e) const {
    io.KeysDown[static_cast<int>(e.key)] = e.pressed;
    modifiers(e.modifiers);
  }
  void operator()(const TextTyped& e) const { io.AddInputCharactersUTF8(e.text.c_str()); }
  void operator()(const FocusChanged& e) const {
    if (e.focused) return;
    io.AddFocusEvent(false);
    for (bool& down : io.KeysDown) down = false;
    for (bool& down : io.MouseDown) down = false;
    modifiers({});
  }
  template <class Other>
  void operator()(const Other&) const {}

  void modifiers(const Modifiers& m) const {
    io.KeyCtrl = m.ctrl;
    io.KeyShift = m.shift;
    io.KeyAlt = m.alt;
    io.KeySuper = m.super;
  }
};

// What may change only once a frame: a number for each button and key; −1 for other events.
int once(const WindowEvent& event) {
  if (const auto* click = std::get_if<MouseClicked>(&event)) return button_index(click->button);
  if (const auto* key = std::get_if<KeyChanged>(&event))
    return key->repeated ? -1 : 8 + static_cast<int>(key->key);
  return -1;
}

void set_up_keys(ImGuiIO& io) {
  const auto map = [&io](ImGuiKey_ imgui, Key key) { io.KeyMap[imgui] = static_cast<int>(key); };
  map(ImGuiKey_Tab, Key::tab);
  map(ImGuiKey_LeftArrow, Key::left);
  map(ImGuiKey_RightArrow, Key::right);
  map(ImGuiKey_UpArrow, Key::up);
  map(ImGuiKey_DownArrow, Key::down);
  map(ImGuiKey_PageUp, Key::page_up);
  map(ImGuiKey_PageDown, Key::page_down);
  map(ImGuiKey_Home, Key::home);
  map(ImGuiKey_End, Key::end);
  map(ImGuiKey_Insert, Key::insert);
  map(ImGuiKey_Delete, Key::del);
  map(ImGuiKey_Backspace, Key::backspace);
  map(ImGuiKey_Space, Key::space);
  map(ImGuiKey_Enter, Key::enter);
  map(ImGuiKey_Escape, Key::escape);
  map(ImGuiKey_KeyPadEnter, Key::enter);
  map(ImGuiKey_A, Key::a);
  map(ImGuiKey_C, Key::c);
  map(ImGuiKey_V, Key::v);
  map(ImGuiKey_X, Key::x);
  map(ImGuiKey_Y, Key::y);
  map(ImGuiKey_Z, Key::z);
}

}  // namespace

ImGuiContext* make_gui_context() {
  ImGuiContext* context = new_imgui_context();
  ImGuiIO& io = ImGui::GetIO();
  io.ConfigInputTextCursorBlink = false;  // every picture of a state is the same
  set_up_keys(io);
  return context;
}

std::vector<WindowEvent> ImGuiInput::feed(ImGuiIO& io) {
  std::vector<WindowEvent> taken;
  bool seen[8 + kKeyCount] = {};
  while (!waiting_.empty()) {
    const int which = once(waiting_.front());
    if (which >= 0 && seen[which]) break;
    if (which >= 0) seen[which] = true;
    // A press happens where the pointer was then.
    if (std::holds_alternative<MouseMoved>(waiting_.front()) && (seen[0] || seen[1] || seen[2])) break;
    std::visit(Feeder{io}, waiting_.front());
    taken.push_back(std::move(waiting_.front()));
    waiting_.pop_front();
  }
  return taken;
}

MouseCursor imgui_cursor() {
  switch (ImGui::GetMouseCursor()) {
    case ImGuiMouseCursor_TextInput:
      return MouseCursor::text;
    case ImGuiMouseCursor_ResizeEW:
      return MouseCursor::resize_horizontal;
    case ImGuiMouseCursor_ResizeNS:
      return MouseCursor::resize_vertical;
    case ImGuiMouseCursor_Hand:
      return MouseCursor::hand;
    default:
      return MouseCursor::arrow;
  }
}

}  // namespace pabd
