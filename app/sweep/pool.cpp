// SPDX-License-Identifier: MIT
// See pool.h.
#include "app/sweep/pool.h"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <csignal>
#include <deque>
#include <map>
#include <memory>
#include <span>
#include <utility>

#include "sim/base/child_process.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kMostKills = 3;  // of one task
constexpr auto kBusyPause = std::chrono::milliseconds(250);
constexpr int kPollMs = 100;

struct Worker {
  explicit Worker(std::function<void(Worker&, std::string_view)> hear)
      : lines([this, hear = std::move(hear)](std::string_view line) { hear(*this, line); }) {}
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  ChildProcess child;
  LineSplitter lines;
  Tail errors;
  std::optional<std::size_t> task;
  bool silent = false;  // its outputs have ended

  void read(std::span<pollfd> sources) {
    const auto split = [this](std::string_view bytes) { lines.append(bytes.data(), bytes.size()); };
    read_pipes(sources, split, errors);
  }
};

class Pool {
 public:
  Pool(const std::vector<std::size_t>& tasks, const PoolOptions& options)
      : options_(options), waiting_(tasks.begin(), tasks.end()) {}

  PoolOutcome run() {
    while (!is_over()) {
      if (!ending_ && options_.stop && options_.stop()) {
        outcome_.stopped = true;
        end_all();
      }
      if (!ending_) hand_out();
      if (!ending_ && waiting_.empty() && busy_.empty() && working() == 0) dismiss();
      listen();
      bury();
    }
    return std::move(outcome_);
  }

 private:
  bool is_over() const { return workers_.empty() && (ending_ || (waiting_.empty() && busy_.empty())); }
  std::size_t working() const {
    return static_cast<std::size_t>(
        std::count_if(workers_.begin(), workers_.end(), [](const auto& w) { return w->task.has_value(); }));
  }

  void hand_out() {
    while (!busy_.empty() && busy_.front().first <= Clock::now()) {
      waiting_.push_back(busy_.front().second);
      busy_.pop_front();
    }
    const auto most = static_cast<std::size_t>(options_.processes);
    while (workers_.size() < most && workers_.size() < waiting_.size() + working()) start();
    for (const auto& worker : workers_) {
      if (worker->task || worker->silent || waiting_.empty()) continue;
      const std::string line = fmt::format("{}\n", waiting_.front());
      // A failed write means that it has ended, which bury() handles.
      if (write_all(worker->child.input.get(), line.data(), line.size()) != 0) continue;
      worker->task = waiting_.front();
      waiting_.pop_front();
    }
  }

  void start() {
    auto worker = std::make_unique<Worker>([this](Worker& from, std::string_view line) { hear(from, line); });
    if (const int reason = worker->child.start(options_.worker); reason != 0) {
      throw Error(ErrorKind::file, options_.worker.front(),
                  fmt::format("cannot be started: {}; try fewer --jobs", system_reason(reason)));
    }
    workers_.push_back(std::move(worker));
  }

  // "3 done", "note …".
  void hear(Worker& worker, std::string_view line) {
    if (line.starts_with("note ")) {
      const std::string text(line.substr(5));
      if (notes_.insert(text).second && options_.note) options_.note(text);
      return;
    }
    std::size_t task = 0;
    const auto [end, failure] = std::from_chars(line.data(), line.data() + line.size(), task);
    if (failure != std::errc() || worker.task != task || end == line.data() + line.size()) return;
    const auto ending = ending_of(line.substr(static_cast<std::size_t>(end - line.data()) + 1));
    if (!ending || *ending == TaskEnding::stopped) return;  // it ends, too
    worker.task.reset();
    if (*ending == TaskEnding::busy) {
      busy_.emplace_back(Clock::now() + kBusyPause, task);
    } else if (options_.ended) {
      options_.ended(task, *ending);
    }
  }

  void listen() {
    std::vector<pollfd> sources;
    for (const auto& worker : workers_) {
      sources.push_back({worker->silent ? -1 : worker->child.output.get(), POLLIN, 0});
      sources.push_back({worker->silent ? -1 : worker->child.errors.get(), POLLIN, 0});
    }
    if (::poll(sources.data(), sources.size(), kPollMs) <= 0) return;
    for (std::size_t i = 0; i < workers_.size(); ++i) {
      Worker& worker = *workers_[i];
      if (worker.silent) continue;
      const std::span<pollfd> own(sources.data() + 2 * i, 2);
      worker.read(own);
      worker.silent = own[0].fd < 0 || own[1].fd < 0;
    }
  }

  // What is in the pipes of a process that has ended.
  static void hear_out(Worker& worker) {
    std::array<pollfd, 2> sources = {
        {{worker.child.output.get(), POLLIN, 0}, {worker.child.errors.get(), POLLIN, 0}}};
    while ((sources[0].fd >= 0 || sources[1].fd >= 0) && ::poll(sources.data(), sources.size(), 0) > 0)
      worker.read(sources);
    worker.lines.finish();
  }

  void bury() {
    for (std::size_t i = workers_.size(); i-- > 0;) {
      Worker& worker = *workers_[i];
      if (!worker.child.has_ended()) continue;
      hear_out(worker);
      settle(worker);
      workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }

  void settle(Worker& worker) {
    const int status = worker.child.exit_status();
    if (status > 0 && !options_.stopped.contains(status)) {
      if (!ending_) {
        outcome_.failure = status;
        outcome_.message = worker.errors.text();
      }
      return end_all();
    }
    if (!worker.task) return;
    waiting_.push_front(*worker.task);
    if (status >= 0 || ending_ || ++kills_[*worker.task] < kMostKills) return;
    outcome_.error.emplace(ErrorKind::file, fmt::format("task {}", *worker.task),
                           fmt::format("its process ended by {}, {} times; was there enough memory?",
                                       worker.child.ending(), kMostKills));
    end_all();
  }

  void dismiss() {
    for (const auto& worker : workers_) worker->child.input.close();
  }

  void end_all() {
    // Once: a second signal would kill those that write their checkpoints.
    if (std::exchange(ending_, true)) return;
    for (const auto& worker : workers_) worker->child.signal(SIGTERM);
    dismiss();
  }

  const PoolOptions& options_;
  std::deque<std::size_t> waiting_;
  std::deque<std::pair<Clock::time_point, std::size_t>>
      busy_;  // locked by another process; when to try again
  std::vector<std::unique_ptr<Worker>> workers_;
  std::map<std::size_t, int> kills_;
  std::set<std::string> notes_;
  bool ending_ = false;
  PoolOutcome outcome_;
};

}  // namespace

PoolOutcome run_pool(const std::vector<std::size_t>& tasks, const PoolOptions& options) {
  return Pool(tasks, options).run();
}

}  // namespace pabd
