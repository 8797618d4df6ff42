// SPDX-License-Identifier: MIT
// Names of keys, and what is said when there is no display. Windows on a real display are tested with the
// program.
#include "render/context/window.h"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <optional>
#include <set>

#include "sim/base/error.h"

namespace pabd::test_window {

namespace {

// Takes a variable out of the environment for a while.
class Without {
 public:
  explicit Without(const char* name) : name_(name) {
    if (const char* value = std::getenv(name)) value_ = value;
    unsetenv(name);
  }
  ~Without() {
    if (value_) setenv(name_, value_->c_str(), 1);
  }
  Without(const Without&) = delete;
  Without& operator=(const Without&) = delete;

 private:
  const char* name_;
  std::optional<std::string> value_;
};

std::string refusal(const std::string& chord) {
  try {
    parse_key_chord(chord);
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::bad_input);
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("every key and chord has a name of its own that reads back") {
  std::set<std::string> names;
  for (int k = 1; k < kKeyCount; ++k) {
    const Key key = static_cast<Key>(k);
    CAPTURE(to_string(key));
    names.insert(to_string(key));
    CHECK(parse_key(to_string(key)) == key);
    for (unsigned bits = 0; bits < 16; ++bits) {
      const KeyChord chord{key, {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0}};
      CHECK(parse_key_chord(to_string(chord)) == chord);
    }
  }
  CHECK(names.size() == kKeyCount - 1);
  for (const MouseButton button : {MouseButton::left, MouseButton::right, MouseButton::middle})
    CHECK(parse_mouse_button(to_string(button)) == button);
}

TEST_CASE("keys as people write them") {
  CHECK(parse_key("F12") == Key::f12);
  CHECK(parse_key("space") == Key::space);
  CHECK(parse_key("7") == Key::digit_7);
  CHECK(parse_key_chord("Ctrl+S") == KeyChord{Key::s, {true, false, false, false}});
  CHECK(parse_key_chord("shift+ctrl+/") == KeyChord{Key::slash, {true, true, false, false}});
  CHECK(parse_key_chord("?") == KeyChord{Key::slash, {false, true, false, false}});
  CHECK(to_string(KeyChord{Key::page_up, {true, true, false, false}}) == "ctrl+shift+page_up");
}

TEST_CASE("what is no key is refused, with what would be one") {
  for (const char* text : {"", "none", "spcae", "ctrl+", "ctr+s", "ctrl+ctrl+s", "+", "F13", "ctrl s"}) {
    CAPTURE(text);
    CHECK(refusal(text).find("expected") != std::string::npos);
  }
  CHECK(refusal("spcae").find("'spcae'") != std::string::npos);
  CHECK_THROWS_AS(parse_mouse_button("wheel"), Error);
}

TEST_CASE("without a display no window opens, and the message says what helps") {
  const Without x("DISPLAY"), wayland("WAYLAND_DISPLAY");
  try {
    open_window({});
    FAIL("a window without a display");
  } catch (const Error& error) {
    const std::string text = error.what();
    CAPTURE(text);
    CHECK(error.kind() == ErrorKind::no_context);
    CHECK(text.find("no window") != std::string::npos);
    CHECK(text.find("--headless") != std::string::npos);
    CHECK(text.find('\n') == std::string::npos);
  }
}

}  // namespace pabd::test_window
