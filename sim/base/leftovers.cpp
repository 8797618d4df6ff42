// SPDX-License-Identifier: MIT
// See leftovers.h. A handler has no argument to pass state through and may neither lock nor allocate: this
// table in static storage is what it can look at.
#include "sim/base/leftovers.h"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <cstring>
#include <utility>

namespace pabd {
namespace {

enum Kind : int { unused, taken, file, group };

struct Slot {
  std::atomic<int> kind{unused};
  pid_t group = 0;
  char file[PATH_MAX] = "";
};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

std::array<Slot, 256> slots;

int take_slot() {
  for (std::size_t i = 0; i < slots.size(); ++i) {
    int free = unused;
    if (slots[i].kind.compare_exchange_strong(free, taken)) return static_cast<int>(i);
  }
  return -1;
}

Slot& slot_at(int i) { return slots[static_cast<std::size_t>(i)]; }

}  // namespace

Leftover::Leftover(const std::filesystem::path& file) {
  std::error_code failed;
  // The program may have gone to another folder by then.
  const std::string name = std::filesystem::absolute(file, failed).string();
  if (failed || name.size() >= PATH_MAX || (slot_ = take_slot()) < 0) return;
  std::memcpy(slot_at(slot_).file, name.c_str(), name.size() + 1);
  slot_at(slot_).kind = Kind::file;
}

Leftover::Leftover(pid_t group) {
  if (group <= 1 || (slot_ = take_slot()) < 0) return;
  slot_at(slot_).group = group;
  slot_at(slot_).kind = Kind::group;
}

Leftover::Leftover(Leftover&& other) noexcept : slot_(std::exchange(other.slot_, -1)) {}

Leftover& Leftover::operator=(Leftover&& other) noexcept {
  if (this != &other) {
    release();
    slot_ = std::exchange(other.slot_, -1);
  }
  return *this;
}

void Leftover::release() {
  if (slot_ >= 0) slot_at(std::exchange(slot_, -1)).kind = unused;
}

void remove_leftovers() noexcept {
  for (Slot& slot : slots) {
    if (slot.kind == group) ::kill(-slot.group, SIGKILL);
  }
  for (Slot& slot : slots) {
    if (slot.kind == file) ::unlink(slot.file);
  }
}

}  // namespace pabd
