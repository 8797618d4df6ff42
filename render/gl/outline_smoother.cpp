// SPDX-License-Identifier: MIT
// See outline_smoother.h.
#include "render/gl/outline_smoother.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "sim/base/srgb.h"

namespace pabd {
namespace {

enum Neighbour { kLeft, kRight, kBelow, kAbove };

const std::vector<std::uint8_t>& bytes_of_light() {
  static const std::vector<std::uint8_t> table = [] {
    std::vector<std::uint8_t> bytes(65536);
    for (int i = 0; i < 65536; ++i) bytes[static_cast<std::size_t>(i)] = srgb_byte(i / 65535.0);
    return bytes;
  }();
  return table;
}

// Mean of w over the pixel number k of a run of L, counted from the end that the outline leaves by; in 1/254.
int part_taken(int k, int run) {
  const double x0 = k, x1 = std::min(k + 1.0, 0.5 * run);
  return static_cast<int>(std::lround(254 * (x1 - x0) * (0.5 - 0.5 * (x0 + x1) / run)));
}

}  // namespace

// The runs between each of `count` rows and the next one. A row has `length` pixels, `step` pixels apart; the next row
// is `across` pixels away.
void OutlineSmoother::follow_runs(const std::uint16_t* pixels, int count, int length, int step, int across) {
  const bool level = step == 1;  // rows, not columns
  const std::ptrdiff_t pixel = 4 * static_cast<std::ptrdiff_t>(step);
  for (int row = 0; row + 1 < count; ++row) {
    const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(row) * across;
    const std::uint16_t* a = pixels + 4 * first + 3;                       // tags of this row
    const std::uint16_t* b = a + 4 * static_cast<std::ptrdiff_t>(across);  // and of the next
    std::uint8_t* to = taken_.data() + 4 * first;
    std::uint8_t* to_next = to + 4 * static_cast<std::ptrdiff_t>(across);
    for (int i = 0; i < length;) {
      if (a[i * pixel] == b[i * pixel]) {
        ++i;
        continue;
      }
      const int begin = i;
      const auto both_change = [&](int j, int k) {
        return a[j * pixel] != a[k * pixel] && b[j * pixel] != b[k * pixel];
      };
      for (++i; i < length && a[i * pixel] != b[i * pixel] && !both_change(i, i - 1);) ++i;
      const int run = i - begin;
      // At each end: whose thing goes on beyond it? The other row's pixels lose there.
      const auto end = [&](int inside, int outside, int towards) {
        if (outside < 0 || outside >= length || a[outside * pixel] != b[outside * pixel]) return;
        const std::uint16_t beyond = a[outside * pixel];
        const bool a_loses = beyond == b[inside * pixel], b_loses = beyond == a[inside * pixel];
        if (!a_loses && !b_loses) return;
        std::uint8_t* const loser =
            (a_loses ? to : to_next) + (level ? (a_loses ? kAbove : kBelow) : (a_loses ? kRight : kLeft));
        for (int k = 0; 2 * k < run; ++k) {
          std::uint8_t& taken = loser[(inside + k * towards) * pixel];
          taken = static_cast<std::uint8_t>(std::min(taken + part_taken(k, run), 127));
        }
      };
      end(begin, begin - 1, 1);
      end(i - 1, i, -1);
    }
  }
}

void OutlineSmoother::encode(const std::uint16_t* pixels, int width, int height, bool smooth,
                             std::uint8_t* out) {
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const std::uint8_t* const bytes = bytes_of_light().data();
  for (std::size_t i = 0; i < 4 * count; i += 4) {
    for (std::size_t c = 0; c < 3; ++c) out[i + c] = bytes[pixels[i + c]];
    out[i + 3] = 255;
  }
  if (!smooth) return;

  taken_.assign(4 * count, 0);
  follow_runs(pixels, height, width, 1, width);
  follow_runs(pixels, width, height, width, 1);
  const std::array<std::ptrdiff_t, 4> places = {-4, 4, -4 * static_cast<std::ptrdiff_t>(width),
                                                4 * static_cast<std::ptrdiff_t>(width)};
  for (std::size_t i = 0; i < 4 * count; i += 4) {
    const std::uint8_t* const taken = &taken_[i];
    std::uint32_t any = 0;
    std::memcpy(&any, taken, sizeof(any));
    if (any == 0) continue;
    // A pixel at a steep outline has runs both ways, which tell the same: the one that says more counts.
    const std::size_t first = taken[kLeft] + taken[kRight] > taken[kBelow] + taken[kAbove] ? kLeft : kBelow;
    const std::uint16_t* const here = pixels + i;
    const int sum = taken[first] + taken[first + 1];
    const int whole = std::max(254, sum + 64);  // a speck keeps something of itself
    for (std::size_t c = 0; c < 3; ++c) {
      int light = here[c] * (whole - sum) + whole / 2;
      for (const std::size_t n : {first, first + 1}) {
        if (taken[n] > 0) light += here[places[n] + static_cast<std::ptrdiff_t>(c)] * taken[n];
      }
      out[i + c] = bytes[static_cast<std::size_t>(light / whole)];
    }
  }
}

}  // namespace pabd
