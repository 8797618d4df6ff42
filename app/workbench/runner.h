// SPDX-License-Identifier: MIT
// The Workbench in a thread of its own: commands go in, snapshots come out; the user interface never waits for a step.
//
//   UI thread                         simulation's thread
//   send(command) ──→ queue ──→ Workbench::apply / advance, at the pace asked for
//   latest()      ←── snapshot ←─┘  a new one after every change that somebody will look at
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <future>
#include <memory>
#include <mutex>
#include <thread>
#include <variant>

#include "app/workbench/workbench.h"

namespace pabd {

// Copies of both runs: their pasts and where they are. States are shared.
struct RunCopies {
  Run a;
  std::optional<Run> b;
};

class Runner {
 public:
  explicit Runner(std::unique_ptr<Workbench> workbench);
  ~Runner();  // ends the thread, in the middle of a step if need be
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  // Carried out in order. What goes wrong becomes a message in a later snapshot.
  void send(Command command);

  // The newest snapshot; never waits for a step. Rethrows what ended the thread.
  std::shared_ptr<const Snapshot> latest();

  // Ends the thread, in the middle of a step if need be; callers that wait in settle() or for copies continue.
  void stop();

  // Copies of the runs, after everything sent so far; the future is broken when the thread ends before.
  std::future<RunCopies> copy_runs();

  // Waits until everything sent so far is carried out; the result shows it. While playing that takes the rest
  // of a step, and the simulation is ahead of it.
  std::shared_ptr<const Snapshot> settle();

 private:
  using Clock = std::chrono::steady_clock;
  using Job = std::variant<Command, std::promise<RunCopies>>;

  void work();
  bool wait_for_work(std::deque<Job>& jobs);
  bool keep_pace(Clock::time_point now);
  void carry_out(const Command& command);
  RunCopies copies() const;
  void publish();
  bool look_at_file(Clock::time_point now);

  std::unique_ptr<Workbench> workbench_;  // the thread's own

  std::mutex mutex_;
  std::condition_variable wake_, settled_;
  std::deque<Job> queue_;
  std::shared_ptr<const Snapshot> latest_;
  bool taken_ = true;  // the latest snapshot was taken: another one is wanted
  bool busy_ = false;
  std::atomic<bool> stop_ = false;
  std::exception_ptr failure_;

  // Pace: the thread's own.
  Clock::time_point due_{};  // of the next step
  Clock::time_point measured_from_{};
  double simulated_ = 0, real_time_factor_ = 0;
  bool was_playing_ = false;
  bool stale_ = false;             // the latest snapshot is not all there is
  Clock::time_point next_look_{};  // at the scene's file

  std::thread thread_;
};

}  // namespace pabd
