// SPDX-License-Identifier: MIT
// One simulation with its window, drawn off-screen in a thread of its own.
//
//   network                                desk's thread
//   send(input)  ──→ bounded queue ──→ WindowEvent → Viewer::handle; Viewer::draw → FrameStream
//   hear(news)   ←── frames for visitors that are ready, texts, the end ←─┘
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/serve/adaptation.h"
#include "app/serve/frame_encoder.h"
#include "app/serve/roles.h"
#include "app/session/step_devices.h"
#include "app/workbench/file_root.h"
#include "render/context/context.h"
#include "render/context/window.h"
#include "render/device/shared_context.h"

namespace pabd {

struct DeskOptions {
  std::string scene;  // its file, wherever it is
  std::vector<std::string> sets;
  int threads = 1;
  std::size_t memory = std::size_t{256} << 20;  // bytes for states of the past
  Backend backend = Backend::automatic;
  std::shared_ptr<FileRoot> files;  // of the visitors; never null
  // Of scenes that are not among the files of the visitors. Throws Error.
  std::function<std::string(const std::string& name)> find_scene;
  // Beside the processor, given what the desk lends to them; null: none.
  std::function<std::shared_ptr<const StepDevices>(std::shared_ptr<SharedContext>)> devices;
  std::vector<std::filesystem::path> mesh_folders;  // that scenes may read from, beside those files
  std::function<std::vector<std::filesystem::path>()> shipped_scenes;
  // Held by whoever draws: the interface has one current context in a process. Never null.
  std::shared_ptr<std::mutex> turn;
  bool play = false, pause_when_alone = false;
  int width = 1280, height = 720;
};

namespace desk {

struct Answer {
  int status = 200;
  std::string type, body;
};
using Reply = std::function<void(Answer)>;  // called once, in the desk's thread

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
struct Input {
  WindowEvent event;
  std::uint32_t stamp = 0;
};
struct Resize {
  int width = 0, height = 0;
  double scale = 1;
};
// A page lost what it had: a whole frame.
struct Refresh {
  VisitorId visitor = 0;
};
struct Paste {
  std::string text;
};
struct Shown {
  VisitorId visitor = 0;
  std::uint32_t frame = 0;
  double ms = 0;  // that the page took
};
struct Choose {
  Adaptation::Mode mode = Adaptation::Mode::automatic;
};
struct Open {
  std::string name;
};
// A visitor put it there: no news of what was saved.
struct Uploaded {
  std::string name;
};
struct Run {
  std::string json;  // a script
  Reply reply;       // may be empty
};
struct AskState {
  Reply reply;
};
struct AskPicture {
  int width = 0, height = 0;  // 0: as it is
  bool panels = true;
  Reply reply;
};

// ---- news ----
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

using DeskInput = std::variant<desk::Arrive, desk::Scheme, desk::Depart, desk::HandOver, desk::Input,
                               desk::Resize, desk::Refresh, desk::Paste, desk::Shown, desk::Choose,
                               desk::Open, desk::Uploaded, desk::Run, desk::AskState, desk::AskPicture>;
using DeskNews = std::variant<desk::Frame, desk::Text, desk::Event, desk::Ended>;

class ServedDesk {
 public:
  static constexpr std::size_t kMostInputs = 4096;  // that wait

  // `hear` is called in the desk's thread; the last news is the end, if something went wrong.
  ServedDesk(const DeskOptions& options, std::function<void(DeskNews)> hear);
  ~ServedDesk();  // ends the simulation in the middle of a step, a script in the middle of an action
  ServedDesk(const ServedDesk&) = delete;
  ServedDesk& operator=(const ServedDesk&) = delete;

  // Until a frame can be drawn; once. Throws Error of the scene (bad_input, file) or of GL (no_context).
  void wait_until_ready();

  // False when too many wait. Moves of the mouse that follow each other become one.
  bool send(DeskInput input);
  // Whether steps and messages are told as events.
  void tell_events(bool on);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pabd
