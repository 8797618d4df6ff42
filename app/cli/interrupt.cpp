// SPDX-License-Identifier: MIT
// The flag that the signal handler sets.
#include "app/cli/interrupt.h"

#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <ctime>

#include "app/cli/exit_code.h"
#include "sim/base/leftovers.h"

namespace pabd::cli {
namespace {

constexpr std::int64_t kSameRequest = 1'000'000'000;  // ns

// A handler has no argument to pass state through: beside the table of leftovers this is the one place of the
// program with file-level state.
std::atomic<bool> waited_for{false};  // a guard lives
std::atomic<int> received{0};
std::atomic<std::int64_t> received_at{0};  // ns
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<std::int64_t>::is_always_lock_free,
              "a signal handler may only touch lock-free atomics");

std::int64_t now() {
  timespec time = {};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

extern "C" void on_request(int signal) {
  const int kept = errno;
  if (waited_for) {
    int none = 0;
    const std::int64_t time = now();
    if (received.compare_exchange_strong(none, signal)) {
      received_at = time;
      errno = kept;
      return;
    }
    if (time - received_at < kSameRequest) {
      errno = kept;
      return;
    }
  }
  remove_leftovers();
  ::_exit(128 + signal);
}

// Ctrl-\, a limit of time or a stray signal: the default follows.
extern "C" void on_stray(int signal) {
  remove_leftovers();
  ::raise(signal);
}

// A driver that finds no memory crashes, too. Where core dumps are wanted, the default follows.
extern "C" void on_crash(int signal) {
  static constexpr char kLine[] =
      "pabd: error: the program crashed; where memory is limited (ulimit -v, containers), allow more; "
      "else please report the command line, the scene file and 'pabd doctor'\n";
  remove_leftovers();
  static_cast<void>(!::write(STDERR_FILENO, kLine, sizeof kLine - 1));
  rlimit core = {};
  if (::getrlimit(RLIMIT_CORE, &core) == 0 && core.rlim_cur == 0) ::_exit(exit_code(ErrorKind::defect));
  ::raise(signal);
}

void handle(int signal, void (*handler)(int), int flags) {
  struct sigaction before = {};
  if (sigaction(signal, nullptr, &before) != 0) return;
  // Somebody else's handler (a sanitizer's) is respected, and nohup. What a script starts in the background
  // ignores SIGINT without anybody's wish.
  const bool unasked = before.sa_handler == SIG_IGN && signal != SIGHUP;
  if (before.sa_handler != SIG_DFL && !unasked) return;
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

}  // namespace

void install_signal_handlers() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) handle(signal, on_request, SA_RESTART);
  for (const int signal : {SIGQUIT, SIGUSR1, SIGUSR2, SIGALRM, SIGVTALRM, SIGPROF, SIGXCPU})
    handle(signal, on_stray, static_cast<int>(SA_RESETHAND));
  for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGSYS, SIGTRAP})
    handle(signal, on_crash, static_cast<int>(SA_RESETHAND));
}

InterruptGuard::InterruptGuard() {
  received = 0;
  waited_for = true;
}

InterruptGuard::~InterruptGuard() { waited_for = false; }

bool InterruptGuard::requested() const { return received != 0; }

int InterruptGuard::exit_code() const { return received == 0 ? 0 : 128 + received; }

}  // namespace pabd::cli
