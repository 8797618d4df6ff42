// SPDX-License-Identifier: MIT
// All messages: from pages (the subprotocol pabd.1, README.md), to a desk and from a desk. What a page asks of the desk
// is the same struct for both. Without network.
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
inline constexpr int kLeastSide = 64, kLargestSide = 8192;  // of a requested window, pixels

namespace desk {

// ---- from a page to the desk ----
// Mouse and keyboard; `stamp` is returned with the first frame that shows it.
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
  double ms = 0;          // from arrival to display
  VisitorId visitor = 0;  // set by the lobby
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

// ---- from the lobby and from programs to the desk ----
struct Arrive {
  VisitorId visitor = 0;
};
// Preference of the first controller's page.
struct Scheme {
  bool dark = true;
};
struct Depart {
  VisitorId visitor = 0;
};
// Another visitor controls now, or nobody: held buttons and keys are released, and its link controls the adaptation.
struct HandOver {
  std::optional<VisitorId> controller;
};
// The page lost its picture and needs a whole frame.
struct Refresh {
  VisitorId visitor = 0;
};
// A visitor uploaded the file: it is not announced as saved.
struct Uploaded {
  std::string name;
};
struct AskState {
  Reply reply;
};
struct AskPicture {
  int width = 0, height = 0;  // 0: that of the window
  bool panels = true;
  Reply reply;
};

// ---- from the desk ----
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

// ---- from a page to the lobby ----
namespace message {

struct Hello {
  std::string token;
  desk::Resize size;
  std::string id;            // hex digits that the page keeps
  std::optional<bool> dark;  // the browser's preference
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

// In one line, with invalid UTF-8 replaced.
std::string json_line(const OrderedJson& json);

// Throws Error(bad_input), in one line, for anything that is not a message, and no other exception; unknown members are
// ignored.
ClientMessage read_client_message(std::string_view text);

}  // namespace pabd
