// SPDX-License-Identifier: MIT
// Cylinders and cones against closed forms: contacts on planes, balls and each other, and rays.
#include <catch2/catch.hpp>

#include "sim/body/compound.h"
#include "sim/body/shape_kind.h"
#include "sim/collision/ray_cast.h"
#include "tests/collision/reference.h"
#include "tests/support/hulls.h"

namespace pabd::test_solid_contacts {

using namespace reference;

namespace {

constexpr double kRadius = 0.4, kHeight = 1.5;

Shape cylinder() { return make_shape("cylinder", {kRadius, kHeight}); }

Mat3 about_y(double angle) { return Eigen::AngleAxisd(angle, Vec3::UnitY()).toRotationMatrix(); }

double smallest(const std::vector<ContactPoint>& contacts) {
  double d = 1e300;
  for (const ContactPoint& p : contacts) d = std::min(d, p.d);
  return d;
}

// Signed distance of a point from a cylinder where it is outside, beside it, above it or off its rim.
double from_cylinder(const Vec3& p) {
  const double across = std::hypot(p.x(), p.z()) - kRadius, above = std::abs(p.y()) - kHeight / 2;
  return across < 0 ? above : above < 0 ? across : std::hypot(across, above);
}

// How far x is outside of a solid whose radius at the height y is `radius`; 0 on its surface.
using Radius = double (*)(double y);
struct Round {
  Shape shape;
  double low, high;
  Radius radius;

  double outside(const Vec3& x) const {
    return std::max({low - x.y(), x.y() - high, std::hypot(x.x(), x.z()) - radius(x.y())});
  }
};

std::vector<Round> solids() {
  return {{cylinder(), -kHeight / 2, kHeight / 2, [](double) { return kRadius; }},
          {make_shape("cone", {kRadius, kHeight}), -kHeight / 4, 3 * kHeight / 4,
           [](double y) { return kRadius * (0.75 - y / kHeight); }}};
}

}  // namespace

TEST_CASE("a round solid above a plane: its lowest point, however it is turned about its axis") {
  Random random(3);
  for (const Round& solid : solids()) {
    for (int k = 0; k < 300; ++k) {
      Setup setup;
      setup.add(Plane{Vec3::UnitY(), 0}, Vec3::Zero(), Mat3::Identity(), 0.05, true);
      const Mat3 turned = random.rotation(), R = turned * about_y(random.uniform(-3, 3));
      double lowest = 0;  // of the rims, in closed form
      for (const double y : {solid.low, solid.high}) {
        const double up = R(1, 1);
        lowest = std::min(lowest, y * up - solid.radius(y) * std::sqrt(std::max(0.0, 1 - up * up)));
      }
      if (std::abs(R(1, 1)) > 0.998) continue;  // upright: not turned
      setup.add(solid.shape, {0, 0.02 - lowest, 0}, R);
      const auto contacts = setup.contacts();
      REQUIRE_FALSE(contacts.empty());
      CHECK(smallest(contacts) == Approx(0.02).epsilon(1e-11));
      for (const ContactPoint& p : contacts) {
        CHECK(std::abs(solid.outside(R.transpose() * (p.y_b - setup.c[1]))) < 1e-12);
      }
    }
  }
}

TEST_CASE("a cylinder that lies has its two ends as contacts, on its lowest line, and rolls no name away") {
  std::uint32_t names[2] = {};
  for (const double roll : {0.0, 0.03, 1.0, 2.5}) {
    Setup setup;
    setup.add(Plane{Vec3::UnitY(), 0}, Vec3::Zero(), Mat3::Identity(), 0, true);
    const Mat3 lying = Eigen::AngleAxisd(kPi / 2, Vec3::UnitZ()).toRotationMatrix();
    setup.add(cylinder(), {0, kRadius + 0.004, 0}, lying * about_y(roll), 0.005);
    const auto contacts = setup.contacts();
    REQUIRE(contacts.size() == 2);
    for (int k = 0; k < 2; ++k) {
      const ContactPoint& p = contacts[static_cast<std::size_t>(k)];
      CHECK(p.d == Approx(0.004).epsilon(1e-12));
      CHECK(std::abs(p.y_b.x()) == Approx(kHeight / 2).epsilon(1e-14));
      CHECK(std::abs(p.y_b.z()) < 1e-15);
      if (roll == 0) names[k] = p.feature;
      CHECK(p.feature == names[k]);
    }
  }
}

TEST_CASE("a ball beside, above and off the rim of a cylinder: the closed form") {
  Random random(5);
  int near = 0;
  for (int k = 0; k < 2000; ++k) {
    const Vec3 p = 1.3 * random.offset(0.3, 1);
    const double d = from_cylinder(p) - 0.1;
    if (d < -0.09 || d > 0.09) continue;
    Setup setup;
    const Mat3 R = random.rotation();
    setup.add(cylinder(), Vec3(1, 2, 3), R);
    setup.add(Sphere{0.1}, Vec3(1, 2, 3) + R * p);
    const auto contacts = setup.contacts();
    REQUIRE(contacts.size() == 1);
    CHECK(contacts[0].d == Approx(d).margin(1e-9));
    ++near;
  }
  CHECK(near > 300);
}

TEST_CASE("cylinders side by side: the distance of their axes") {
  Random random(7);
  for (int k = 0; k < 100; ++k) {
    Setup setup;
    const Mat3 R = random.rotation();
    const Vec3 side = R * Vec3(std::cos(k), 0, std::sin(k));
    setup.add(cylinder(), Vec3::Zero(), R * about_y(random.uniform(-3, 3)));
    setup.add(cylinder(), (2 * kRadius + 0.03) * side + 0.3 * R.col(1), R * about_y(random.uniform(-3, 3)));
    const auto contacts = setup.contacts();
    REQUIRE(contacts.size() >= 2);
    CHECK(smallest(contacts) == Approx(0.03).epsilon(1e-9));
  }
}

TEST_CASE("round solids whose axes meet are not turned by rounding") {
  Random random(8);
  for (int k = 0; k < 40; ++k) {
    const Mat3 R_a = random.rotation(), R_b = random.rotation();
    const auto contacts_at = [&](const Vec3& c) {
      Setup setup;
      setup.add(make_shape("cone", {kRadius, kHeight}), Vec3::Zero(), R_a);
      setup.add(make_shape("cone", {0.3, 0.9}), c, R_b);
      return setup.contacts();
    };
    const auto exactly = contacts_at(Vec3::Zero()), nearly = contacts_at(random.within(-1e-14, 1e-14));
    CAPTURE(k);
    REQUIRE_FALSE(exactly.empty());
    REQUIRE(nearly.size() == exactly.size());
    for (std::size_t i = 0; i < exactly.size(); ++i) {
      CHECK(nearly[i].feature == exactly[i].feature);
      CHECK((nearly[i].n - exactly[i].n).norm() < 1e-10);
    }
  }
}

TEST_CASE("a round solid on a box and on the hull of that box is as on a plane") {
  const Mat3 lying = Eigen::AngleAxisd(kPi / 2, Vec3::UnitZ()).toRotationMatrix();
  for (const Shape& floor : {Shape(Box{{3, 0.5, 3}}), hull_of_box({3, 0.5, 3})}) {
    for (const double roll : {0.0, 0.05, 1.7}) {
      Setup setup;
      setup.add(floor, {0, -0.5, 0}, Mat3::Identity(), 0.001, true);
      setup.add(cylinder(), {0, kRadius + 0.01, 0}, lying * about_y(roll), 0.01);
      const auto contacts = setup.contacts();
      REQUIRE(contacts.size() == 2);
      CHECK(contacts[0].d == Approx(0.01).epsilon(1e-9));
      CHECK(contacts[1].d == Approx(0.01).epsilon(1e-9));
    }
  }
}

TEST_CASE("a cylinder that lies on a compound, across its parts and on one of them, is as on a plane") {
  const auto slab = [](double from, double to) {
    std::vector<Vec3> corners;
    for (int k = 0; k < 8; ++k) corners.emplace_back(k & 1 ? from : to, k & 2 ? 0 : -1, k & 4 ? 3 : -3);
    return testing::hull_of(corners);
  };
  const Mat3 along_x = Eigen::AngleAxisd(kPi / 2, Vec3::UnitZ()).toRotationMatrix();
  for (const double x : {0.1, 1.6}) {
    for (const double roll : {0.0, 1.3}) {
      Setup setup;
      setup.add(make_compound({slab(-3, 0), slab(0, 3)}), {0, -0.5, 0}, Mat3::Identity(), 0.001, true);
      setup.add(cylinder(), {x, kRadius + 0.01, 0}, along_x * about_y(roll), 0.01);
      const auto contacts = setup.contacts();
      REQUIRE(contacts.size() >= 2);
      double lo = 1e9, hi = -1e9;
      for (const ContactPoint& p : contacts) {
        CHECK(p.d == Approx(0.01).epsilon(1e-9));
        lo = std::min(lo, p.y_b.x());
        hi = std::max(hi, p.y_b.x());
      }
      CHECK(lo == Approx(x - kHeight / 2).epsilon(1e-9));
      CHECK(hi == Approx(x + kHeight / 2).epsilon(1e-9));
    }
  }
}

TEST_CASE("ray and round solids: the first point on the surface, and none before it") {
  Random random(11);
  for (const Round& solid : solids()) {
    int hits = 0, misses = 0;
    for (int k = 0; k < 3000; ++k) {
      const Vec3 o = 3 * random.direction();
      const Vec3 u = (random.offset(0, 1.2) - o).normalized();
      const auto hit = ray_cast(solid.shape, Vec3::Zero(), Mat3::Identity(), {o, u});
      double least = 1e300;  // of how far it is outside, before the hit
      const double end = hit ? hit->t - 1e-9 : 6;
      for (int i = 0; i < 400; ++i) least = std::min(least, solid.outside(o + (end * i / 400) * u));
      CHECK(least > 0);
      if (!hit) {
        ++misses;
        continue;
      }
      ++hits;
      const Vec3 x = o + hit->t * u;
      CHECK(std::abs(solid.outside(x)) < 1e-12);
      // The normal is the gradient of how far it is outside, away from the rims.
      Vec3 gradient;
      for (int i = 0; i < 3; ++i) {
        const Vec3 e = 1e-6 * Vec3::Unit(i);
        gradient[i] = (solid.outside(x + e) - solid.outside(x - e)) / 2e-6;
      }
      const bool smooth = std::abs(gradient.norm() - 1) < 1e-4 || std::hypot(x.x(), x.z()) > 0.05;
      if (smooth && solid.outside(x + 1e-5 * hit->normal) > 0 && hit->normal.dot(u) < -0.01)
        CHECK((gradient.normalized() - hit->normal).norm() < 0.02);
    }
    CHECK(hits > 500);
    CHECK(misses > 500);
  }
}

TEST_CASE("rays along and across a cylinder, from inside, and from far away") {
  const auto cast = [](const Shape& shape, const Vec3& o, const Vec3& u) {
    return ray_cast(shape, Vec3::Zero(), Mat3::Identity(), {o, u});
  };
  const auto side = cast(cylinder(), {-500, 0.3, 0}, Vec3::UnitX());
  REQUIRE(side);
  CHECK(side->t == Approx(500 - kRadius).epsilon(1e-14));
  CHECK((side->normal + Vec3::UnitX()).norm() < 1e-12);
  const auto top = cast(cylinder(), {0.1, 9, 0.2}, -Vec3::UnitY());
  REQUIRE(top);
  CHECK(top->t == Approx(9 - kHeight / 2).epsilon(1e-14));
  CHECK(top->normal == Vec3::UnitY());
  const auto inside = cast(cylinder(), {0, 0.2, 0}, Vec3::UnitZ());
  REQUIRE(inside);
  CHECK(inside->t == Approx(kRadius).epsilon(1e-14));
  CHECK_FALSE(cast(cylinder(), {0.41, 9, 0}, -Vec3::UnitY()));
  CHECK_FALSE(cast(cylinder(), {-9, 0.76, 0}, Vec3::UnitX()));
}

}  // namespace pabd::test_solid_contacts
