// SPDX-License-Identifier: MIT
#include "sim/math/team.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "sim/math/flush_denormals.h"

namespace pabd {
namespace {

void pause() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#endif
}

constexpr int kSpins = 1000;  // some ten microseconds

}  // namespace

// A loop is open while blocks may be taken. A member that wants some first counts itself in, then looks
// whether the loop is open; the caller first closes it, then waits for those who are in. So nobody reads a
// loop that is being replaced.
struct Team::Shared {
  Loop loop{};
  int invited = 0;  // members that may take part
  std::atomic<std::size_t> next{0};
  std::atomic<bool> open{false}, leaving{false};
  std::atomic<int> inside{0};
  bool contrary = false;
  std::atomic<int> come{0};        // to this loop; counted only when contrary
  std::atomic<unsigned> round{0};  // one more for each loop, and at the end
  std::mutex mutex;
  std::exception_ptr failure;
  std::vector<std::thread> members;

  void take_blocks() {
    try {
      for (;;) {
        const std::size_t begin = next.fetch_add(loop.block);
        if (begin >= loop.count) return;
        const std::size_t end = std::min(loop.count, begin + loop.block);
        contrary ? loop.run(loop.body, loop.count - end, loop.count - begin)
                 : loop.run(loop.body, begin, end);
      }
    } catch (...) {
      next = loop.count;
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  }

  // Until every invited member and the caller are here.
  void meet() {
    come.fetch_add(1);
    while (come.load() <= invited) std::this_thread::yield();
  }

  void serve(int number) {
    const FlushDenormals flush;
    unsigned seen = 0;
    for (;;) {
      for (int k = 0; k < kSpins && round.load() == seen; ++k) pause();
      round.wait(seen);
      seen = round.load();
      if (leaving.load()) return;
      inside.fetch_add(1);
      if (open.load() && number < invited) {
        if (contrary) meet();
        take_blocks();
      }
      inside.fetch_sub(1);
    }
  }

  void next_round() {
    round.fetch_add(1);
    round.notify_all();
  }

  ~Shared() {
    leaving = true;
    next_round();
    for (std::thread& member : members) member.join();
  }
};

Team::Team() = default;
Team::Team(const Sharing& sharing) : sharing_(sharing) {}
Team::~Team() = default;
Team::Team(Team&&) noexcept = default;
Team& Team::operator=(Team&&) noexcept = default;

void Team::share(int threads, const Loop& loop) {
  if (!shared_) shared_ = std::make_unique<Shared>();
  Shared& s = *shared_;
  const auto helpers = static_cast<std::size_t>(threads) - 1;
  while (s.members.size() < helpers)
    s.members.emplace_back([&s, number = static_cast<int>(s.members.size())] { s.serve(number); });
  s.loop = loop;
  s.invited = static_cast<int>(helpers);
  s.next = 0;
  s.contrary = sharing_.contrary;
  s.come = 0;
  s.open = true;
  s.next_round();
  if (s.contrary) s.meet();
  s.take_blocks();
  s.open = false;
  for (int k = 0; s.inside.load() > 0; ++k) k < kSpins ? pause() : std::this_thread::yield();
  if (s.failure) std::rethrow_exception(std::exchange(s.failure, nullptr));
}

}  // namespace pabd
