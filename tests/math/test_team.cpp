// SPDX-License-Identifier: MIT
// The team of threads: every item exactly once, whatever the number of threads, the length of the loop, or
// what is thrown in it.

#include "sim/math/team.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <stdexcept>
#include <thread>
#include <vector>

namespace pabd::test_team {

using pabd::Sharing;
using pabd::Team;

TEST_CASE("every item is done once, for any number of threads and items") {
  Team team;
  for (const int threads : {1, 2, 8, 3}) {
    for (const std::size_t count : {0u, 1u, 63u, 64u, 65u, 127u, 128u, 1000u}) {
      std::vector<int> done(count, 0);
      team.for_each(threads, count, 16, [&](std::size_t k) { ++done[k]; });
      CHECK(done == std::vector<int>(count, 1));
    }
  }
}

TEST_CASE("many short loops one after the other: none reads another's items") {
  Team team;
  std::vector<int> values(256, 0);
  int wrong = 0;
  for (int round = 1; round <= 5000; ++round) {
    team.for_each(4, values.size(), 32, [&](std::size_t k) { values[k] += round % 7; });
    for (const int v : values) wrong += v != values[0];
  }
  CHECK(wrong == 0);
  CHECK(values[0] == 5000 / 7 * 21 + 1 + 2);
}

TEST_CASE("what an item throws arrives at the caller, and the team still works") {
  Team team;
  for (int round = 0; round < 20; ++round) {
    CHECK_THROWS_AS(team.for_each(3, 500, 8,
                                  [](std::size_t k) {
                                    if (k == 250) throw std::runtime_error("no");
                                  }),
                    std::runtime_error);
    std::atomic<int> sum{0};
    team.for_each(3, 100, 8, [&](std::size_t k) { sum += static_cast<int>(k); });
    CHECK(sum == 4950);
  }
}

TEST_CASE("a loop is shared from as many blocks on as the team was told") {
  const Team usual, each(Sharing{1, 1, false}), three(Sharing{3, 16, false});
  CHECK_FALSE(usual.shares(1, 1000000, 64));
  CHECK_FALSE(usual.shares(8, 8 * 64 - 1, 64));
  CHECK(usual.shares(2, 8 * 64, 64));
  CHECK(each.shares(2, 1, 64));
  CHECK_FALSE(each.shares(1, 100, 1));
  CHECK_FALSE(three.shares(2, 47, 64));
  CHECK(three.shares(2, 48, 64));
  CHECK(three.shares(2, 24, 8));
  CHECK(usual.ranges(3, 511, 64) == 1);
  CHECK(usual.ranges(3, 512, 64) == 12);
}

TEST_CASE("a few large items are shared where the caller says that it pays") {
  Team team;
  std::vector<std::thread::id> by(3);
  team.for_each_large(3, by.size(), false, [&](std::size_t k) { by[k] = std::this_thread::get_id(); });
  CHECK(by == std::vector<std::thread::id>(3, std::this_thread::get_id()));

  // Each item waits for the others: with a thread too few they would wait to the end of their patience.
  constexpr long kPatience = 100'000'000;
  Team all(Sharing{8, 64, true});
  std::atomic<int> begun{0}, alone{0};
  all.for_each_large(3, 3, true, [&](std::size_t) {
    ++begun;
    long k = 0;
    while (begun < 3 && ++k < kPatience) std::this_thread::yield();
    if (begun < 3) ++alone;
  });
  CHECK(alone == 0);
}

TEST_CASE("a contrary team has every thread in every loop, down to one item each") {
  for (const int threads : {2, 3, 8}) {
    Team team(Sharing{1, 1, true});
    for (int round = 0; round < 50; ++round) {
      // Each item waits for the others: with a thread too few they would wait to the end of their patience.
      constexpr long kPatience = 100'000'000;
      std::atomic<int> begun{0};
      std::atomic<int> alone{0};
      team.for_each(threads, static_cast<std::size_t>(threads), 64, [&](std::size_t) {
        ++begun;
        for (long k = 0; begun < threads; ++k) {
          if (k == kPatience) {
            ++alone;
            return;
          }
          std::this_thread::yield();
        }
      });
      REQUIRE(alone == 0);
    }
  }
}

TEST_CASE("a contrary team goes from the last item to the first") {
  Team team(Sharing{1, 1, true});
  std::vector<int> order(200, 0);
  std::atomic<int> turn{0};
  team.for_each(2, order.size(), 64, [&](std::size_t k) { order[k] = ++turn; });
  // Of two threads one may rest on its item while the other goes on: all but that one are in order.
  int out_of_order = 0;
  for (std::size_t k = 0; k + 1 < order.size(); ++k) out_of_order += order[k] < order[k + 1] ? 1 : 0;
  CHECK(out_of_order < 100);
}

}  // namespace pabd::test_team
