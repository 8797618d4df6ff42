// The flag that the signal handler sets.
#include "app/cli/interrupt.h"

#include <unistd.h>

#include <atomic>
#include <csignal>

namespace pabd::cli {
namespace {

// A handler has no argument to pass state through: this is the one place of the program with file-level
// state.
std::atomic<int> received{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

// Unfinished output lies under temporary names only, so that leaving at once truncates nothing.
extern "C" void on_signal(int signal) {
  int none = 0;
  if (!received.compare_exchange_strong(none, signal)) ::_exit(128 + signal);
}

}  // namespace

InterruptGuard::InterruptGuard() {
  received = 0;
  struct sigaction action = {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

InterruptGuard::~InterruptGuard() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool InterruptGuard::requested() const { return received != 0; }

int InterruptGuard::exit_code() const { return received == 0 ? 0 : 128 + received; }

}  // namespace pabd::cli
