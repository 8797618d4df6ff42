// SIGINT and SIGTERM: the first asks the run to end at the next whole frame or step, the second ends it at
// once.
#pragma once

namespace pabd::cli {

// Installed while it lives; only one at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  bool requested() const;  // from any thread
  int exit_code() const;   // 130 or 143 when requested, 0 otherwise
};

}  // namespace pabd::cli
