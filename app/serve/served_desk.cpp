// SPDX-License-Identifier: MIT
// See served_desk.h.
#include "app/serve/served_desk.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>

#include "app/gui/viewer.h"
#include "app/serve/clock.h"
#include "app/serve/desk_queue.h"
#include "app/serve/desk_work.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr double kFrame = 1.0 / 60;  // s, least time between two frames
constexpr double kLook = 0.004;      // s between two polls of a simulation that plays slowly
constexpr double kUnseen = 0.1;      // s between frames that no visitor waits for
constexpr double kAtRest = 0.05;     // s between two polls of a simulation at rest
constexpr double kAlone = 0.25;      // the same without visitors
// s after the last change at which frames are drawn again: the picture is refined, messages disappear.
constexpr double kLater[] = {0.1, 0.35, 0.7, 1.5, 3, 4.5, 6, 9, 13};

struct LockAtEnd {
  std::unique_lock<std::mutex>& lock;
  ~LockAtEnd() { lock.lock(); }
};

}  // namespace

struct ServedDesk::Impl {
  DeskOptions options;
  std::function<void(DeskNews)> on_news;
  DeskQueue queue;
  std::atomic<bool> events{false};
  std::shared_ptr<Runner> runner;  // stopped by the destructor
  const std::shared_ptr<SharedContext> shared = std::make_shared<SharedContext>();
  std::mutex runner_mutex;
  std::promise<void> ready;
  std::thread thread;

  // Used by the thread only:
  std::size_t later = std::size(kLater);
  double changed = 0, drawn = -1e9, stats_sent = 0;
  bool owed = true;          // the last frame may be outdated
  bool was_playing = false;  // when the last visitor left

  Impl(const DeskOptions& o, std::function<void(DeskNews)> h) : options(o), on_news(std::move(h)) {}

  void work() {
    bool started = false;
    try {
      start_runner();  // first: a run that is made on the GPU makes a context of its own current
      std::vector<ContextAttempt> attempts;
      const auto context = create_headless_context(options.backend, attempts);
      if (options.devices) shared->put_beside(*context);
      if (options.play) runner->send(command::Play{});  // now bodies can be drawn from where steps are made
      std::unique_lock turn(*options.turn);
      DeskWork desk(*context, *runner, options, queue, on_news);
      turn.unlock();
      started = true;
      ready.set_value();
      const LockAtEnd at_end{turn};  // the desk destroys its interface under the lock
      while (!queue.stopped()) round(desk);
    } catch (const std::exception& error) {
      if (!started) ready.set_exception(std::current_exception());
      on_news(desk::Ended{error.what()});
    }
  }

  void start_runner() {
    WorkbenchOptions bench;
    bench.threads = options.threads;
    bench.memory = options.memory;
    if (options.devices) bench.devices = options.devices(shared);
    bench.find_scene = [this](const std::string& name) { return scene_file(name); };
    for (const auto& folder : options.mesh_folders) options.files->allow(folder);
    // The scene of the command line may read its meshes wherever they are.
    const auto starting = std::make_shared<std::atomic<bool>>(true);
    bench.may_read = [files = options.files, starting](const std::filesystem::path& mesh) {
      if (*starting) files->allow(mesh);
      files->check_mesh(mesh);
    };
    auto made = std::make_shared<Runner>(
        std::make_unique<Workbench>(bench, command::Load{options.scene, options.sets, false}));
    *starting = false;
    const std::scoped_lock lock(runner_mutex);
    runner = std::move(made);
  }

  std::string scene_file(const std::string& name) const {
    if (name == options.scene) return name;
    std::error_code none;
    try {
      const std::string file = options.files->file_of(name);
      if (std::filesystem::is_regular_file(file, none)) return file;
    } catch (const Error&) {  // not a name in the folder
    }
    return options.find_scene(name);
  }

  void happened() {
    owed = true;
    changed = seconds_now();
    later = 0;
  }

  void round(DeskWork& desk) {
    for (DeskInput& input : queue.take(std::chrono::duration<double>(wait(desk)))) {
      const bool alone = desk.stream().empty();
      if (desk.take(input)) happened();
      if (queue.stopped()) return;
      if (alone != desk.stream().empty()) left_alone(desk, !alone);
    }
    const double now = seconds_now();
    if (desk.look(events)) happened();
    if (later < std::size(kLater) && now - changed >= kLater[later]) {
      ++later;
      owed = true;
    }
    if (const auto next = next_draw(desk); next && now >= *next) {
      const std::scoped_lock turn(*options.turn);
      owed = false;
      drawn = now;
      if (desk.draw()) changed = std::max(changed, now - kLater[0]);
    }
    desk.stream().deliver(seconds_now());
    if (now - stats_sent >= 1) {
      stats_sent = now;
      desk.send_stats(now);
    }
  }

  // When the next frame may be drawn, if there is a reason for one.
  std::optional<double> next_draw(DeskWork& desk) const {
    const bool seen = desk.stream().wants_frame();
    if (desk.viewer().has_input()) return drawn + (seen ? kFrame : kUnseen);
    if (owed && seen) return drawn + kFrame;
    return std::nullopt;
  }

  double wait(DeskWork& desk) const {
    const double now = seconds_now();
    double out = desk.stream().empty() && !events ? kAlone : kAtRest;
    if (desk.viewer().snapshot().playing && desk.stream().wants_frame())
      out = std::max(kLook, drawn + kFrame - now);
    if (const auto next = next_draw(desk)) out = std::min(out, std::max(0.0, *next - now));
    if (const auto due = desk.stream().due()) out = std::min(out, std::max(0.0, *due - now));
    if (later < std::size(kLater)) out = std::min(out, std::max(0.0, changed + kLater[later] - now));
    return out;
  }

  void left_alone(DeskWork& desk, bool alone) {
    if (!options.pause_when_alone) return;
    if (alone) {
      was_playing = runner->latest()->playing;
      if (was_playing) desk.viewer().send(Command(command::Pause{}));
    } else if (was_playing) {
      desk.viewer().send(Command(command::Play{}));
    }
  }
};

ServedDesk::ServedDesk(const DeskOptions& options, std::function<void(DeskNews)> on_news)
    : impl_(std::make_unique<Impl>(options, std::move(on_news))) {
  impl_->thread = std::thread([impl = impl_.get()] { impl->work(); });
}

void ServedDesk::wait_until_ready() { impl_->ready.get_future().get(); }

ServedDesk::~ServedDesk() {
  impl_->queue.stop();
  {
    const std::scoped_lock lock(impl_->runner_mutex);
    if (impl_->runner) impl_->runner->stop();
  }
  impl_->thread.join();
}

bool ServedDesk::send(DeskInput input) { return impl_->queue.push(std::move(input)); }
void ServedDesk::enable_events(bool on) { impl_->events = on; }

}  // namespace pabd
