// SPDX-License-Identifier: MIT
// Temporary files and child processes, registered so that code which leaves without running destructors, such as a signal
// handler, can remove them.
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
