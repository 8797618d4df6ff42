// SPDX-License-Identifier: MIT
// A team of threads for loops over independent items. The result does not depend on the number of threads,
// nor on which thread does what: every item writes only its own entries, and sums are made afterwards in
// order.
//
// Members work with denormals flushed (flush_denormals.h); the caller keeps its own setting.
//
// The caller works too and never waits for a thread that has not begun, so that a loop on a busy machine takes no longer than
// alone (with OpenMP 3 to 9 times as long). Idle members spin for some microseconds, then sleep.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>

namespace pabd {

// When a loop is worth sharing: to wake another thread may take longer than the work.
struct Sharing {
  std::size_t least_blocks = 8;  // a loop of fewer is done in order on the calling thread
  std::size_t largest_block = std::numeric_limits<std::size_t>::max();  // no loop takes more items at a time
  // For tests of what depends on threads or order: nobody begins before all have come, and a shared loop goes
  // from its end to its start. Slow.
  bool contrary = false;
};

class Team {
 public:
  Team();
  explicit Team(const Sharing& sharing);
  ~Team();
  Team(Team&&) noexcept;
  Team& operator=(Team&&) noexcept;

  // Is a loop over `count` items, `block` at a time, shared by up to `threads` threads?
  bool shares(int threads, std::size_t count, std::size_t block) const {
    return threads > 1 && count >= sharing_.least_blocks * std::min(block, sharing_.largest_block);
  }

  // For loops that fill a bucket a range of items: how many ranges to cut `count` items into, 1 when it is
  // not worth sharing.
  std::size_t ranges(int threads, std::size_t count, std::size_t block) const {
    return shares(threads, count, block) ? 4 * static_cast<std::size_t>(threads) : 1;
  }

  // Calls body(k) for k = 0 … count − 1 on up to `threads` threads, each taking `block` at a time; threads
  // are started when first needed. What `body` throws is thrown here.
  template <class Body>
  void for_each(int threads, std::size_t count, std::size_t block, const Body& body) {
    run(shares(threads, count, block), threads, count, block, body);
  }

  // The same one by one, for few large items: `pays` is for the caller to know.
  template <class Body>
  void for_each_large(int threads, std::size_t count, bool pays, const Body& body) {
    run(threads > 1 && count > 1 && pays, threads, count, 1, body);
  }

 private:
  struct Loop {
    void (*run)(const void* body, std::size_t begin, std::size_t end);
    const void* body;
    std::size_t count, block;
  };
  struct Shared;

  template <class Body>
  void run(bool shared, int threads, std::size_t count, std::size_t block, const Body& body) {
    if (!shared) {
      for (std::size_t k = 0; k < count; ++k) body(k);
      return;
    }
    share(threads, {[](const void* f, std::size_t begin, std::size_t end) {
                      for (std::size_t k = begin; k < end; ++k) (*static_cast<const Body*>(f))(k);
                    },
                    &body, count, std::min(block, sharing_.largest_block)});
  }
  void share(int threads, const Loop& loop);

  Sharing sharing_;
  std::unique_ptr<Shared> shared_;
};

}  // namespace pabd
