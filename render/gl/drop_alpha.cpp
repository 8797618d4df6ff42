// SPDX-License-Identifier: MIT
// See drop_alpha.h.
#include "render/gl/drop_alpha.h"

#include <algorithm>
#include <cstddef>

namespace pabd {
namespace {

constexpr std::size_t kRows = 16;  // that a thread takes at a time

void drop_alpha_of_row(const std::uint8_t* from, std::size_t width, std::uint8_t* to) {
  for (std::size_t x = 0; x < width; ++x) {  // compilers make shuffles of it; words and shifts are slower
    to[3 * x] = from[4 * x];
    to[3 * x + 1] = from[4 * x + 1];
    to[3 * x + 2] = from[4 * x + 2];
  }
}

}  // namespace

void drop_alpha(const std::uint8_t* rgba, int width, int height, Team& team, int threads, std::uint8_t* rgb) {
  const auto columns = static_cast<std::size_t>(width), rows = static_cast<std::size_t>(height);
  team.for_each(threads, rows, kRows, [&](std::size_t y) {
    drop_alpha_of_row(rgba + (rows - 1 - y) * columns * 4, columns, rgb + y * columns * 3);
  });
}

int drop_alpha_threads(int width, int height, int cpus) {
  constexpr std::int64_t kLeast = 1'000'000;  // pixels
  constexpr int kMost = 8;
  return static_cast<std::int64_t>(width) * height < kLeast ? 1 : std::clamp(cpus, 1, kMost);
}

}  // namespace pabd
