// SPDX-License-Identifier: MIT
// Image comparison in two tiers.
#include "render/output/compare_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace pabd {
namespace {

constexpr int tile_size = 16;
constexpr int same_levels = 1;
constexpr double same_part = 0.001;
constexpr int cross_levels = 16;
constexpr int cross_pixels = 3;
constexpr double cross_mean = 3.5;

using Bytes = std::vector<std::uint8_t>;

std::size_t offset(int width, int x, int y) {
  return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) * 3;
}

// Smallest and largest value of each channel in the 3×3 pixels around each pixel.
struct Surround {
  Bytes low, high;
};

Surround surround(const Image& image) {
  const int w = image.width, h = image.height;
  Surround rows{Bytes(image.rgb.size()), Bytes(image.rgb.size())};
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      const std::size_t here = offset(w, x, y);
      const std::size_t left = offset(w, std::max(x - 1, 0), y), right = offset(w, std::min(x + 1, w - 1), y);
      for (std::size_t c = 0; c < 3; ++c) {
        const auto [low, high] =
            std::minmax({image.rgb[left + c], image.rgb[here + c], image.rgb[right + c]});
        rows.low[here + c] = low;
        rows.high[here + c] = high;
      }
    }
  }
  Surround both{Bytes(image.rgb.size()), Bytes(image.rgb.size())};
  for (int y = 0; y < h; ++y) {
    const std::size_t up = offset(w, 0, std::max(y - 1, 0)), down = offset(w, 0, std::min(y + 1, h - 1));
    const std::size_t here = offset(w, 0, y);
    for (std::size_t i = 0; i < static_cast<std::size_t>(w) * 3; ++i) {
      both.low[here + i] = std::min({rows.low[up + i], rows.low[here + i], rows.low[down + i]});
      both.high[here + i] = std::max({rows.high[up + i], rows.high[here + i], rows.high[down + i]});
    }
  }
  return both;
}

// Signed distance of a value to [low, high]; 0 inside.
int outside(int value, int low, int high) {
  return value < low ? value - low : value > high ? value - high : 0;
}

// Where a row of tiles begins: every 16 pixels, the last one moved back so that no tile is a sliver.
std::vector<int> tile_starts(int size) {
  std::vector<int> starts;
  for (int start = 0; start < size; start += tile_size)
    starts.push_back(std::max(0, std::min(start, size - tile_size)));
  return starts;
}

struct Tile {
  int pixels = 0;   // over the limit
  double mean = 0;  // of the worst channel and direction
  double badness() const { return std::max(pixels / double(cross_pixels), mean / cross_mean); }
};

// Signed distances of both directions are in forward and backward, 3 a pixel.
Tile measure_tile(const std::vector<std::int16_t>& forward, const std::vector<std::int16_t>& backward,
                  int width, int height, int x0, int y0) {
  const int x1 = std::min(x0 + tile_size, width), y1 = std::min(y0 + tile_size, height);
  std::array<long, 6> sums = {};
  Tile tile;
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      const std::size_t at = offset(width, x, y);
      int worst = 0;
      for (std::size_t c = 0; c < 3; ++c) {
        sums[c] += forward[at + c];
        sums[3 + c] += backward[at + c];
        worst = std::max({worst, std::abs(int(forward[at + c])), std::abs(int(backward[at + c]))});
      }
      tile.pixels += worst > cross_levels;
    }
  }
  for (long sum : sums) tile.mean = std::max(tile.mean, std::abs(double(sum)) / ((x1 - x0) * (y1 - y0)));
  return tile;
}

// Levels by which channels are off, in one direction and in the other, over all tiles.
void find_worst_tile(const std::vector<std::int16_t>& forward, const std::vector<std::int16_t>& backward,
                     const Image& size, CompareResult& result) {
  double badness = -1;
  for (int y : tile_starts(size.height)) {
    for (int x : tile_starts(size.width)) {
      const Tile tile = measure_tile(forward, backward, size.width, size.height, x, y);
      result.worst_tile_pixels = std::max(result.worst_tile_pixels, tile.pixels);
      result.worst_tile_mean = std::max(result.worst_tile_mean, tile.mean);
      if (tile.badness() <= badness) continue;
      badness = tile.badness();
      result.worst_tile_x = x;
      result.worst_tile_y = y;
    }
  }
}

void compare_across(const Image& actual, const Image& expected, CompareResult& result) {
  const Surround around_expected = surround(expected), around_actual = surround(actual);
  const std::size_t size = actual.rgb.size();
  std::vector<std::int16_t> forward(size), backward(size);
  std::size_t over = 0;
  for (std::size_t at = 0; at < size; at += 3) {
    int worst = 0;
    for (std::size_t i = at; i < at + 3; ++i) {
      const int added = outside(actual.rgb[i], around_expected.low[i], around_expected.high[i]);
      const int missing = outside(expected.rgb[i], around_actual.low[i], around_actual.high[i]);
      forward[i] = static_cast<std::int16_t>(added);
      backward[i] = static_cast<std::int16_t>(missing);
      worst = std::max({worst, std::abs(added), std::abs(missing)});
    }
    over += worst > cross_levels;
  }
  result.differing = static_cast<double>(over) / (static_cast<double>(size) / 3);

  find_worst_tile(forward, backward, actual, result);
  result.equal = result.worst_tile_pixels <= cross_pixels && result.worst_tile_mean <= cross_mean;
  if (result.equal) return;
  result.reason = fmt::format(
      "a tile of 16x16 pixels has {} off by over {} levels (at most {}), a tile mean is off by {:.2f} (at "
      "most {}); "
      "worst tile at ({}, {})",
      result.worst_tile_pixels, cross_levels, cross_pixels, result.worst_tile_mean, cross_mean,
      result.worst_tile_x, result.worst_tile_y);
}

void compare_same(const Image& actual, const Image& expected, CompareResult& result) {
  std::size_t over = 0;
  std::vector<std::int16_t> difference(actual.rgb.size());
  for (std::size_t at = 0; at < actual.rgb.size(); at += 3) {
    bool same = true;
    for (std::size_t i = at; i < at + 3; ++i) {
      difference[i] = static_cast<std::int16_t>(actual.rgb[i] - expected.rgb[i]);
      same = same && difference[i] == 0;
    }
    over += !same;
  }
  result.differing = static_cast<double>(over) / (static_cast<double>(actual.rgb.size()) / 3);
  // Tiles decide nothing here; they say where to look.
  find_worst_tile(difference, difference, actual, result);
  result.equal = result.max_difference <= same_levels && result.differing <= same_part;
  if (result.equal) return;
  result.reason = fmt::format(
      "a channel is off by {} levels (at most {}), {:.3f} % of pixels are off (at most {:.1f} %); worst tile "
      "at ({}, {})",
      result.max_difference, same_levels, 100 * result.differing, 100 * same_part, result.worst_tile_x,
      result.worst_tile_y);
}

}  // namespace

CompareResult compare_images(const Image& actual, const Image& expected, CompareTier tier) {
  CompareResult result;
  if (actual.width != expected.width || actual.height != expected.height ||
      actual.rgb.size() != expected.rgb.size()) {
    result.reason = fmt::format("the sizes differ: {}x{} pixels, expected {}x{}", actual.width, actual.height,
                                expected.width, expected.height);
    return result;
  }
  if (actual.rgb.empty() || actual.rgb.size() != offset(actual.width, 0, actual.height)) {
    result.reason = "the images have no pixels";
    return result;
  }
  for (std::size_t i = 0; i < actual.rgb.size(); ++i) {
    result.max_difference =
        std::max(result.max_difference, std::abs(int(actual.rgb[i]) - int(expected.rgb[i])));
  }
  if (tier == CompareTier::same_class) {
    compare_same(actual, expected, result);
  } else {
    compare_across(actual, expected, result);
  }
  return result;
}

Image difference_image(const Image& actual, const Image& expected) {
  constexpr std::array<double, 3> outside_color = {90, 40, 110};  // covered by one image only
  constexpr std::array<double, 3> weak = {230, 80, 20}, strong = {255, 240, 120};
  Image picture;
  picture.resize(std::max(actual.width, expected.width), std::max(actual.height, expected.height));
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const bool in_actual = x < actual.width && y < actual.height;
      const bool in_expected = x < expected.width && y < expected.height;
      std::uint8_t* pixel = picture.rgb.data() + offset(picture.width, x, y);
      if (!in_actual || !in_expected) {
        for (std::size_t c = 0; c < 3; ++c) pixel[c] = static_cast<std::uint8_t>(outside_color[c]);
        continue;
      }
      const std::uint8_t* a = actual.rgb.data() + offset(actual.width, x, y);
      const std::uint8_t* e = expected.rgb.data() + offset(expected.width, x, y);
      const double grey = 0.35 * (0.3 * e[0] + 0.6 * e[1] + 0.1 * e[2]);
      int worst = 0;
      for (std::size_t c = 0; c < 3; ++c) worst = std::max(worst, std::abs(int(a[c]) - int(e[c])));
      // One level must be visible already; from 64 on the colour is the strongest.
      const double amount = worst == 0 ? 0 : std::min(1.0, 0.35 + 0.65 * worst / 64.0);
      const double heat = std::min(1.0, worst / 64.0);
      for (std::size_t c = 0; c < 3; ++c) {
        const double color = weak[c] + heat * (strong[c] - weak[c]);
        pixel[c] = static_cast<std::uint8_t>(std::lround(grey + amount * (color - grey)));
      }
    }
  }
  return picture;
}

}  // namespace pabd
