// SPDX-License-Identifier: MIT
// See outline_smoother.h.
#include "render/gl/outline_smoother.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <utility>

#include "sim/base/srgb.h"

namespace pabd {
namespace {

constexpr std::size_t kRows = 16;  // that a thread encodes at a time

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

// Bytes of a row, and its tags.
void encode_row(const std::uint8_t* bytes, const std::uint16_t* from, std::size_t width, std::uint8_t* out,
                std::uint16_t* tags) {
  // One store a pixel: compilers make four of an array.
  const auto shifted = [](std::uint32_t byte, int c) {
    return byte << (std::endian::native == std::endian::little ? 8 * c : 24 - 8 * c);
  };
  for (std::size_t x = 0; x < width; ++x, from += 4) {
    const std::uint32_t to = shifted(bytes[from[0]], 0) | shifted(bytes[from[1]], 1) |
                             shifted(bytes[from[2]], 2) | shifted(255, 3);
    std::memcpy(out + 4 * x, &to, sizeof(to));
    tags[x] = from[3];
  }
}

}  // namespace

// A run between two rows of pixels, or two columns: a(k) and b(k) are the tags of its pixel number k on either side.
struct OutlineSmoother::Seam {
  const std::uint16_t* tags;  // of pixel number 0 of the row
  std::ptrdiff_t step;        // to the next pixel of the row
  std::ptrdiff_t across;      // to the pixel beside it in the next row
  int length;

  std::uint16_t a(int k) const { return tags[k * step]; }
  std::uint16_t b(int k) const { return tags[k * step + across]; }
  bool differ(int k) const { return a(k) != b(k); }
  bool both_change(int k) const { return a(k) != a(k - 1) && b(k) != b(k - 1); }
  bool begins(int k) const { return differ(k) && (k == 0 || !differ(k - 1) || both_change(k)); }
};

// Follows the run that begins at pixel number `begin` of a seam; returns where it ends.
int OutlineSmoother::follow_run(const Seam& seam, int begin) {
  int stop = begin + 1;
  while (stop < seam.length && seam.differ(stop) && !seam.both_change(stop)) ++stop;
  const int run = stop - begin;
  const bool level = seam.step == 1;  // rows, not columns
  // At each end: whose thing goes on beyond it? The other row's pixels lose there.
  const auto end = [&](int inside, int outside, int towards) {
    if (outside < 0 || outside >= seam.length || seam.differ(outside)) return;
    const std::uint16_t beyond = seam.a(outside);
    const bool a_loses = beyond == seam.b(inside), b_loses = beyond == seam.a(inside);
    if (!a_loses && !b_loses) return;
    const std::ptrdiff_t first = seam.tags - tags_.data() + (a_loses ? 0 : seam.across);
    const std::size_t from = level ? (a_loses ? kAbove : kBelow) : (a_loses ? kRight : kLeft);
    for (int k = 0; 2 * k < run; ++k) {
      const auto pixel = static_cast<std::size_t>(first + (inside + k * towards) * seam.step);
      Taken& taken = taken_[pixel];
      const int part = part_taken(k, run);
      if (part > 0 && std::bit_cast<std::uint32_t>(taken) == 0) touched_.push_back(pixel);
      taken[from] = static_cast<std::uint8_t>(std::min(taken[from] + part, 127));
    }
  };
  end(begin, begin - 1, 1);
  end(stop - 1, stop, -1);
  return stop;
}

void OutlineSmoother::follow_runs(int width, int height) {
  // Most pixels are of one thing with their neighbours: four of them at a time are passed over.
  const auto same = [](const std::uint16_t* a, const std::uint16_t* b) {
    std::uint64_t p = 0, q = 0;
    std::memcpy(&p, a, sizeof(p));
    std::memcpy(&q, b, sizeof(q));
    return p == q;
  };
  for (int y = 0; y < height; ++y) {
    const std::uint16_t* const row = tags_.data() + static_cast<std::ptrdiff_t>(y) * width;
    if (y + 1 < height) {
      const Seam below{row, 1, width, width};
      for (int x = 0; x < width;) {
        if (x + 4 <= width && same(row + x, row + width + x)) {
          x += 4;
        } else {
          x = below.differ(x) ? follow_run(below, x) : x + 1;
        }
      }
    }
    for (int x = 0; x + 1 < width;) {
      if (x + 5 <= width && same(row + x, row + x + 1)) {
        x += 4;
        continue;
      }
      const Seam beside{tags_.data() + x, width, 1, height};
      if (beside.begins(y)) follow_run(beside, y);
      ++x;
    }
  }
}

void OutlineSmoother::encode(const std::uint16_t* pixels, int width, int height, bool smooth,
                             std::uint8_t* out) {
  const auto columns = static_cast<std::size_t>(width), rows = static_cast<std::size_t>(height);
  const std::size_t count = columns * rows;
  const std::uint8_t* const bytes = bytes_of_light().data();
  tags_.resize(count);
  team_.for_each(threads_, rows, kRows, [&](std::size_t y) {
    encode_row(bytes, pixels + 4 * y * columns, columns, out + 4 * y * columns, tags_.data() + y * columns);
  });
  if (!smooth) return;

  taken_.resize(count);  // all zero, here and after each frame
  follow_runs(width, height);
  const std::array<std::ptrdiff_t, 4> places = {-4, 4, -4 * static_cast<std::ptrdiff_t>(width),
                                                4 * static_cast<std::ptrdiff_t>(width)};
  for (const std::size_t pixel : touched_) {
    const Taken taken = std::exchange(taken_[pixel], {});
    // A pixel at a steep outline has runs both ways for the same edge: the stronger one counts.
    const std::size_t first = taken[kLeft] + taken[kRight] > taken[kBelow] + taken[kAbove] ? kLeft : kBelow;
    const std::uint16_t* const here = pixels + 4 * pixel;
    const int sum = taken[first] + taken[first + 1];
    const int whole = std::max(254, sum + 64);  // a speck keeps something of itself
    for (std::size_t c = 0; c < 3; ++c) {
      int light = here[c] * (whole - sum) + whole / 2;
      for (const std::size_t n : {first, first + 1}) {
        if (taken[n] > 0) light += here[places[n] + static_cast<std::ptrdiff_t>(c)] * taken[n];
      }
      out[4 * pixel + c] = bytes[static_cast<std::size_t>(light / whole)];
    }
  }
  touched_.clear();
}

}  // namespace pabd
