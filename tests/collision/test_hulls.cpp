// SPDX-License-Identifier: MIT
// Hulls against the boxes they look like, large manifolds, and degenerate placements.
#include <catch2/catch.hpp>
#include <set>

#include "sim/body/convex_hull.h"
#include "tests/collision/reference.h"

namespace pabd::test_hulls {

using namespace reference;

namespace {

Mat3 turn(double radians, const Vec3& axis) { return Eigen::AngleAxisd(radians, axis).toRotationMatrix(); }

// Every contact of one list has its equal, but for the name, in the other; points may be `apart`.
bool same(const std::vector<ContactPoint>& x, const std::vector<ContactPoint>& y, double apart = 1e-9) {
  if (x.size() != y.size()) return false;
  for (const ContactPoint& p : x) {
    bool found = false;
    for (const ContactPoint& q : y) {
      found = found || (p.a == q.a && std::abs(p.d - q.d) < apart && (p.n - q.n).norm() < 1e-9 &&
                        (p.y_b - q.y_b).norm() < apart && (p.y_a - q.y_a).norm() < apart);
    }
    if (!found) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("boxes as hulls have the contacts of boxes, in random poses") {
  Random random(31);
  int compared = 0, equal = 0;
  for (int trial = 0; compared < 3000; ++trial) {
    const Vec3 half_a = random.within(0.2, 0.8), half_b = random.within(0.2, 0.8);
    // Every third pair is nearly parallel, as in stacks.
    const Mat3 R_a = random.rotation();
    const Mat3 R_b = trial % 3 == 0 ? Mat3(R_a * random.turn(0.01)) : random.rotation();
    const Vec3 offset = random.offset(0.3, half_a.norm() + half_b.norm());
    const auto contacts = [&](const Shape& a, const Shape& b) {
      Setup setup;
      setup.add(a, Vec3(1, 2, 3), R_a, 0.02);
      setup.add(b, Vec3(1, 2, 3) + offset, R_b, 0.02);
      return setup.contacts();
    };
    const auto boxes = contacts(Box{half_a}, Box{half_b});
    INFO("trial " << trial << ", contacts of the boxes " << boxes.size());
    if (boxes.empty() && trial % 8 != 0) continue;
    const Shape hull_a = hull_of_box(half_a), hull_b = hull_of_box(half_b);
    ++compared;
    // Two corners of one name may stand for each other: at most a snap distance apart.
    const double snap = 0.02 * std::min(half_a.minCoeff(), half_b.minCoeff());
    for (const auto& hulls :
         {contacts(hull_a, hull_b), contacts(hull_a, Box{half_b}), contacts(Box{half_a}, hull_b)}) {
      REQUIRE(same(boxes, hulls, 2 * snap));
      equal += same(boxes, hulls) ? 1 : 0;
    }
  }
  CHECK(equal > 3 * compared - 30);
}

TEST_CASE("box hulls meet planes, spheres and capsules as boxes do") {
  Random random(32);
  int found = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const Vec3 half = random.within(0.2, 0.8);
    const Mat3 R_a = random.rotation(), R_b = random.rotation();
    const Shape others[] = {Sphere{0.3}, Plane{Vec3::UnitY(), 0.1}};
    const Vec3 offset = random.offset(0.1, 1.5);
    const Shape hull = hull_of_box(half);
    for (const Shape& other : others) {
      const auto contacts = [&](const Shape& a) {
        Setup setup;
        setup.add(a, offset, R_a);
        setup.add(other, Vec3::Zero(), R_b);
        return setup.contacts();
      };
      const auto as_box = contacts(Box{half}), as_hull = contacts(hull);
      REQUIRE(same(as_box, as_hull));
      found += static_cast<int>(as_box.size());
    }
  }
  CHECK(found > 1000);
}

TEST_CASE("a round manifold keeps eight points, the deepest among them, spread all around") {
  for (const bool on_box : {false, true}) {
    Setup setup;
    setup.add(prism(40, 0.5, 0.2), Vec3(0, 0.2 - 0.001, 0), turn(1e-4, Vec3::UnitX()), 0.01);
    if (on_box) {
      setup.add(Box{{2, 1, 2}}, Vec3(0, -1, 0), Mat3::Identity(), 0.01);
    } else {
      setup.add(Plane{Vec3::UnitY(), 0}, Vec3::Zero(), Mat3::Identity(), 0.01);
    }
    const auto contacts = setup.contacts();
    REQUIRE(contacts.size() == 8);
    double deepest = 1;
    Vec3 sum = Vec3::Zero();
    std::set<std::uint32_t> names;
    for (const ContactPoint& p : contacts) {
      deepest = std::min(deepest, p.d);
      sum += p.y_b;
      names.insert(p.feature);
    }
    CHECK(names.size() == 8);
    CHECK(deepest == Approx(-0.001 - 0.5e-4).margin(2e-6));
    CHECK(sum.norm() / 8 < 0.1);  // of a radius of 0.5: no side is left out
  }
}

TEST_CASE("four contacts of two stacked hull cubes keep their names through small motions") {
  Random random(33);
  const Shape cube = hull_of_box(Vec3::Constant(0.5));
  const auto stack = [&](const Mat3& R, const Vec3& shift) {
    Setup setup;
    setup.add(cube, Vec3(0, 0.5, 0), Mat3::Identity(), 0.01);
    setup.add(cube, Vec3(0, 1.505, 0) + shift, R, 0.01);
    return setup.contacts();
  };
  std::set<std::uint32_t> expected;
  for (const auto& p : stack(Mat3::Identity(), Vec3::Zero())) expected.insert(p.feature);
  REQUIRE(expected.size() == 4);
  for (int trial = 0; trial < 400; ++trial) {
    const double size = std::pow(10.0, random.uniform(-15, -3));
    std::set<std::uint32_t> names;
    const Vec3 shift(random.uniform(-size, size), 0, 0);
    for (const auto& p : stack(turn(size, random.direction()), shift)) {
      REQUIRE(p.a == 0);
      names.insert(p.feature);
    }
    INFO("disturbance " << size);
    REQUIRE(names == expected);
  }
}

TEST_CASE("degenerate placements of hulls give finite contacts") {
  const Shape cube = hull_of_box(Vec3::Constant(0.5));
  const Shape shapes[] = {cube,        rock(4, 0.5, 1),   rock(60, 0.5, 2),     prism(30, 0.5, 0.5),
                          Sphere{0.4}, Capsule{0.2, 0.6}, Box{{0.5, 0.5, 0.5}}, Plane{Vec3::UnitY(), 0}};
  const Vec3 offsets[] = {Vec3::Zero(),  Vec3(1e-16, 0, 0), Vec3(0.5, 0, 0),  Vec3(1, 0, 0),  Vec3(1, 1, 0),
                          Vec3(1, 1, 1), Vec3(0, 0.7, 0),   Vec3(1e-9, 1, 0), Vec3(0, 1e8, 0)};
  for (const Shape& a : shapes) {
    for (const Shape& b : shapes) {
      for (const Vec3& offset : offsets) {
        for (const double angle : {0.0, 1e-12, kPi / 4, kPi / 2}) {
          Setup setup;
          setup.add(a, offset, turn(angle, Vec3::UnitZ()));
          setup.add(b, Vec3::Zero());
          for (const ContactPoint& p : setup.contacts()) {
            REQUIRE((p.y_a.allFinite() && p.y_b.allFinite() && std::isfinite(p.d)));
            REQUIRE(p.n.norm() == Approx(1).margin(1e-9));
          }
        }
      }
    }
  }
}

}  // namespace pabd::test_hulls
