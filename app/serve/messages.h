// SPDX-License-Identifier: MIT
// Every message: from pages (the subprotocol pabd.1, README.md), to a desk and from it. What a page may ask of the
// desk itself is one message both ways. Knows no network.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/serve/adaptation.h"
#include "app/serve/frame_encoder.h"
#include "app/serve/roles.h"
#include "render/context/window.h"
#include "sim/base/ordered_json.h"

namespace pabd {

inline constexpr std::size_t kMostMessageBytes = 64 * 1024;
inline constexpr std::size_t kMostHelloBytes = 4 * 1024;
inline constexpr int kLeastSide = 64, kLargestSide = 8192;  // pixels of a window that may be asked for

namespace desk {

// ---- of a page, to the desk ----
// What a hand did; `stamp` comes back with the first frame that shows it.
struct Input {
  std::vector<WindowEvent> events;
  std::uint32_t stamp = 0;
};
struct Resize {
  int width = 0, height = 0;
  double scale = 1;
};
struct Paste {
  std::string text;
};
struct Shown {
  std::uint32_t frame = 0;
  double ms = 0;          // that the page took
  VisitorId visitor = 0;  // not said by the page
};
struct Choose {
  Adaptation::Mode mode = Adaptation::Mode::automatic;
};
struct Open {
  std::string name;
};
struct Answer {
  int status = 200;
  std::string type, body;
};
using Reply = std::function<void(Answer)>;  // called once, in the desk's thread
struct Run {
  std::string json;  // a script
  Reply reply;       // may be empty
};

// ---- of the lobby and of programs, to the desk ----
struct Arrive {
  VisitorId visitor = 0;
};
// What the page of the first who controls prefers.
struct Scheme {
  bool dark = true;
};
struct Depart {
  VisitorId visitor = 0;
};
// Another controls now, or nobody: what is held is let go; whose link decides how good frames are.
struct HandOver {
  std::optional<VisitorId> controller;
};
// A page lost what it had: a whole frame.
struct Refresh {
  VisitorId visitor = 0;
};
// A visitor put it there: no news of what was saved.
struct Uploaded {
  std::string name;
};
struct AskState {
  Reply reply;
};
struct AskPicture {
  int width = 0, height = 0;  // 0: as it is
  bool panels = true;
  Reply reply;
};

// ---- of the desk ----
struct Frame {
  VisitorId visitor = 0;
  EncodedFrame frame;
};
struct Text {
  std::string json;
  bool control_only = false;
};
struct Event {
  std::string json;  // a line for GET /events
};
struct Ended {
  std::string why;
};

}  // namespace desk

// ---- of a page, to the lobby ----
namespace message {

struct Hello {
  std::string token;
  desk::Resize size;
  std::string id;            // hex digits that the page keeps
  std::optional<bool> dark;  // what the browser prefers
};
struct AskControl {};
struct GiveControl {};
struct Ping {
  double at = 0;
};

}  // namespace message

using ClientMessage =
    std::variant<message::Hello, message::AskControl, message::GiveControl, message::Ping, desk::Input,
                 desk::Resize, desk::Paste, desk::Shown, desk::Choose, desk::Open, desk::Run>;
using DeskInput = std::variant<desk::Input, desk::Resize, desk::Paste, desk::Shown, desk::Choose, desk::Open,
                               desk::Run, desk::Arrive, desk::Scheme, desk::Depart, desk::HandOver,
                               desk::Refresh, desk::Uploaded, desk::AskState, desk::AskPicture>;
using DeskNews = std::variant<desk::Frame, desk::Text, desk::Event, desk::Ended>;

// JSON as it is sent, in one line; what is no UTF-8 is replaced.
std::string json_line(const OrderedJson& json);

// Throws Error(bad_input), in one line, for everything that is no message; members that nobody asked for are
// passed over. No other exception, whatever the text.
ClientMessage read_client_message(std::string_view text);

}  // namespace pabd
