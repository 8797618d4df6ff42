// The team of threads: every item exactly once, whatever the number of threads, the length of the loop, or
// what is thrown in it.

#include "sim/math/team.h"

#include <atomic>
#include <catch2/catch.hpp>
#include <stdexcept>
#include <vector>

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
