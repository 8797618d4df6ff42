// SPDX-License-Identifier: MIT
// Rows turned over and three bytes of four kept, whoever does which row.
#include <catch2/catch.hpp>
#include <utility>
#include <vector>

#include "render/gl/drop_alpha.h"

namespace pabd::test_drop_alpha {

TEST_CASE("a pixel's three bytes arrive in the row that is as far from the top as it was from the bottom") {
  const int threads = GENERATE(1, 2, 5);
  const auto [width, height] =
      GENERATE(std::pair{1, 1}, std::pair{7, 3}, std::pair{33, 401}, std::pair{640, 128});
  const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
  std::vector<std::uint8_t> rgba(4 * w * h);
  for (std::size_t i = 0; i < rgba.size(); ++i) rgba[i] = static_cast<std::uint8_t>(i * 2654435761u >> 24);
  std::vector<std::uint8_t> rgb(3 * w * h, 0);
  Team team({.least_blocks = 2, .contrary = true});
  drop_alpha(rgba.data(), width, height, team, threads, rgb.data());
  std::size_t wrong = 0;
  for (std::size_t y = 0; y < h; ++y) {
    for (std::size_t x = 0; x < w; ++x) {
      for (std::size_t c = 0; c < 3; ++c)
        wrong += rgb[3 * (y * w + x) + c] != rgba[4 * ((h - 1 - y) * w + x) + c];
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("only large frames are worth more than one thread, and eight are enough") {
  CHECK(drop_alpha_threads(1280, 720, 16) == 1);
  CHECK(drop_alpha_threads(3840, 2160, 2) == 2);
  CHECK(drop_alpha_threads(3840, 2160, 16) == 8);
  CHECK(drop_alpha_threads(3840, 2160, 1) == 1);
}

}  // namespace pabd::test_drop_alpha
