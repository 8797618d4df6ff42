// SPDX-License-Identifier: MIT
// SIGINT, SIGTERM and SIGHUP: the first asks the run to end at the next whole frame or step. What comes
// within a second after it is the same request ('timeout' and terminals send it twice); what comes later ends
// the program at once. No temporary file is left behind either way; the folder of 'pabd serve' is, at once.
#pragma once

namespace pabd::cli {

// For the whole program, once, at its start: a signal that nobody waits for removes what is temporary and
// ends the program. A signal that the program was told to ignore (nohup) stays ignored.
void install_signal_handlers();

// While it lives signals are requests; only one at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  bool requested() const;  // from any thread
  int exit_code() const;   // 130, 143 or 129 when requested, 0 otherwise
};

}  // namespace pabd::cli
