// SPDX-License-Identifier: MIT
// A matte is what gives both pictures back.
#include <catch2/catch.hpp>
#include <cmath>

#include "app/frames/linear_light.h"
#include "render/output/png.h"
#include "sim/base/srgb.h"

namespace pabd::test_matte {

TEST_CASE("colour and opacity come back from black and white, to a byte") {
  Image black, white;
  black.resize(16, 16);
  white.resize(16, 16);
  const auto color = [](int i, int c) { return (37 * i + 61 * c) % 200 / 200.0; };
  const auto alpha = [](int i) { return i % 9 / 8.0; };
  for (int i = 0; i < 256; ++i) {
    for (int c = 0; c < 3; ++c) {
      const auto at = static_cast<std::size_t>(3 * i + c);
      black.rgb[at] = srgb_byte(alpha(i) * color(i, c));
      white.rgb[at] = srgb_byte(alpha(i) * color(i, c) + 1 - alpha(i));
    }
  }
  const Image out = matte(black, white);
  REQUIRE(out.alpha.size() == 256);
  for (int i = 0; i < 256; ++i) {
    CAPTURE(i);
    CHECK(std::abs(out.alpha[static_cast<std::size_t>(i)] - 255 * alpha(i)) < 2.5);
    if (alpha(i) < 0.3) continue;
    for (int c = 0; c < 3; ++c)
      CHECK(std::abs(out.rgb[static_cast<std::size_t>(3 * i + c)] - srgb_byte(color(i, c))) <= 4);
  }
  // Colour type 6: RGB with alpha.
  CHECK(encode_png(out)[25] == 6);
  CHECK(encode_png(black)[25] == 2);
}

}  // namespace pabd::test_matte
