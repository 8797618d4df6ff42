// A team of threads for loops over independent items. The result does not depend on the number of threads,
// nor on which thread does what: every item writes only its own entries, and sums are made afterwards in
// order.
//
// The caller works too and waits for no one who has not begun: on a machine with other work a loop takes no
// longer than alone. Idle members spin for some microseconds, then sleep. (OpenMP's wait for the slowest
// thread, spinning: measured 3 to 9 times slower with two threads than with one on a busy machine.)
#pragma once

#include <cstddef>
#include <memory>

namespace pabd {

class Team {
 public:
  Team();
  ~Team();
  Team(Team&&) noexcept;
  Team& operator=(Team&&) noexcept;

  // Calls body(k) for k = 0 … count − 1 on up to `threads` threads, each taking `block` at a time; threads
  // are started when first needed. Fewer than kWorthwhile blocks are done in order on the calling thread: to
  // wake another may take longer. What `body` throws is thrown here.
  static constexpr std::size_t kWorthwhile = 8;
  template <class Body>
  void for_each(int threads, std::size_t count, std::size_t block, const Body& body) {
    if (threads <= 1 || count < kWorthwhile * block) {
      for (std::size_t k = 0; k < count; ++k) body(k);
      return;
    }
    share(threads, {[](const void* f, std::size_t begin, std::size_t end) {
                      for (std::size_t k = begin; k < end; ++k) (*static_cast<const Body*>(f))(k);
                    },
                    &body, count, block});
  }

 private:
  struct Loop {
    void (*run)(const void* body, std::size_t begin, std::size_t end);
    const void* body;
    std::size_t count, block;
  };
  struct Shared;

  void share(int threads, const Loop& loop);

  std::unique_ptr<Shared> shared_;
};

}  // namespace pabd
