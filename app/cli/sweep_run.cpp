// SPDX-License-Identifier: MIT
// See sweep_run.h.
#include "app/cli/sweep_run.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <chrono>
#include <csignal>
#include <map>
#include <thread>

#include "app/cli/exit_code.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/cli/streams.h"
#include "app/sweep/pool.h"
#include "app/sweep/task_folder.h"
#include "sim/base/child_process.h"
#include "sim/base/counted.h"
#include "sim/base/error.h"

namespace pabd::cli {
namespace {

constexpr auto kBusyPause = std::chrono::milliseconds(250);
constexpr int kPollMs = 100;

// What became of tasks, so far.
class Tally {
 public:
  Tally(std::size_t total, bool quiet)
      : quiet_(quiet),
        start_(std::chrono::steady_clock::now()),
        progress_("task", static_cast<std::int64_t>(total), !quiet) {}

  void add(TaskEnding ending) {
    ++counts_[ending];
    ++sum_;
    progress_.update(sum_, remarkable());
  }
  void note(const std::string& text) const {
    if (!quiet_) write_note("pabd: note: " + text);
  }

  // "12 tasks: 10 done, 1 diverged, 1 refused; 3.2 s"
  std::string summary(std::size_t before) const {
    std::string words;
    for (const auto& [ending, count] : counts_)
      words += fmt::format("{}{} {}", words.empty() ? ": " : ", ", count, to_string(ending));
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    return fmt::format("{}{}{} · {:.1f} s\n", counted(sum_, "task"), words,
                       before > 0 ? fmt::format(" · {} done before", before) : "", seconds);
  }

 private:
  std::string remarkable() const {
    std::string out;
    for (const TaskEnding ending : {TaskEnding::diverged, TaskEnding::refused}) {
      const auto found = counts_.find(ending);
      if (found != counts_.end())
        out += fmt::format("{}{} {}", out.empty() ? "" : "  ", found->second, to_string(ending));
    }
    return out;
  }

  bool quiet_;
  std::chrono::steady_clock::time_point start_;
  Progress progress_;
  std::map<TaskEnding, std::int64_t> counts_;
  std::int64_t sum_ = 0;
};

std::string no_picture_note(const std::string& why) { return "no pictures of the ends: " + why; }

// Of those tasks. Empty: all are acceptable.
std::string faults_note(const SweepWork& work, const std::vector<std::size_t>& tasks) {
  std::size_t faulty = 0;
  std::string first;
  for (const std::size_t i : tasks) {
    const std::string faults = faults_of(work.folder, work.tasks[i]);
    if (!faults.empty() && faulty++ == 0) first = fmt::format("in task {} {}", work.tasks[i].index, faults);
  }
  if (faulty == 0) return "";
  return fmt::format("{} of {} {} not acceptable: {}{}", faulty, counted(tasks.size(), "task"),
                     faulty == 1 ? "is" : "are", first,
                     faulty == 1 ? "" : "; 'pabd sweep collect' tells all");
}

// False: it was stopped.
bool do_here(const SweepWork& work, const std::vector<std::size_t>& tasks, const InterruptGuard& interrupt,
             Tally& tally) {
  SweepWorker worker(work.plan, work.folder, {work.threads, 10, [&] { return interrupt.requested(); }});
  bool noted = false;
  for (const std::size_t i : tasks) {
    TaskEnding ending = TaskEnding::stopped;
    while (!interrupt.requested()) {
      ending = worker.run(work.tasks[i]);
      if (ending != TaskEnding::busy) break;
      std::this_thread::sleep_for(kBusyPause);
    }
    if (!has_result(ending)) return false;
    if (!noted && !worker.no_picture().empty()) tally.note(no_picture_note(worker.no_picture()));
    noted = !worker.no_picture().empty();
    tally.add(ending);
  }
  return true;
}

// A line of standard input; empty at its end, or when the program is asked to end.
class InputLines {
 public:
  explicit InputLines(const InterruptGuard& interrupt)
      : interrupt_(interrupt), splitter_([this](std::string_view line) { lines_.emplace_back(line); }) {}

  std::optional<std::string> next() {
    while (at_ == lines_.size()) {
      if (over_ || interrupt_.requested()) return std::nullopt;
      pollfd source = {STDIN_FILENO, POLLIN, 0};
      if (::poll(&source, 1, kPollMs) <= 0) continue;
      std::array<char, 4096> text;
      const ssize_t n = read_some(STDIN_FILENO, text.data(), text.size());
      over_ = n <= 0;
      over_ ? splitter_.finish() : splitter_.append(text.data(), static_cast<std::size_t>(n));
    }
    return lines_[at_++];
  }

 private:
  const InterruptGuard& interrupt_;
  LineSplitter splitter_;
  std::vector<std::string> lines_;
  std::size_t at_ = 0;
  bool over_ = false;
};

}  // namespace

std::filesystem::path own_program() {
  std::error_code failure;
  const auto path = std::filesystem::read_symlink("/proc/self/exe", failure);
  if (failure) throw Error(ErrorKind::file, "/proc/self/exe", "cannot be read: " + failure.message());
  return path;
}

int do_tasks(const SweepWork& work, const std::vector<std::size_t>& chosen) {
  std::vector<std::size_t> open;
  for (const std::size_t i : chosen)
    if (!is_done(work.folder, work.tasks[i])) open.push_back(i);
  const std::size_t before = chosen.size() - open.size();
  const InterruptGuard interrupt;
  bool stopped = false;
  std::string summary;
  {
    Tally tally(open.size(), work.quiet);
    if (work.processes > 1 && open.size() > 1) {
      PoolOptions options;
      options.worker = {own_program().string(),
                        "sweep",
                        work.plan_file,
                        "-o",
                        work.folder.string(),
                        "--task",
                        "-",
                        "--threads",
                        std::to_string(work.threads),
                        "--quiet"};
      options.processes = work.processes;
      // The latter where a signal for all of them came while one was starting.
      options.stopped = {kCheckpointed, 128 + SIGHUP, 128 + SIGINT, 128 + SIGTERM};
      options.stop = [&] { return interrupt.requested(); };
      options.ended = [&](std::size_t, TaskEnding ending) { tally.add(ending); };
      options.note = [&](const std::string& text) { tally.note(text); };
      const PoolOutcome outcome = run_pool(open, options);
      if (outcome.error) throw *outcome.error;
      if (outcome.failure != 0) {
        write_stderr(outcome.message);
        return outcome.failure;
      }
      stopped = outcome.stopped;
    } else {
      stopped = !do_here(work, open, interrupt, tally);
    }
    summary = tally.summary(before);
  }
  if (!work.quiet) {
    write_stderr(summary);
    const std::string faults = faults_note(work, open);
    if (!faults.empty()) write_note("pabd: note: " + faults);
  }
  if (stopped && !work.quiet) write_note("pabd: stopped, with checkpoints; the same command goes on");
  return stopped ? kCheckpointed : kDone;
}

int do_tasks_told(const SweepWork& work) {
  const InterruptGuard interrupt;
  SweepWorker worker(work.plan, work.folder, {work.threads, 10, [&] { return interrupt.requested(); }});
  InputLines lines(interrupt);
  bool noted = false;
  while (const auto line = lines.next()) {
    std::size_t i = 0;
    const char* end = line->data() + line->size();
    const auto [at, failure] = std::from_chars(line->data(), end, i);
    if (failure != std::errc() || at != end || i >= work.tasks.size())
      throw Error(ErrorKind::bad_input, "standard input",
                  fmt::format("expected the index of a task, 0 … {}, a line, got \"{}\"",
                              work.tasks.size() - 1, *line));
    const TaskEnding ending = worker.run(work.tasks[i]);
    if (!noted && !worker.no_picture().empty()) {
      write_stdout("note " + no_picture_note(worker.no_picture()) + "\n");
      noted = true;
    }
    write_stdout(fmt::format("{} {}\n", i, to_string(ending)));
    if (ending == TaskEnding::stopped) return kCheckpointed;
  }
  return interrupt.requested() ? kCheckpointed : kDone;
}

}  // namespace pabd::cli
