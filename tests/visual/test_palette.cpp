// SPDX-License-Identifier: MIT
// Colours: order of the contact map, difference between neighbouring bodies, sRGB decoding.
#include "render/visual/palette.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "render/visual/build_visual.h"

namespace pabd::test_palette {

namespace {

// CIE lightness L* (0 … 100) of a linear-light colour.
double lightness(const Vec4f& c) {
  const double y = 0.2126 * c.x() + 0.7152 * c.y() + 0.0722 * c.z();
  return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

}  // namespace

TEST_CASE("srgb_color decodes the end points and middle grey") {
  CHECK(srgb_color(0x000000).head<3>().norm() == 0);
  CHECK((srgb_color(0xffffff) - Vec4f::Ones()).norm() < 1e-6f);
  CHECK(srgb_color(0x7f7f7f).y() == Approx(0.2122).margin(1e-4));  // ((127/255 + 0.055)/1.055)^2.4
  CHECK(srgb_color(0xff0080).x() == Approx(1));
  CHECK(srgb_color(0xff0080).y() == 0);
}

TEST_CASE("the contact map is strictly ordered by lightness") {
  double before = -1;
  for (int i = -100; i <= 100; ++i) {
    const double L = lightness(contact_color(i / 100.0));
    INFO("x = " << i / 100.0);
    CHECK(L > before);
    before = L;
  }
  // A penetrating contact stands apart from any that does not penetrate: 10 units of L*.
  CHECK(lightness(contact_color(0)) - lightness(contact_color(-1e-3)) > 8);
  CHECK(lightness(contact_color(1)) - lightness(contact_color(0)) > 40);
}

TEST_CASE("the contact map stays in range and is defined everywhere") {
  for (const double x :
       {-1e300, -1.0, -1e-6, 0.0, 0.5, 1.0, 1e300, std::numeric_limits<double>::infinity()}) {
    const Vec4f c = contact_color(x);
    CHECK((c.array() >= 0).all());
    CHECK((c.array() <= 1).all());
  }
  CHECK(contact_color(5) == contact_color(1));
  CHECK(contact_color(-5) == contact_color(-1));
  CHECK(contact_color(std::numeric_limits<double>::quiet_NaN()) == contact_color(-1));
}

TEST_CASE("bodies with neighbouring numbers differ in colour; fixed ones are grey") {
  for (Index i = 0; i < 2000; ++i) {
    const Vec3f a = body_color(i, false).head<3>();
    const Vec3f b = body_color(i + 1, false).head<3>();
    // Compared by hue, that is after the shade is divided out.
    CHECK((a / a.sum() - b / b.sum()).norm() > 0.03f);
    CHECK(a.maxCoeff() <= 1.0f);
  }
  const Vec4f grey = body_color(7, true);
  CHECK(grey.x() == Approx(grey.z()).epsilon(0.05));
}

}  // namespace pabd::test_palette
