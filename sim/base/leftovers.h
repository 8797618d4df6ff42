// SPDX-License-Identifier: MIT
// What must not outlive the program: temporary files and the programs that it started. Objects register them;
// whoever has to leave without running destructors, such as a signal's handler, removes them.
#pragma once

#include <sys/types.h>

#include <filesystem>

namespace pabd {

// Registered while it lives. Beyond a few hundred at a time, and for names longer than the system allows,
// nothing is registered.
class Leftover {
 public:
  Leftover() = default;
  explicit Leftover(const std::filesystem::path& file);  // to be unlinked
  explicit Leftover(pid_t group);                        // of processes, to be killed
  ~Leftover() { release(); }
  Leftover(Leftover&& other) noexcept;
  Leftover& operator=(Leftover&& other) noexcept;
  void release();

 private:
  int slot_ = -1;
};

// Kills and unlinks what is registered. May be called from a signal's handler and from any thread.
void remove_leftovers() noexcept;

}  // namespace pabd
