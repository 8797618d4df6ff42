// SPDX-License-Identifier: MIT
#include "sim/base/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <utility>

namespace pabd {
namespace {

constexpr std::size_t kKept = 4096;
constexpr int kPollMs = 100;

struct Pipe {
  Descriptor read, write;
};

// Both ends above the standard three, so that placing them in the child cannot overwrite one with another.
// Returns 0 or errno.
int open_pipe(Pipe& pipe) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return errno;
  const Descriptor low_read(ends[0]), low_write(ends[1]);
  pipe.read = Descriptor(::fcntl(low_read.get(), F_DUPFD_CLOEXEC, 3));
  pipe.write = Descriptor(::fcntl(low_write.get(), F_DUPFD_CLOEXEC, 3));
  return pipe.read.get() < 0 || pipe.write.get() < 0 ? errno : 0;
}

// With these descriptors as 0, 1 and 2, and the signals as a program finds them that nobody started
// specially.
int spawn(pid_t& pid, const std::vector<std::string>& arguments, const std::array<int, 3>& descriptors) {
  std::vector<char*> argv;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);

  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  for (int i = 0; i < 3; ++i)
    posix_spawn_file_actions_adddup2(&files, descriptors[static_cast<std::size_t>(i)], i);

  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes,
                           POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  posix_spawnattr_setpgroup(&attributes, 0);
  sigset_t signals;
  sigemptyset(&signals);
  posix_spawnattr_setsigmask(&attributes, &signals);
  for (int signal : {SIGPIPE, SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGCHLD, SIGXFSZ})
    sigaddset(&signals, signal);
  posix_spawnattr_setsigdefault(&attributes, &signals);

  const int reason = ::posix_spawnp(&pid, argv[0], &files, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return reason;
}

}  // namespace

int ChildProcess::start(const std::vector<std::string>& arguments) {
  Pipe in, out, err;
  for (Pipe* pipe : {&in, &out, &err}) {
    if (const int reason = open_pipe(*pipe)) return reason;
  }
  const int reason = spawn(pid_, arguments, {in.read.get(), out.write.get(), err.write.get()});
  if (reason != 0) {
    pid_ = -1;
    return reason;
  }
  leftover_ = Leftover(pid_);
  input = std::move(in.write);
  output = std::move(out.read);
  errors = std::move(err.read);
  return 0;
}

bool ChildProcess::has_ended() {
  if (ended_ || pid_ < 0) return true;
  siginfo_t info = {};
  // Its number stays taken until the group is ended as well.
  const int seen = ::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT);
  if (seen == 0 && info.si_pid == 0) return false;
  if (seen != 0 && errno == EINTR) return false;
  ::kill(-pid_, SIGKILL);
  leftover_.release();
  ended_ = true;
  // A failure: somebody else in this program took the status.
  while (::waitpid(pid_, &status_, 0) < 0) {
    if (errno == EINTR) continue;
    status_ = -1;
    break;
  }
  return true;
}

void ChildProcess::end() {
  if (has_ended()) return;
  ::kill(-pid_, SIGKILL);
  siginfo_t info = {};
  while (::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOWAIT) != 0 && errno == EINTR) {
  }
  has_ended();
}

void ChildProcess::signal(int number) {
  if (!has_ended()) ::kill(pid_, number);
}

std::string ChildProcess::ending() const {
  if (status_ != -1 && WIFEXITED(status_)) return fmt::format("status {}", WEXITSTATUS(status_));
  if (status_ != -1 && WIFSIGNALED(status_)) return fmt::format("signal {}", WTERMSIG(status_));
  return "unknown status";
}

int ChildProcess::exit_status() const {
  return status_ != -1 && WIFEXITED(status_) ? WEXITSTATUS(status_) : -1;
}

int ChildProcess::ending_signal() const {
  return status_ != -1 && WIFSIGNALED(status_) ? WTERMSIG(status_) : 0;
}

void Tail::append(const char* text, std::size_t size) {
  text_.append(text, size);
  if (text_.size() > kKept) text_.erase(0, text_.size() - kKept);
}

void LineSplitter::append(const char* text, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    if (text[i] == '\n') {
      line_(begun_);
      begun_.clear();
    } else if (begun_.size() < kKept) {
      begun_ += text[i];
    }
  }
}

void LineSplitter::finish() {
  if (!begun_.empty()) line_(begun_);
  begun_.clear();
}

bool read_pipes(std::span<pollfd> sources, const std::function<void(std::string_view)>& output, Tail& tail) {
  std::array<char, 4096> text;
  bool received = false;
  for (std::size_t i = 0; i < 2; ++i) {
    if (sources[i].fd < 0 || sources[i].revents == 0) continue;
    const ssize_t n = ::read(sources[i].fd, text.data(), text.size());
    if (n < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    received = true;
    if (n <= 0) {
      sources[i].fd = -1;
    } else if (i == 0) {
      output({text.data(), static_cast<std::size_t>(n)});
    } else {
      tail.append(text.data(), static_cast<std::size_t>(n));
    }
  }
  return received;
}

ChildOutcome run_child(const std::vector<std::string>& arguments, double patience,
                       const std::function<void(std::string_view)>& line, double longest) {
  using Clock = std::chrono::steady_clock;
  ChildOutcome outcome;
  ChildProcess child;
  if (child.start(arguments) != 0) return outcome;
  outcome.found = true;
  child.input.close();
  LineSplitter lines(line);
  const auto split = [&](std::string_view bytes) { lines.append(bytes.data(), bytes.size()); };
  Tail tail;
  std::array<pollfd, 2> sources = {{{child.output.get(), POLLIN, 0}, {child.errors.get(), POLLIN, 0}}};
  const auto start = Clock::now();
  for (auto last = start; sources[0].fd >= 0 || sources[1].fd >= 0;) {
    // What it said before it ended is in the pipes; nobody else is there to say more.
    const bool over = child.has_ended();
    const int ready = ::poll(sources.data(), sources.size(), over ? 0 : kPollMs);
    if (ready < 0 && errno != EINTR) break;
    if (ready <= 0 && over) break;
    if (ready > 0 && read_pipes(sources, split, tail)) last = Clock::now();
    const auto seconds_since = [](Clock::time_point t) {
      return std::chrono::duration<double>(Clock::now() - t).count();
    };
    if (seconds_since(last) > patience || seconds_since(start) > longest) {
      outcome.too_slow = true;
      break;
    }
  }
  lines.finish();
  while (!outcome.too_slow && !child.has_ended()) {  // it closed its output before its end
    static constexpr timespec pause = {0, 5'000'000};
    ::nanosleep(&pause, nullptr);
    patience -= 0.005;
    outcome.too_slow = patience < 0;
  }
  child.end();
  outcome.status = child.exit_status();
  outcome.signal = child.ending_signal();
  outcome.errors = tail.text();
  return outcome;
}

}  // namespace pabd
