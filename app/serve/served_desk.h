// SPDX-License-Identifier: MIT
// One simulation with its window, drawn off-screen in a thread of its own.
//
//   network                                desk's thread
//   send(input)  ──→ bounded queue ──→ WindowEvent → Viewer::handle; Viewer::draw → FrameStream
//   on_news(news)←── frames for visitors that are ready, texts, the end ←─┘
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/serve/messages.h"
#include "app/session/step_devices.h"
#include "app/workbench/file_root.h"
#include "render/context/context.h"
#include "render/device/shared_context.h"

namespace pabd {

struct DeskOptions {
  std::string scene;  // its file, wherever it is
  std::vector<std::string> sets;
  int threads = 1;
  std::size_t memory = std::size_t{256} << 20;  // bytes for states of the past
  Backend backend = Backend::automatic;
  std::shared_ptr<FileRoot> files;  // of the visitors; never null
  // File of a scene that is not among those of the visitors. Throws Error.
  std::function<std::string(const std::string& name)> find_scene;
  // Makes the devices beside the CPU that can run steps, from the GL context the desk shares; null: none.
  std::function<std::shared_ptr<const StepDevices>(std::shared_ptr<SharedContext>)> devices;
  std::vector<std::filesystem::path> mesh_folders;  // that scenes may read from, beside those files
  std::function<std::vector<std::filesystem::path>()> shipped_scenes;
  // Locked while drawing: Dear ImGui has one current context per process. Never null.
  std::shared_ptr<std::mutex> turn;
  bool play = false, pause_when_alone = false;
  int width = 1280, height = 720;
};

class ServedDesk {
 public:
  static constexpr std::size_t kMostInputs = 4096;  // in the queue

  // `on_news` is called in the desk's thread; after a failure its last news is desk::Ended.
  ServedDesk(const DeskOptions& options, std::function<void(DeskNews)> on_news);
  ~ServedDesk();  // interrupts the simulation and its script
  ServedDesk(const ServedDesk&) = delete;
  ServedDesk& operator=(const ServedDesk&) = delete;

  // Waits until a frame can be drawn; call once. Throws Error of the scene (bad_input, file) or of GL (no_context).
  void wait_until_ready();

  // False: the queue is full. Successive moves of the mouse become one.
  bool send(DeskInput input);
  // Whether steps and messages are sent as events.
  void enable_events(bool on);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pabd
