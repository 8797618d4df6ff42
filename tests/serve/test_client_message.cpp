// SPDX-License-Identifier: MIT
// What pages say: every message is read, everything else is refused in one line.
#include <catch2/catch.hpp>
#include <random>
#include <set>

#include "app/serve/messages.h"
#include "sim/base/error.h"
#include "sim/base/utf8.h"

namespace pabd::test_client_message {

namespace {

const std::vector<std::string>& samples() {
  static const std::vector<std::string> all = {
      R"({"t":"hello","token":"0123456789abcdef0123456789abcdef","size":[1280,720],"scale":1.5,"id":"0123456789abcdef","dark":false})",
      R"({"t":"move","x":12.5,"y":700,"s":1})",
      R"({"t":"button","b":"middle","down":true,"x":1,"y":2,"mods":5,"s":4294967295})",
      R"({"t":"wheel","x":0,"y":-1.5,"s":3})",
      R"({"t":"key","key":"a","down":true,"mods":1,"repeat":false,"s":4})",
      R"({"t":"text","text":"κ = 1","s":5})",
      R"({"t":"leave"})",
      R"({"t":"size","size":[640,360],"scale":2})",
      R"({"t":"clipboard","text":"pabd render"})",
      R"({"t":"ack","frame":7,"shown_ms":3.5})",
      R"({"t":"ask_control"})",
      R"({"t":"give_control"})",
      R"({"t":"quality","mode":"fine"})",
      R"({"t":"open","name":"stack.json"})",
      R"({"t":"script","actions":[{"do":"step","steps":2}]})",
      R"({"t":"ping","at":123.5})"};
  return all;
}

// The events of an input.
std::vector<WindowEvent> events_of(const std::string& text) {
  return std::get<desk::Input>(read_client_message(text)).events;
}

// Empty: it was taken.
std::string refusal(const std::string& text) {
  try {
    static_cast<void>(read_client_message(text));
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("every message is read as it was meant") {
  const auto hello = std::get<message::Hello>(read_client_message(samples()[0]));
  CHECK(hello.token == "0123456789abcdef0123456789abcdef");
  CHECK(hello.size.width == 1280);
  CHECK(hello.size.height == 720);
  CHECK(hello.size.scale == 1.5);
  CHECK(hello.dark == std::optional<bool>(false));
  const auto move = events_of(samples()[1]);
  REQUIRE(move.size() == 1);
  CHECK(std::get<MouseMoved>(move[0]).x == 12.5);
  CHECK(std::get<MouseMoved>(move[0]).y == 700);
  const auto input = std::get<desk::Input>(read_client_message(samples()[2]));
  REQUIRE(input.events.size() == 2);  // there, and then pressed
  CHECK(std::get<MouseMoved>(input.events[0]).y == 2);
  const auto button = std::get<MouseClicked>(input.events[1]);
  CHECK(button.button == MouseButton::middle);
  CHECK(button.pressed);
  CHECK(button.modifiers == Modifiers{true, false, true, false});
  CHECK(input.stamp == 4294967295u);
  CHECK(std::get<MouseScrolled>(events_of(samples()[3]).at(0)).y == -1.5);
  CHECK(std::get<KeyChanged>(events_of(samples()[4]).at(0)).key == Key::a);
  CHECK(std::get<TextTyped>(events_of(samples()[5]).at(0)).text == "κ = 1");
  CHECK(std::holds_alternative<MouseLeft>(events_of(samples()[6]).at(0)));
  CHECK(std::get<desk::Resize>(read_client_message(samples()[7])).height == 360);
  CHECK(std::get<desk::Paste>(read_client_message(samples()[8])).text == "pabd render");
  CHECK(std::get<desk::Shown>(read_client_message(samples()[9])).frame == 7);
  CHECK(std::get<desk::Choose>(read_client_message(samples()[12])).mode == Adaptation::Mode::fine);
  CHECK(std::get<desk::Open>(read_client_message(samples()[13])).name == "stack.json");
  CHECK(std::get<desk::Run>(read_client_message(samples()[14])).json == R"([{"do":"step","steps":2}])");
  std::set<std::size_t> kinds;
  for (const std::string& sample : samples()) kinds.insert(read_client_message(sample).index());
  CHECK(kinds.size() == std::variant_size_v<ClientMessage>);
}

TEST_CASE("keys that the window does not know do nothing, control characters are not typed") {
  CHECK(events_of(R"({"t":"key","key":"VolumeUp","down":true,"s":1})").empty());
  CHECK(std::get<TextTyped>(events_of(R"({"t":"text","text":"a\n\u007fb\u0085","s":1})").at(0)).text == "ab");
}

TEST_CASE("what is wrong is said") {
  const auto says = [](const std::string& text, const std::string& part) {
    const std::string why = refusal(text);
    CAPTURE(text, why);
    CHECK(why.starts_with("message"));
    CHECK(why.find(part) != std::string::npos);
  };
  says("", "");
  says("[]", "an object");
  says("null", "an object");
  says("{}", "\"t\"");
  says(R"({"t":"dance"})", "the name of a message");
  says(R"({"t":"move","x":1,"y":2})", "\"s\"");
  says(R"({"t":"move","x":"1","y":2,"s":1})", "\"x\": expected a number");
  says(R"({"t":"move","x":1e300,"y":2,"s":1})", "\"x\"");
  says(R"({"t":"move","x":1,"y":2,"s":-1})", "\"s\"");
  says(R"({"t":"move","x":1,"y":2,"s":1.5})", "whole");
  says(R"({"t":"move","x":1,"y":2,"s":4294967296})", "\"s\"");
  says(R"({"t":"button","b":"fourth","down":true,"x":1,"y":2,"s":1})", "\"b\"");
  says(R"({"t":"size","size":[10,720],"scale":1})", "\"size\"");
  says(R"({"t":"size","size":[1280,720,3],"scale":1})", "\"size\"");
  says(R"({"t":"size","size":[1280,720],"scale":0})", "\"scale\"");
  says(R"({"t":"quality","mode":"best"})", "auto, fast or fine");
  says(R"({"t":"ping","at":1,"at":2})", "");  // twice the same key
  says("{\"t\":\"text\",\"text\":\"\xff\",\"s\":1}", "");
  says(R"({"t":"text","text":"a\u0000b","s":1})", "\"text\"");
  says(R"({"t":"open","name":")" + std::string(300, 'x') + R"("})", "\"name\"");
  says(std::string(kMostMessageBytes + 1, ' '), "longer than 65536");
  says(std::string(30000, '[') + std::string(30000, ']'), "");
}

TEST_CASE("100000 messages that were spoilt at random are taken or refused, and nothing else") {
  std::mt19937 random(7);
  const auto below = [&](std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
  };
  static const std::vector<std::string> pieces = {"\"",      "{",       "}",        "[",
                                                  "]",       ",",       ":",        "null",
                                                  "true",    "1e999",   "-0",       "99999999999999999999",
                                                  "\\u0000", "\\ud800", "\xc3\x28", "NaN",
                                                  "\"t\":",  "\"s\":",  "\"x\":"};
  int taken = 0, refused = 0;
  for (int i = 0; i < 100000; ++i) {
    std::string text = samples()[below(samples().size())];
    for (std::size_t k = 1 + below(4); k > 0; --k) {
      const std::size_t at = below(text.size() + 1);
      switch (below(5)) {
        case 0:
          if (at < text.size()) text[at] = static_cast<char>(below(256));
          break;
        case 1:
          text.insert(at, pieces[below(pieces.size())]);
          break;
        case 2:
          text.erase(at, below(8));
          break;
        case 3:
          text.resize(at);
          break;
        default:
          text.insert(at, samples()[below(samples().size())].substr(0, below(40)));
      }
    }
    try {
      static_cast<void>(read_client_message(text));
      ++taken;
    } catch (const Error& error) {
      ++refused;
      const std::string why = error.what();
      if (error.kind() != ErrorKind::bad_input || why != one_line(why)) FAIL(text + " → " + why);
    }
  }
  CHECK(taken + refused == 100000);
  CHECK(taken > 1000);
  CHECK(refused > 50000);
}

}  // namespace pabd::test_client_message
