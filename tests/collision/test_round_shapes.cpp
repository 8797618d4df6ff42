// SPDX-License-Identifier: MIT
// Spheres, capsules and planes against closed forms, and degenerate placements.
#include <catch2/catch.hpp>

#include "tests/collision/reference.h"

namespace pabd::test_round_shapes {

using namespace reference;

namespace {

constexpr double kTight = 1e-13;

bool close(const Vec3& a, const Vec3& b, double tolerance = kTight) { return (a - b).norm() < tolerance; }

Mat3 turn(double degrees, const Vec3& axis) {
  return Eigen::AngleAxisd(degrees * kPi / 180, axis.normalized()).toRotationMatrix();
}

}  // namespace

TEST_CASE("two spheres") {
  Setup setup;
  setup.add(Sphere{0.5}, Vec3(1, 2, 3));
  setup.add(Sphere{0.25}, Vec3(1, 2.8, 3));
  const auto contacts = setup.contacts();
  REQUIRE(contacts.size() == 1);
  CHECK(contacts[0].a == 0);
  CHECK(contacts[0].d == Approx(0.05).margin(kTight));
  CHECK(close(contacts[0].n, Vec3::UnitY()));
  CHECK(close(contacts[0].y_a, Vec3(1, 2.5, 3)));
  CHECK(close(contacts[0].y_b, Vec3(1, 2.55, 3)));
}

TEST_CASE("solid shapes over a tilted plane: every corner and cap at its closed-form height") {
  Random random(5);
  for (int trial = 0; trial < 200; ++trial) {
    const Vec3 normal = random.direction();
    const double offset = random.uniform(-1, 1);
    const Vec3 above = offset * normal;
    const Vec3 centre = above + random.uniform(0.1, 0.6) * normal;
    const Mat3 R = random.rotation();
    const Vec3 half(0.2, 0.3, 0.4);
    const double radius = 0.25, length = 0.5;

    Setup setup;
    setup.add(Box{half}, centre, R);
    setup.add(Plane{normal, offset}, Vec3::Zero());
    auto contacts = setup.contacts();
    std::size_t expected = 0;
    for (std::uint32_t k = 0; k < 8; ++k) {
      const Vec3 corner =
          centre + R * half.cwiseProduct(Vec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1));
      const double height = normal.dot(corner) - offset;
      if (height >= 0.1) continue;
      REQUIRE(expected < contacts.size());
      const ContactPoint& p = contacts[expected++];
      REQUIRE(p.feature == k);
      REQUIRE(p.a == 1);
      REQUIRE(p.b == 0);
      REQUIRE(close(p.y_b, corner));
      REQUIRE(close(p.n, normal));
      REQUIRE(p.d == Approx(height).margin(kTight));
      REQUIRE(normal.dot(p.y_a) == Approx(offset).margin(kTight));
    }
    REQUIRE(contacts.size() == expected);

    // Under the lower end the bottom of the cap; at the upper end the side of the cylinder, r sin(tilt) below
    // the axis.
    setup.model.shape[0] = Capsule{radius, length};
    contacts = setup.contacts();
    expected = 0;
    const double slope = normal.dot(R.col(1));
    for (std::uint32_t cap = 0; cap < 2; ++cap) {
      const Vec3 end = centre + R * Vec3(0, cap ? length / 2 : -length / 2, 0);
      const bool lower = (slope > 0) == (cap == 0);
      const double drop = lower ? radius : radius * std::sqrt(1 - slope * slope);
      const double height = normal.dot(end) - offset - drop;
      if (height >= 0.1) continue;
      REQUIRE(expected < contacts.size());
      const ContactPoint& p = contacts[expected++];
      REQUIRE(p.feature == cap);
      REQUIRE(p.d == Approx(height).margin(kTight));
      REQUIRE((p.y_b - end).norm() == Approx(radius).margin(kTight));
      REQUIRE(std::abs(surface_distance(setup.model.shape[0], centre, R, p.y_b)) < kTight);
    }
    REQUIRE(contacts.size() == expected);

    setup.model.shape[0] = Sphere{radius};
    contacts = setup.contacts();
    const double height = normal.dot(centre) - offset - radius;
    REQUIRE(contacts.size() == (height < 0.1 ? 1u : 0u));
    if (height < 0.1) REQUIRE(contacts[0].d == Approx(height).margin(kTight));
  }
}

TEST_CASE("parallel capsules touch at both ends of the stretch they share, crossed ones once") {
  Setup setup;
  setup.add(Capsule{0.2, 2.0}, Vec3::Zero());
  setup.add(Capsule{0.3, 1.0}, Vec3(0.52, 0.9, 0), turn(180, Vec3::UnitX()));
  auto contacts = setup.contacts();
  REQUIRE(contacts.size() == 2);  // shared: y from 0.4 to 1.0
  CHECK(close(contacts[0].y_a, Vec3(0.2, 0.4, 0)));
  CHECK(close(contacts[1].y_a, Vec3(0.2, 1.0, 0)));
  for (const auto& p : contacts) {
    CHECK(p.d == Approx(0.02).margin(kTight));
    CHECK(close(p.n, Vec3::UnitX()));
  }

  setup.R[1] = turn(90, Vec3::UnitX());
  contacts = setup.contacts();
  REQUIRE(contacts.size() == 1);
  CHECK(contacts[0].d == Approx(0.02).margin(kTight));
  CHECK(close(contacts[0].y_a, Vec3(0.2, 0.9, 0)));
}

TEST_CASE("a capsule lying on a box touches at both ends, clipped where it overhangs") {
  Setup setup;
  setup.add(Box{{1, 0.5, 1}}, Vec3::Zero());
  setup.add(Capsule{0.25, 1.0}, Vec3(0.2, 0.76, 0.1), turn(90, Vec3::UnitZ()));  // axis along −x
  auto contacts = setup.contacts();
  REQUIRE(contacts.size() == 2);
  for (const auto& p : contacts) {
    CHECK(p.a == 0);
    CHECK(p.d == Approx(0.01).margin(kTight));
    CHECK(close(p.n, Vec3::UnitY()));
  }
  CHECK(close(contacts[0].y_a, Vec3(0.7, 0.5, 0.1)));
  CHECK(close(contacts[1].y_a, Vec3(-0.3, 0.5, 0.1)));
  const auto features = std::make_pair(contacts[0].feature, contacts[1].feature);

  setup.c[1].x() = 0.8;  // x from 0.3 to 1.3: overhangs
  contacts = setup.contacts();
  REQUIRE(contacts.size() == 2);
  CHECK(close(contacts[0].y_a, Vec3(1.0, 0.5, 0.1)));
  CHECK(close(contacts[1].y_a, Vec3(0.3, 0.5, 0.1)));
  CHECK(std::make_pair(contacts[0].feature, contacts[1].feature) == features);

  // A slight tilt must not lose one of the two.
  setup.R[1] = turn(90.05, Vec3::UnitZ());
  CHECK(setup.contacts().size() == 2);
  // Upright: one end.
  setup.R[1] = Mat3::Identity();
  setup.c[1] = Vec3(0, 0.5 + 0.5 + 0.25 + 0.01, 0);
  contacts = setup.contacts();
  REQUIRE(contacts.size() == 1);
  CHECK(contacts[0].d == Approx(0.01).margin(kTight));
}

TEST_CASE("a sphere whose centre is inside a box leaves by the nearest face") {
  Setup setup;
  setup.add(Box{{0.5, 0.5, 0.5}}, Vec3(1, 1, 1));
  setup.add(Sphere{0.1}, Vec3(1.1, 0.7, 1.2));
  const auto contacts = setup.contacts();
  REQUIRE(contacts.size() == 1);
  CHECK(close(contacts[0].n, -Vec3::UnitY()));
  CHECK(contacts[0].d == Approx(-0.2 - 0.1).margin(kTight));
  CHECK(close(contacts[0].y_b, Vec3(1.1, 0.8, 1.2)));
}

TEST_CASE("coincident and flat bodies give finite contacts with unit normals") {
  const Shape shapes[] = {Box{{0.5, 0.5, 0.5}}, Box{{0.5, 0.1, 0.3}}, Sphere{0.5},
                          Capsule{0.2, 0.6},    Capsule{0.3, 0.0},    Box{{1e-9, 0.5, 0.5}}};
  const Mat3 rotations[] = {Mat3::Identity(), turn(45, Vec3::UnitY()), turn(90, Vec3::UnitX()),
                            turn(45, Vec3(1, 1, 1))};
  const Vec3 offsets[] = {Vec3::Zero(),  Vec3(0, 1, 0),      Vec3(0.5, 0.5, 0.5),
                          Vec3(1, 1, 1), Vec3(1e-300, 0, 0), Vec3(1e-9, 1e-12, 0)};
  int found = 0;
  for (const Shape& a : shapes)
    for (const Shape& b : shapes)
      for (const Mat3& R : rotations)
        for (const Vec3& offset : offsets) {
          Setup setup;
          setup.add(a, Vec3(3, 4, 5));
          setup.add(b, Vec3(3, 4, 5) + offset, R);
          const auto contacts = setup.contacts();
          for (const ContactPoint& p : contacts) {
            REQUIRE(p.y_a.allFinite());
            REQUIRE(p.y_b.allFinite());
            REQUIRE(p.n.norm() == Approx(1).margin(1e-12));
            REQUIRE(std::isfinite(p.d));
          }
          if (offset.norm() < 1e-6) REQUIRE(!contacts.empty());
          found += static_cast<int>(contacts.size());
        }
  CHECK(found > 1000);

  Setup spheres;
  spheres.add(Sphere{0.5}, Vec3::Zero());
  spheres.add(Sphere{0.25}, Vec3::Zero());
  const auto contacts = spheres.contacts();
  REQUIRE(contacts.size() == 1);
  CHECK(contacts[0].n == Vec3::UnitY());
  CHECK(contacts[0].d == -0.75);
}

}  // namespace pabd::test_round_shapes
