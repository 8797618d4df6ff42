// SPDX-License-Identifier: MIT
// How far a drag on a bar goes, and where tooltips stand.
#include <catch2/catch.hpp>

#include "app/gui/number_input.h"
#include "app/gui/widgets.h"

namespace pabd::test_value_slider {

TEST_CASE("places on a bar and values are each other's inverse") {
  const SliderScale scales[] = {{0, 1, false}, {-2, 6, false}, {1e-4, 1e2, true}};
  for (const SliderScale& scale : scales) {
    for (const double place : {0.0, 0.1, 0.5, 0.93, 1.0}) {
      CAPTURE(scale.lo, scale.hi, place);
      CHECK(scale.place(scale.value(place)) == Approx(place).margin(1e-12));
    }
    CHECK(scale.value(0) == scale.lo);
    CHECK(scale.value(1) == scale.hi);
    CHECK(scale.place(scale.lo - 1) == 0);
    CHECK(scale.place(scale.hi + 1) == 1);
  }
  CHECK(SliderScale{1e-4, 1e2, true}.value(0.5) == Approx(0.1));  // the geometric mean
  CHECK(SliderScale{0, 10, true}.value(0) == 0);
  CHECK(SliderScale{0, 10, true}.place(0) == 0);
  CHECK(SliderScale{0, 10, true}.place(10) == 1);
}

TEST_CASE(
    "a drag goes as far as the mouse, with shift a tenth of it, and finds its way back from beyond an end") {
  SliderDrag drag;
  drag.begin(0.5);
  CHECK(drag.move(0.2, false) == Approx(0.7));
  CHECK(drag.move(0.2, true) == Approx(0.72));
  CHECK(drag.move(0.5, false) == 1);
  CHECK(drag.move(-0.3, false) == Approx(0.92));
  CHECK(drag.move(-2, false) == 0);
}

TEST_CASE("a tooltip is on the screen, and not over what it explains") {
  const Rect screen{0, 0, 1280, 720};
  for (const double x : {0.0, 300.0, 1240.0}) {
    for (const double y : {0.0, 350.0, 695.0}) {
      const Rect item{x, y, 40, 24};
      const Rect place = tooltip_place(item, {x + 5, y + 5}, 220, 60, screen, 5, 60);
      CAPTURE(x, y, place.x, place.y);
      CHECK(screen.contains(place));
      CHECK_FALSE(place.overlaps(item));
      // On what is large it stays clear of the mouse.
      const Point mouse{std::max(x, 1.0), std::max(y, 1.0)};
      const Rect beside = tooltip_place({0, 0, 1280, 720}, mouse, 220, 60, screen, 5, 60);
      CHECK(screen.contains(beside));
      CHECK_FALSE(beside.contains(mouse));
      // Along a bar it is above or below the mouse.
      const Rect bar{0, y, 1280, 24};
      const Rect along = tooltip_place(bar, {mouse.x, y + 5}, 220, 60, screen, 5, 60);
      CHECK(screen.contains(along));
      CHECK_FALSE(along.overlaps(bar));
      CHECK((along.x <= mouse.x && along.right() >= mouse.x));
    }
  }
}

}  // namespace pabd::test_value_slider
