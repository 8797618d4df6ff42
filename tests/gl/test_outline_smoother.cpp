// SPDX-License-Identifier: MIT
// Smoothed outlines against the exact area that a half plane covers of each pixel.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "render/gl/outline_smoother.h"
#include "sim/base/srgb.h"

namespace pabd::test_outline_smoother {

namespace {

constexpr int kSide = 64;

struct Picture {
  std::vector<std::uint16_t> pixels = std::vector<std::uint16_t>(4 * kSide * kSide);
  std::uint16_t* at(int x, int y) { return &pixels[static_cast<std::size_t>(4 * (y * kSide + x))]; }
  void set(int x, int y, std::uint16_t light, std::uint16_t tag) {
    std::uint16_t* const p = at(x, y);
    p[0] = p[1] = p[2] = light;
    p[3] = tag;
  }
  // Linear light, 0 … 1.
  std::vector<double> encoded(bool smooth = true) const {
    std::vector<std::uint8_t> bytes(pixels.size());
    OutlineSmoother().encode(pixels.data(), kSide, kSide, smooth, bytes.data());
    std::vector<double> light;
    for (std::size_t i = 0; i < bytes.size(); i += 4) light.push_back(linear_from_srgb(bytes[i] / 255.0));
    return light;
  }
};

// White where a x + b y > c (a, b: unit normal), black elsewhere, sampled at pixel centres.
Picture half_plane(double a, double b, double c) {
  Picture picture;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const bool in = a * (x + 0.5) + b * (y + 0.5) > c;
      picture.set(x, y, in ? 65535 : 0, in ? 7 : 3);
    }
  }
  return picture;
}

// The same from four samples a pixel, where graphics cards have them.
std::vector<double> of_four_samples(double a, double b, double c) {
  constexpr double kAt[4][2] = {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}};
  std::vector<double> light;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      int in = 0;
      for (const auto& [u, v] : kAt) in += a * (x + u) + b * (y + v) > c;
      light.push_back(in / 4.0);
    }
  }
  return light;
}

// The part of a pixel that the half plane covers, by 64 × 64 points.
double covered(int x, int y, double a, double b, double c) {
  constexpr int kPoints = 64;
  int in = 0;
  for (int j = 0; j < kPoints; ++j)
    for (int i = 0; i < kPoints; ++i) in += a * (x + (i + 0.5) / kPoints) + b * (y + (j + 0.5) / kPoints) > c;
  return static_cast<double>(in) / (kPoints * kPoints);
}

struct Error {
  double largest = 0, mean = 0;  // over the pixels that the edge cuts, far from the picture's rim
};

Error error_of(const std::vector<double>& light, double a, double b, double c) {
  Error error;
  int cut = 0;
  for (int y = 16; y < kSide - 16; ++y) {
    for (int x = 16; x < kSide - 16; ++x) {
      const double truth = covered(x, y, a, b, c);
      const double off = std::abs(light[static_cast<std::size_t>(y * kSide + x)] - truth);
      error.largest = std::max(error.largest, off);
      if (truth <= 0 || truth >= 1) continue;
      error.mean += off;
      ++cut;
    }
  }
  error.mean /= std::max(cut, 1);
  return error;
}

}  // namespace

TEST_CASE("a straight edge is smoother than four samples make it, at every angle and place") {
  double mean = 0, jagged = 0, sampled = 0, largest = 0, largest_sampled = 0;
  for (int turn = 0; turn < 72; ++turn) {
    const double angle = 2 * std::acos(-1.0) * (turn + 0.3) / 72, a = std::cos(angle), b = std::sin(angle);
    for (const double shift : {-0.4, -0.1, 0.2}) {
      const double c = (a + b) * kSide / 2 + shift;
      CAPTURE(turn, shift);
      const Picture picture = half_plane(a, b, c);
      const Error smooth = error_of(picture.encoded(), a, b, c),
                  raw = error_of(picture.encoded(false), a, b, c);
      const Error four = error_of(of_four_samples(a, b, c), a, b, c);
      CHECK(smooth.mean < raw.mean);
      mean += smooth.mean;
      jagged += raw.mean;
      sampled += four.mean;
      largest = std::max(largest, smooth.largest);
      largest_sampled = std::max(largest_sampled, four.largest);
    }
  }
  CAPTURE(mean, jagged, sampled, largest, largest_sampled);
  CHECK(mean < 0.9 * sampled);
  CHECK(largest < 1.1 * largest_sampled);
  CHECK(mean < 0.35 * jagged);
}

TEST_CASE("edges along rows and columns stay sharp; one tag stays as it is") {
  const Picture level = half_plane(0, 1, kSide / 2), upright = half_plane(1, 0, kSide / 2);
  CHECK(level.encoded() == level.encoded(false));
  CHECK(upright.encoded() == upright.encoded(false));
  Picture checker;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) checker.set(x, y, (x + y) % 2 ? 60000 : 100, 5);
  CHECK(checker.encoded() == checker.encoded(false));
}

TEST_CASE("light is neither made nor lost along an edge, and a speck keeps something of itself") {
  const Picture edge = half_plane(0.28, 0.96, 0.6 * kSide);
  double before = 0, after = 0;
  const auto raw = edge.encoded(false), smooth = edge.encoded();
  for (std::size_t i = 0; i < raw.size(); ++i) {
    before += raw[i];
    after += smooth[i];
  }
  CHECK(after == Approx(before).epsilon(0.002));
  Picture speck = half_plane(0, 1, 2 * kSide);
  speck.set(30, 30, 65535, 9);
  const double light = speck.encoded()[30 * kSide + 30];
  CHECK(light >= 0.2);
  CHECK(light <= 1);
}

TEST_CASE("every byte is that of the sRGB function") {
  Picture ramp;
  for (int i = 0; i < kSide * kSide; ++i)
    ramp.set(i % kSide, i / kSide, static_cast<std::uint16_t>(16 * i), 0);
  std::vector<std::uint8_t> bytes(ramp.pixels.size());
  OutlineSmoother().encode(ramp.pixels.data(), kSide, kSide, true, bytes.data());
  for (int i = 0; i < kSide * kSide; ++i) {
    REQUIRE(bytes[static_cast<std::size_t>(4 * i)] == srgb_byte(16 * i / 65535.0));
    REQUIRE(bytes[static_cast<std::size_t>(4 * i + 3)] == 255);
  }
}

namespace {

// Larger than what one thread encodes at a time.
struct Large {
  static constexpr int kWidth = 700, kHeight = 160;
  std::vector<std::uint16_t> pixels = std::vector<std::uint16_t>(4 * kWidth * kHeight);
  void set(int x, int y, std::uint16_t light, std::uint16_t tag) {
    std::uint16_t* const p = &pixels[static_cast<std::size_t>(4 * (y * kWidth + x))];
    p[0] = p[1] = p[2] = light;
    p[3] = tag;
  }
  std::vector<std::uint8_t> encoded(OutlineSmoother& smoother) const {
    std::vector<std::uint8_t> bytes(pixels.size());
    smoother.encode(pixels.data(), kWidth, kHeight, true, bytes.data());
    return bytes;
  }
};

// Discs over each other.
Large discs(int count) {
  Large picture;
  for (int k = 0; k < count; ++k) {
    const int cx = 97 * k % Large::kWidth, cy = 53 * k % Large::kHeight, r = 5 + 11 * k % 37;
    for (int y = 0; y < Large::kHeight; ++y) {
      for (int x = 0; x < Large::kWidth; ++x) {
        if ((x - cx) * (x - cx) + (y - cy) * (y - cy) < r * r)
          picture.set(x, y, static_cast<std::uint16_t>(9001 * k), static_cast<std::uint16_t>(k + 1));
      }
    }
  }
  return picture;
}

}  // namespace

TEST_CASE("the bytes depend neither on threads nor on the picture before") {
  const Large picture = discs(40);
  OutlineSmoother alone, many(3);
  const auto expected = picture.encoded(alone);
  CHECK(picture.encoded(many) == expected);
  CHECK(discs(7).encoded(alone) != expected);
  CHECK(picture.encoded(alone) == expected);
}

// A run of 600 pixels along the upper side of row 80 has nothing to give to the pixel in its middle; one of 400 along the
// lower side gives it half.
TEST_CASE("a run that gives a pixel nothing does not keep another one from it") {
  Large picture;
  for (int y = 0; y < Large::kHeight; ++y) {
    for (int x = 0; x < Large::kWidth; ++x) {
      const bool above = y < 80 || (y == 80 && x >= 600), gap = y == 80 && x >= 300 && x < 600;
      picture.set(x, y, above || gap ? 0 : 40000, above ? 1 : gap ? 2 : 3);
    }
  }
  OutlineSmoother smoother;
  const int byte = picture.encoded(smoother)[4 * (80 * Large::kWidth + 300)];
  CHECK(std::abs(byte - srgb_byte(20000 / 65535.0)) <= 1);
}

}  // namespace pabd::test_outline_smoother
