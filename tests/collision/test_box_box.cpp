// SPDX-License-Identifier: MIT
// Box manifolds that can be worked out by hand.
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "sim/body/convex_hull.h"
#include "sim/math/so3.h"
#include "tests/collision/reference.h"

namespace pabd::test_box_box {

using namespace reference;

namespace {

const Shape kCube = Box{{0.5, 0.5, 0.5}};

Mat3 turn(double radians, const Vec3& axis) { return Eigen::AngleAxisd(radians, axis).toRotationMatrix(); }

// Cube 1 on cube 0 with the given gap.
Setup stack(double gap, const Mat3& R = Mat3::Identity(), const Vec3& shift = Vec3::Zero()) {
  Setup setup;
  setup.add(kCube, Vec3(0, 0.5, 0), Mat3::Identity(), 0.01);
  setup.add(kCube, Vec3(0, 1.5 + gap, 0) + shift, R, 0.01);
  return setup;
}

std::set<std::uint32_t> features(const std::vector<ContactPoint>& contacts) {
  std::set<std::uint32_t> set;
  for (const auto& p : contacts) set.insert(p.feature);
  return set;
}

}  // namespace

TEST_CASE("two stacked cubes meet at the four corners, above and below zero gap") {
  for (const double gap : {0.009, 0.0, -0.01, -0.2}) {
    const auto contacts = stack(gap).contacts();
    REQUIRE(contacts.size() == 4);
    Vec3 sum = Vec3::Zero();
    for (const auto& p : contacts) {
      CHECK(p.a == 0);
      CHECK(p.d == Approx(gap).margin(1e-14));
      CHECK((p.n - Vec3::UnitY()).norm() < 1e-14);
      CHECK(std::abs(p.y_a.x()) == Approx(0.5).margin(1e-14));
      CHECK(std::abs(p.y_a.z()) == Approx(0.5).margin(1e-14));
      CHECK(p.y_a.y() == Approx(1).margin(1e-14));
      sum += p.y_a;
    }
    CHECK((sum / 4 - Vec3(0, 1, 0)).norm() < 1e-14);
  }
}

TEST_CASE("turned by 45 degrees the overlap is an octagon") {
  const auto contacts = stack(0.005, turn(kPi / 4, Vec3::UnitY())).contacts();
  REQUIRE(contacts.size() == 8);
  // A regular octagon of inner radius 1/2: corners at radius 1/(2 cos 22.5°).
  for (const auto& p : contacts) {
    CHECK(std::hypot(p.y_b.x(), p.y_b.z()) == Approx(0.5 / std::cos(kPi / 8)).epsilon(1e-12));
    CHECK(p.d == Approx(0.005).margin(1e-14));
  }
}

TEST_CASE("four contacts keep their names while a resting cube twists, slides and tilts a little") {
  const auto expected = features(stack(0.005).contacts());
  Random random(3);
  for (int trial = 0; trial < 400; ++trial) {
    const double size = std::pow(10.0, random.uniform(-15, -3));
    const Vec3 shift = random.within(-size, size).cwiseProduct(Vec3(1, 0, 1));
    const auto contacts = stack(0.005, turn(size, random.direction()), shift).contacts();
    INFO("disturbance " << size);
    REQUIRE(contacts.size() == 4);
    REQUIRE(features(contacts) == expected);
    for (const auto& p : contacts) REQUIRE(p.a == 0);  // the lower body keeps the reference face
  }
}

TEST_CASE("contacts of faces of one size move no farther than the bodies") {
  Random random(5);
  for (const bool hulls : {false, true}) {
    for (int trial = 0; trial < 1000; ++trial) {
      // A brick on a brick that is shifted along one of its edges: two pairs of edges lie on each other.
      const Vec3 half = random.within(0.2, 1);
      const Shape shape = hulls ? Shape(hull_of_box(half)) : Shape(Box{half});
      const Vec3 along = half.x() * random.uniform(0, 1.5) * Vec3::UnitX();
      const double size = std::pow(10.0, random.uniform(-15, -6));
      std::vector<ContactPoint> found[2];
      for (auto& contacts : found) {
        Setup setup;
        setup.add(shape, Vec3::Zero(), turn(random.uniform(0, size), random.direction()), 0.01);
        setup.add(shape, along + Vec3(0, 2 * half.y() + 0.005, 0) + random.within(-size, size),
                  turn(random.uniform(0, size), random.direction()), 0.01);
        contacts = setup.contacts();
      }
      INFO("hulls " << hulls << ", trial " << trial << ", moved by " << size);
      REQUIRE(found[0].size() == 4);
      REQUIRE(found[1].size() == 4);
      for (const ContactPoint& p : found[0]) {
        const auto q = std::find_if(found[1].begin(), found[1].end(),
                                    [&](const ContactPoint& other) { return other.feature == p.feature; });
        REQUIRE(q != found[1].end());
        REQUIRE((p.y_a - q->y_a).norm() < 10 * size);
        REQUIRE((p.y_b - q->y_b).norm() < 10 * size);
      }
    }
  }
}

TEST_CASE("the face of the higher body is taken when it is clearly better") {
  // A cube standing on one corner over the face of a body that comes later in the order.
  Setup setup;
  const Mat3 R = rotation_between(Vec3(1, 1, 1), Vec3::UnitY());
  setup.add(kCube, Vec3(0, 0.5 + std::sqrt(0.75) + 0.004, 0), R, 0.01);
  setup.add(kCube, Vec3::Zero(), Mat3::Identity(), 0.01);
  const auto contacts = setup.contacts();
  REQUIRE(contacts.size() == 1);
  CHECK(contacts[0].a == 1);
  CHECK(contacts[0].b == 0);
  CHECK(contacts[0].d == Approx(0.004).margin(1e-13));
  CHECK((contacts[0].y_b - Vec3(0, 0.504, 0)).norm() < 1e-13);
}

TEST_CASE("a brick over the joint of two others rests on both, on four points each") {
  Setup setup;
  const Box brick{{1, 0.5, 0.5}};
  setup.add(brick, Vec3(-1.005, 0, 0), Mat3::Identity(), 0.01);
  setup.add(brick, Vec3(1.005, 0, 0), Mat3::Identity(), 0.01);
  setup.add(brick, Vec3(0, 1.009, 0), Mat3::Identity(), 0.01);
  int on_left = 0, on_right = 0, beside = 0;
  for (const auto& p : setup.contacts()) {
    if (p.a == 0 && p.b == 2) ++on_left;
    if (p.a == 1 && p.b == 2) ++on_right;
    if (p.a == 0 && p.b == 1) ++beside;
    if (p.b == 2) CHECK(p.d == Approx(0.009).margin(1e-13));
    if (p.b == 1) CHECK(p.d == Approx(0.01).margin(1e-13));
    CHECK(p.d < 0.02);
  }
  CHECK(on_left == 4);
  CHECK(on_right == 4);
  CHECK(beside == 4);
}

TEST_CASE("crossed edges touch in one point between them") {
  const double top = std::sqrt(0.5);
  for (const double gap : {0.008, -0.01, -0.05}) {
    Setup setup;
    setup.add(kCube, Vec3(0.1, 0, 0.05), turn(kPi / 4, Vec3::UnitX()), 0.01);
    setup.add(kCube, Vec3(0, 2 * top + gap, 0), turn(kPi / 4, Vec3::UnitZ()), 0.01);
    const auto contacts = setup.contacts();
    REQUIRE(contacts.size() == 1);
    CHECK(contacts[0].d == Approx(gap).margin(1e-13));
    CHECK((contacts[0].n - Vec3::UnitY()).norm() < 1e-13);
    CHECK((contacts[0].y_a - Vec3(0, top, 0.05)).norm() < 1e-13);
    CHECK((contacts[0].y_b - Vec3(0, top + gap, 0.05)).norm() < 1e-13);
  }
}

TEST_CASE("every pair of edges has a name of its own") {
  const double top = std::sqrt(0.5);
  std::set<std::uint32_t> names;
  for (int upper = 0; upper < 4; ++upper)
    for (int lower = 0; lower < 4; ++lower)
      for (const bool turned : {false, true}) {
        const Mat3 R = turned ? turn(kPi / 2, Vec3::UnitZ()) : Mat3::Identity();  // another axis of the cube
        Setup setup;
        setup.add(kCube, Vec3::Zero(), turn(kPi / 4 + kPi / 2 * lower, Vec3::UnitX()), 0.01);
        setup.add(kCube, Vec3(0.01, 2 * top + 0.001, 0.02),
                  turn(kPi / 4 + kPi / 2 * upper, Vec3::UnitZ()) * R, 0.01);
        const auto contacts = setup.contacts();
        REQUIRE(contacts.size() == 1);
        names.insert(contacts[0].feature);
      }
  CHECK(names.size() == 16);  // turning about the edge's own axis permutes the same four edges
}

TEST_CASE("overlapping boxes always have a contact that says so") {
  Random random(77);
  for (int trial = 0; trial < 20000; ++trial) {
    Setup setup;
    const Vec3 half_a = random.within(std::log(0.05), std::log(2.0)).array().exp(),
               half_b = random.within(std::log(0.05), std::log(2.0)).array().exp();
    const Mat3 R_a = random.rotation(), R_b = random.rotation();
    setup.add(Box{half_a}, Vec3::Zero(), R_a, 0.01);
    setup.add(Box{half_b}, random.offset(0, half_a.norm() + half_b.norm()), R_b, 0.01);
    // A point of b inside a proves the overlap; corners and points along the edges are tried.
    bool inside = false;
    for (int k = 0; k < 200 && !inside; ++k) {
      const Vec3 x = setup.c[1] + setup.R[1] * half_b.cwiseProduct(random.within(-1, 1));
      inside = surface_distance(setup.model.shape[0], setup.c[0], setup.R[0], x) < 0;
    }
    if (!inside) continue;
    const auto contacts = setup.contacts();
    INFO("trial " << trial);
    REQUIRE(!contacts.empty());
    REQUIRE(std::any_of(contacts.begin(), contacts.end(), [](const ContactPoint& p) { return p.d < 0; }));
  }
}

TEST_CASE("diagonal neighbours meet at their corners, not on their faces") {
  // Edge to edge across a diagonal gap of (0.003, 0.004): 0.005 along it, where no face of one is over the
  // other.
  Setup setup;
  setup.add(kCube, Vec3::Zero(), Mat3::Identity(), 0.01);
  setup.add(kCube, Vec3(1.003, 1.004, 0), Mat3::Identity(), 0.01);
  const auto contacts = setup.contacts();
  REQUIRE(!contacts.empty());
  for (const auto& p : contacts) {
    CHECK(p.d == Approx(0.005).margin(1e-13));
    CHECK((p.n - Vec3(0.6, 0.8, 0)).norm() < 1e-10);
  }
}

}  // namespace pabd::test_box_box
