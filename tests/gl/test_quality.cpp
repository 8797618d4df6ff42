// SPDX-License-Identifier: MIT
// The size of live pictures follows what they cost, and settles.
#include "render/gl/quality.h"

#include <catch2/catch.hpp>

namespace pabd::test_quality {

namespace {

// Draws `count` pictures that take a + b s² ms each; returns how often the scale changed.
int draw(LiveScale& live, int count, double a, double b) {
  int changes = 0;
  for (int k = 0; k < count; ++k) {
    const double before = live.scale();
    live.took(a + b * before * before);
    changes += live.scale() != before;
  }
  return changes;
}

}  // namespace

TEST_CASE("a scene that is cheap enough stays at its full size") {
  LiveScale live(20);
  CHECK(draw(live, 100, 2, 17) == 0);
  CHECK(live.scale() == 1);
}

TEST_CASE("for every cost the scale settles, within the budget if it can, and is not needlessly small") {
  for (const double a : {0.0, 3.0, 12.0}) {
    for (double b = 1; b < 200; b *= 1.13) {
      CAPTURE(a, b);
      LiveScale live(20);
      draw(live, 60, a, b);
      CHECK(draw(live, 200, a, b) == 0);
      const double s = live.scale(), ms = a + b * s * s;
      CHECK((ms <= 20 || s == 0.35));
      if (a == 0 && s < 1) CHECK(b * s * s > 20 * 0.4);  // the next size would hardly fit
    }
  }
}

TEST_CASE("it comes back when the scene gets cheaper; one slow picture changes nothing") {
  LiveScale live(20);
  draw(live, 60, 0, 100);
  CHECK(live.scale() < 0.5);
  draw(live, 60, 0, 10);
  CHECK(live.scale() == 1);
  live.took(500);
  live.took(500);
  CHECK(draw(live, 10, 0, 10) == 0);
}

TEST_CASE("pictures that are much too slow are as small as they must be after three of them") {
  LiveScale live(20);
  draw(live, 3, 0, 300);
  CHECK(live.scale() == 0.35);
  LiveScale less(20);
  draw(less, 3, 10, 60);
  CHECK(less.scale() == 0.5);  // 20 of 70 ms are 0.53 of a side
}

}  // namespace pabd::test_quality
