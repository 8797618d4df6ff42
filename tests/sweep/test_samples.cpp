// SPDX-License-Identifier: MIT
// Ranges, the sequence of Sobol and Latin hypercubes against what is known of them.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "app/sweep/samples.h"

namespace pabd::test_samples {

TEST_CASE("a range has both ends, and equal differences or factors between") {
  CHECK(spaced({0.005, 0.02}, 4) == std::vector<double>{0.005, 0.01, 0.015, 0.02});
  CHECK(spaced({1, 1000, true}, 4) == std::vector<double>{1, 10, 100, 1000});
  CHECK(spaced({1000, 1, true}, 4) == std::vector<double>{1000, 100, 10, 1});
  CHECK(spaced({2, 9}, 1) == std::vector<double>{2});
  CHECK(spaced({1, 4, false, true}, 3) == std::vector<double>{1, 3, 4});  // 2.5 is rounded
  CHECK(rounded(0.1 + 0.2) == 0.3);
  CHECK(rounded(-1.0 / 3) == -0.333333333333);
}

TEST_CASE("whole numbers of an axis have equal parts") {
  int count[4] = {};
  for (int i = 0; i < 400; ++i) ++count[static_cast<int>(at_part({1, 4, false, true}, i / 400.0)) - 1];
  for (const int n : count) CHECK(n == 100);
  CHECK(at_part({1, 4, false, true}, 1 - 0x1p-53) == 4);
  CHECK(at_part({1, 1000, true, true}, 1 - 0x1p-53) == 1000);
  CHECK(at_part({1, 1000, true, true}, 0) == 1);
}

TEST_CASE("the sequence of Sobol begins as published") {
  // Joe and Kuo's generator with their numbers, three axes, the first eight points.
  const UnitPoints expected = {{0, 0, 0},
                               {0.5, 0.5, 0.5},
                               {0.75, 0.25, 0.25},
                               {0.25, 0.75, 0.75},
                               {0.375, 0.375, 0.625},
                               {0.875, 0.875, 0.125},
                               {0.625, 0.125, 0.875},
                               {0.125, 0.625, 0.375}};
  CHECK(sobol_points(8, 3, 0) == expected);
}

TEST_CASE("a shift keeps what is even of Sobol's points: one in each part of each axis") {
  for (const std::uint64_t seed : {0, 1, 7, 12345}) {
    const UnitPoints points = sobol_points(64, 6, seed);
    for (std::size_t k = 0; k < 6; ++k) {
      std::set<int> parts;
      for (const auto& point : points) parts.insert(static_cast<int>(point[k] * 64));
      CHECK(parts.size() == 64);
    }
    // And of the first two axes one in each of 8 × 8 squares.
    std::set<int> squares;
    for (const auto& point : points)
      squares.insert(8 * static_cast<int>(point[0] * 8) + static_cast<int>(point[1] * 8));
    CHECK(squares.size() == 64);
  }
  CHECK(sobol_points(8, 2, 1) != sobol_points(8, 2, 0));
  CHECK(sobol_points(8, 2, 1) != sobol_points(8, 2, 2));
  CHECK(sobol_points(8, 2, 1) == sobol_points(8, 2, 1));
}

TEST_CASE("a Latin hypercube has one point in each part of each axis") {
  for (const std::size_t count : {std::size_t{1}, std::size_t{10}, std::size_t{97}}) {
    const UnitPoints points = latin_hypercube_points(count, 5, 3);
    for (std::size_t k = 0; k < 5; ++k) {
      std::set<std::size_t> parts;
      for (const auto& point : points) {
        CHECK((point[k] >= 0 && point[k] < 1));
        parts.insert(static_cast<std::size_t>(point[k] * static_cast<double>(count)));
      }
      CHECK(parts.size() == count);
    }
  }
  CHECK(latin_hypercube_points(10, 2, 1) != latin_hypercube_points(10, 2, 2));
  CHECK(latin_hypercube_points(10, 2, 1) == latin_hypercube_points(10, 2, 1));
}

TEST_CASE("the axes of a Latin hypercube know nothing of each other") {
  // The correlation of two of n independent values has the standard deviation 1/√(n−1): 0.032 of 1000.
  const UnitPoints points = latin_hypercube_points(1000, 3, 9);
  for (const auto& [a, b] : {std::pair<std::size_t, std::size_t>{0, 1}, {0, 2}, {1, 2}}) {
    double sum = 0;
    for (const auto& point : points) sum += (point[a] - 0.5) * (point[b] - 0.5);
    CHECK(std::abs(sum / 1000 * 12) < 4 * 0.032);
  }
}

}  // namespace pabd::test_samples
