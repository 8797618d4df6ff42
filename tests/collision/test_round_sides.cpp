// SPDX-License-Identifier: MIT
// Sides of cylinders and cones against edges, balls and each other: closed forms, however they are turned about their axis.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/body/shape_kind.h"
#include "sim/math/so3.h"
#include "tests/collision/reference.h"

namespace pabd::test_round_sides {

using namespace reference;

namespace {

constexpr double kRadius = 0.4, kHeight = 1.2;

Mat3 spun(double roll) { return exp_so3({0, roll, 0}); }
// Its axis along z.
Mat3 lying() { return exp_so3({kPi / 2, 0, 0}); }

}  // namespace

TEST_CASE(
    "the side of a cylinder against an edge along it is as far as the edge is from the axis, less the "
    "radius") {
  for (const double angle : {0.4, 0.8, 1.2}) {  // of the edge, seen from the axis, off straight down
    for (const double roll : {0.0, 0.05, 0.098, 1.0, 2.3}) {
      CAPTURE(angle, roll);
      Setup setup;
      // The edge of the box is at x = 0, y = 0; the axis lies above and before it.
      setup.add(Box{{1, 1, 3}}, {1, -1, 0}, Mat3::Identity(), 0.05, true);
      const Vec3 axis = (kRadius + 0.02) * Vec3(-std::sin(angle), std::cos(angle), 0);
      setup.add(make_shape("cylinder", {kRadius, kHeight}), axis, lying() * spun(roll));
      // What is nearest, at both ends; other points of the box may be farther.
      auto contacts = setup.contacts();
      std::sort(contacts.begin(), contacts.end(),
                [](const ContactPoint& p, const ContactPoint& q) { return p.d < q.d; });
      REQUIRE(contacts.size() >= 2);
      for (int k = 0; k < 2; ++k) {
        const ContactPoint& p = contacts[static_cast<std::size_t>(k)];
        const Vec3 n = p.a == 1 ? p.n : Vec3(-p.n);
        CHECK((n + axis.normalized()).norm() < 1e-9);
        CHECK(p.d == Approx(0.02).epsilon(1e-9));
        CHECK(std::max(p.round_a, p.round_b) == Approx(kRadius).epsilon(1e-9));
      }
    }
  }
}

TEST_CASE("the normal point of a round side lies on its axis") {
  Random random(4);
  int sides = 0;
  for (const char* name : {"cylinder", "cone"}) {
    for (int k = 0; k < 200; ++k) {
      Setup setup;
      setup.add(Plane{Vec3::UnitY(), 0}, Vec3::Zero(), Mat3::Identity(), 0.3, true);
      const Mat3 R = random.rotation();
      setup.add(make_shape(name, {kRadius, kHeight}), {0, 0.5, 0}, R, 0.3);
      for (const ContactPoint& p : setup.contacts()) {
        if (p.round_b == 0) continue;
        const Vec3 q = R.transpose() * (p.y_b + p.round_b * p.n - setup.c[1]);
        CHECK(std::hypot(q.x(), q.z()) < 1e-12);
        ++sides;
      }
    }
  }
  CHECK(sides > 200);
}

TEST_CASE("cylinders on each other touch at both ends of the line they share, also when they are askew") {
  for (const double askew : {0.0, 1e-5, 4e-4, -4e-4}) {
    for (const double roll : {0.0, 0.07, 1.3}) {
      CAPTURE(askew, roll);
      Setup setup;
      setup.add(make_shape("cylinder", {kRadius, kHeight}), Vec3::Zero(), lying() * spun(-roll));
      const Vec3 up(std::sin(0.3), std::cos(0.3), 0);
      setup.add(make_shape("cylinder", {kRadius, kHeight}), (2 * kRadius + 0.01) * up,
                exp_so3(askew * up) * lying() * spun(roll));
      double lowest = 1, highest = -1;
      for (const ContactPoint& p : setup.contacts()) {
        CHECK(p.d == Approx(0.01).margin(1e-6));
        CHECK((p.n - (p.a == 0 ? up : Vec3(-up))).norm() < 2e-3);
        lowest = std::min(lowest, p.y_b.z());
        highest = std::max(highest, p.y_b.z());
      }
      CHECK(lowest == Approx(-kHeight / 2).margin(1e-3));
      CHECK(highest == Approx(kHeight / 2).margin(1e-3));
    }
  }
}

}  // namespace pabd::test_round_sides
