// SPDX-License-Identifier: MIT
// The transfer function of sRGB against numbers of the standard.
#include "sim/base/srgb.h"

#include <catch2/catch.hpp>

namespace pabd::test_srgb {

TEST_CASE("sRGB: IEC 61966-2-1 at known places, there and back") {
  CHECK(linear_from_srgb(0) == 0);
  CHECK(linear_from_srgb(1) == Approx(1).epsilon(1e-15));
  CHECK(linear_from_srgb(0.5) == Approx(0.21404114048).epsilon(1e-10));
  CHECK(srgb_from_linear(0.18) == Approx(0.46135612950).epsilon(1e-10));  // the photographer's grey card
  CHECK(linear_from_srgb(0.04) == Approx(0.04 / 12.92).epsilon(1e-15));
  for (int byte = 0; byte < 256; ++byte) CHECK(srgb_byte(linear_from_srgb(byte / 255.0)) == byte);
  CHECK(srgb_byte(-1) == 0);
  CHECK(srgb_byte(7) == 255);
  // The two pieces meet, to the rounding of the standard's constants.
  CHECK(srgb_from_linear(0.0031308) == Approx(srgb_from_linear(0.0031309)).margin(2e-6));
}

}  // namespace pabd::test_srgb
