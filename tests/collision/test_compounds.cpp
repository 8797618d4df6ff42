// SPDX-License-Identifier: MIT
// Compounds: the contacts of their parts, under names of their own.
#include <catch2/catch.hpp>
#include <set>

#include "sim/body/compound.h"
#include "sim/body/convex_hull.h"
#include "sim/math/so3.h"
#include "tests/collision/reference.h"

namespace pabd::test_compounds {

using namespace reference;

namespace {

Hull box(const Vec3& lo, const Vec3& hi) {
  std::vector<Vec3> points;
  for (int k = 0; k < 8; ++k) {
    points.emplace_back(k & 1 ? hi.x() : lo.x(), k & 2 ? hi.y() : lo.y(), k & 4 ? hi.z() : lo.z());
  }
  return Hull{make_hull(points).hull};
}

// Three bars that cross, 1 long and 0.2 thick.
Shape jack() {
  const Vec3 x(0.5, 0.1, 0.1), y(0.1, 0.5, 0.1), z(0.1, 0.1, 0.5);
  return make_compound({box(-x, x), box(-y, y), box(-z, z)});
}

double smallest(const std::vector<ContactPoint>& contacts) {
  double d = 1e300;
  for (const ContactPoint& p : contacts) d = std::min(d, p.d);
  return d;
}

void check_names(const std::vector<ContactPoint>& contacts) {
  std::set<std::uint32_t> names;
  for (const ContactPoint& p : contacts) {
    CHECK(names.insert(p.feature).second);
    CHECK(p.feature < 0x80000000u);  // the top bit belongs to the friction memory
    CHECK((p.y_b - p.y_a - p.d * p.n).norm() < 1e-12);
  }
}

}  // namespace

TEST_CASE("a jack on a plane stands on the ends of three bars") {
  Setup setup;
  setup.add(Plane{Vec3::UnitY(), 0}, Vec3::Zero(), Mat3::Identity(), 0.01, true);
  const Mat3 R = rotation_between(Vec3(-1, -1, -1), Vec3(0, -1, 0));
  setup.add(jack(), Vec3::Zero(), R, 0.01);
  const double low = support(hull_of_box({0.5, 0.1, 0.1}), Vec3::Zero(), R, -Vec3::UnitY());
  setup.c[1].y() = low + 0.005;
  const auto contacts = setup.contacts();
  REQUIRE(contacts.size() == 3);
  for (const ContactPoint& p : contacts) {
    CHECK(p.a == 0);
    CHECK(p.d == Approx(0.005).epsilon(1e-9));
    CHECK((p.n - Vec3::UnitY()).norm() < 1e-15);
  }
  check_names(contacts);
}

TEST_CASE("the smallest distance is that of the nearest part, for every other shape, either order") {
  Random random(5);
  const Shape compound = jack();
  const auto& parts = std::get<Compound>(compound).data->parts;
  const std::vector<Shape> others = {Box{{0.3, 0.2, 0.4}}, Sphere{0.3}, Capsule{0.2, 0.5}, rock(12, 0.4, 3)};
  int met = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const Shape& other = others[static_cast<std::size_t>(trial) % others.size()];
    const Vec3 c = random.offset(0.2, 1), at(3, -1, 2);
    const Mat3 R_a = random.rotation(), R_b = random.rotation();
    Setup setup, turned;
    setup.add(compound, at, R_a);
    setup.add(other, at + c, R_b);
    turned.add(other, at + c, R_b);
    turned.add(compound, at, R_a);
    double nearest = 1e300;
    for (const CompoundPart& part : parts) {
      Setup single;
      single.add(part.hull(), at + R_a * part.offset, R_a);
      single.add(other, at + c, R_b);
      nearest = std::min(nearest, smallest(single.contacts()));
    }
    const auto contacts = setup.contacts();
    met += contacts.empty() ? 0 : 1;
    INFO("trial " << trial);
    CHECK((contacts.empty() ? nearest == 1e300 : smallest(contacts) == Approx(nearest).epsilon(1e-12)));
    // The lower body's face is preferred by a hair, so only the distance is the same, up to that hair.
    const auto swapped = turned.contacts();
    CHECK(swapped.empty() == contacts.empty());
    if (!contacts.empty()) CHECK(smallest(swapped) == Approx(nearest).epsilon(0.03).margin(1e-3));
    check_names(contacts);
  }
  CHECK(met > 100);
}

TEST_CASE(
    "two compounds: every pair of parts is tried, names last from step to step, threads do not matter") {
  Random random(8);
  int met = 0;
  for (int trial = 0; trial < 200; ++trial) {
    Setup setup;
    setup.add(jack(), Vec3(1, 1, 1), random.rotation());
    const Vec3 offset = random.offset(0.3, 1);
    setup.add(jack(), Vec3(1, 1, 1) + offset, random.rotation());
    const auto contacts = setup.contacts();
    check_names(contacts);
    met += contacts.empty() ? 0 : 1;
    const auto again = setup.contacts(4);
    REQUIRE(again.size() == contacts.size());
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      CHECK(again[k].feature == contacts[k].feature);
      CHECK(again[k].y_b == contacts[k].y_b);
    }
    setup.c[1] += Vec3(1e-9, -2e-9, 1e-9);
    std::set<std::uint32_t> before, after;
    for (const ContactPoint& p : contacts) before.insert(p.feature);
    for (const ContactPoint& p : setup.contacts()) after.insert(p.feature);
    CHECK(before == after);
  }
  CHECK(met > 80);
}

}  // namespace pabd::test_compounds
