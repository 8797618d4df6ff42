// SPDX-License-Identifier: MIT
// See runner.h.
#include "app/workbench/runner.h"

#include <algorithm>

#include "sim/base/error.h"

namespace pabd {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr Seconds kForgiven{0.1};  // further behind than this is not caught up
constexpr Seconds kMeasured{0.5};  // the real-time factor is a mean over as much
constexpr Seconds kIdle{0.5};

}  // namespace

Runner::Runner(std::unique_ptr<Workbench> workbench) : workbench_(std::move(workbench)) {
  workbench_->stop_when([this] { return stop_.load(); });
  publish();
  thread_ = std::thread([this] {
    try {
      work();
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      failure_ = std::current_exception();
      busy_ = false;
      settled_.notify_all();
    }
  });
}

Runner::~Runner() {
  stop();
  thread_.join();
}

void Runner::stop() {
  {
    const std::scoped_lock lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  settled_.notify_all();
}

void Runner::send(Command command) {
  {
    const std::scoped_lock lock(mutex_);
    queue_.push_back(std::move(command));
  }
  wake_.notify_all();
}

std::future<RunCopies> Runner::copy_runs() {
  std::future<RunCopies> out;
  {
    const std::scoped_lock lock(mutex_);
    if (failure_) std::rethrow_exception(failure_);
    std::promise<RunCopies> promise;
    out = promise.get_future();
    queue_.emplace_back(std::move(promise));
  }
  wake_.notify_all();
  return out;
}

std::shared_ptr<const Snapshot> Runner::latest() {
  bool wanted = false;
  std::shared_ptr<const Snapshot> out;
  {
    const std::scoped_lock lock(mutex_);
    if (failure_) std::rethrow_exception(failure_);
    wanted = !std::exchange(taken_, true);
    out = latest_;
  }
  if (wanted) wake_.notify_all();
  return out;
}

std::shared_ptr<const Snapshot> Runner::settle() {
  std::unique_lock lock(mutex_);
  settled_.wait(lock, [&] { return failure_ || stop_ || (queue_.empty() && !busy_); });
  if (failure_) std::rethrow_exception(failure_);
  taken_ = true;
  return latest_;
}

void Runner::work() {
  std::deque<Job> jobs;
  while (wait_for_work(jobs)) {
    for (Job& job : jobs) {
      if (const auto* command = std::get_if<Command>(&job)) {
        carry_out(*command);
      } else {
        std::get<std::promise<RunCopies>>(job).set_value(copies());
      }
    }
    const bool asked = !jobs.empty();
    bool changed = asked;
    jobs.clear();
    if (keep_pace(Clock::now())) {
      workbench_->advance();
      changed = true;
    }
    if (look_at_file(Clock::now())) changed = true;
    if (changed) stale_ = true;
    bool wanted = false;
    {
      const std::scoped_lock lock(mutex_);
      wanted = taken_;
    }
    // At rest, and after commands, every change is shown; in motion only what somebody will see.
    if (stale_ && (wanted || asked || !workbench_->playing())) publish();
  }
}

// False when it is time to stop.
bool Runner::wait_for_work(std::deque<Job>& jobs) {
  std::unique_lock lock(mutex_);
  const auto ready = [&] { return stop_ || !queue_.empty(); };
  if (queue_.empty()) {
    busy_ = false;
    settled_.notify_all();
  }
  if (!workbench_->playing()) {
    wake_.wait_for(lock, kIdle, ready);
  } else if (due_ > Clock::now()) {
    wake_.wait_until(lock, due_, ready);
  }
  jobs.swap(queue_);
  if (!jobs.empty()) busy_ = true;
  return !stop_;
}

RunCopies Runner::copies() const {
  RunCopies out{workbench_->run().fork(), {}};
  if (workbench_->comparing()) out.b.emplace(workbench_->run(Side::b).fork());
  return out;
}

// Whether a step is due now; measures how fast the simulation goes.
bool Runner::keep_pace(Clock::time_point now) {
  const bool playing = workbench_->playing();
  if (!playing || !was_playing_) {
    was_playing_ = playing;
    due_ = measured_from_ = now;
    simulated_ = real_time_factor_ = 0;
    if (!playing) return false;
  }
  if (now < due_) return false;
  const double h = workbench_->run().params().h;
  const double speed = workbench_->speed();
  const auto wall = std::chrono::duration_cast<Clock::duration>(Seconds(speed > 0 ? h / speed : 0));
  due_ = std::max(due_ + wall, now - std::chrono::duration_cast<Clock::duration>(kForgiven));
  simulated_ += h;
  if (const Seconds passed = now - measured_from_; passed > kMeasured) {
    real_time_factor_ = simulated_ / passed.count();
    measured_from_ = now;
    simulated_ = 0;
  }
  return true;
}

void Runner::carry_out(const Command& command) {
  try {
    workbench_->apply(command);
  } catch (const Error& error) {
    workbench_->tell(Severity::error, error.what(),
                     std::visit([](const auto& c) { return std::string(c.name); }, command), error.kind());
  }
}

// Whether a scene changed on disk is told, not acted on.
bool Runner::look_at_file(Clock::time_point now) {
  if (now < next_look_) return false;
  next_look_ = now + std::chrono::duration_cast<Clock::duration>(kIdle);
  return workbench_->look_at_file();
}

void Runner::publish() {
  auto snapshot = std::make_shared<Snapshot>(workbench_->snapshot());
  snapshot->real_time_factor = real_time_factor_;
  stale_ = false;
  const std::scoped_lock lock(mutex_);
  latest_ = std::move(snapshot);
  taken_ = false;
}

}  // namespace pabd
