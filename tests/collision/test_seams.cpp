// SPDX-License-Identifier: MIT
// Edges that a neighbour hides, and edges that it does not.
#include <catch2/catch.hpp>

#include "sim/body/compound.h"
#include "sim/body/convex_hull.h"
#include "sim/collision/detect.h"
#include "tests/collision/reference.h"

namespace pabd::test_seams {

using namespace reference;

namespace {

constexpr double kTouching = 0.01;

// Contacts of the last body, which does not move. Two tiles meet at x = 0; the second one lies deeper by `step`.
std::vector<ContactPoint> contacts(const Setup& setup) {
  const std::vector<Vec3> way(setup.c.size(), Vec3::Zero()), turn = way;
  const std::vector<double> spin(setup.c.size(), 0.0);
  const Passage passage{setup.c, setup.R, way, turn, spin, kTouching};
  CollisionWorkspace workspace;
  std::vector<ContactPoint> out;
  detect(setup.model, setup.c, setup.R, passage, setup.reach, {}, 1, workspace, out);
  return out;
}
Setup tiles(double step) {
  Setup setup;
  setup.add(Box{{1, 0.1, 1}}, {-1, -0.1, 0}, Mat3::Identity(), 0.01, true);
  setup.add(Box{{1, 0.1, 1}}, {1, -0.1 - step, 0}, Mat3::Identity(), 0.01, true);
  return setup;
}

}  // namespace

TEST_CASE("a ball before a flush seam feels the tile under it alone, and both where it is over the seam") {
  for (const double x : {-0.05, -0.01, -1e-4}) {
    Setup setup = tiles(0);
    setup.add(Sphere{0.3}, {x, 0.3095, 0}, Mat3::Identity(), 0.01);
    const auto found = contacts(setup);
    CAPTURE(x);
    REQUIRE(found.size() == 1);
    CHECK(found[0].a == 0);
    CHECK(found[0].n == Vec3(0, 1, 0));
  }
  Setup setup = tiles(0);
  setup.add(Sphere{0.3}, {0, 0.3095, 0}, Mat3::Identity(), 0.01);
  CHECK(contacts(setup).size() == 2);
}

TEST_CASE("an edge that stands out is felt") {
  Setup setup = tiles(0.02);  // the first tile's edge stands out by more than lies in the same surface
  setup.add(Sphere{0.3}, {0.05, 0.29, 0}, Mat3::Identity(), 0.01);
  const auto found = contacts(setup);
  REQUIRE(found.size() == 2);
  CHECK(found[0].n.x() > 0.1);
  CHECK(found[1].n == Vec3(0, 1, 0));
}

TEST_CASE("parts of a compound hide each other's edges") {
  const auto box = [](double x) {
    std::vector<Vec3> corners;
    for (const double sx : {-1.0, 1.0})
      for (const double sy : {-0.1, 0.1})
        for (const double sz : {-1.0, 1.0}) corners.emplace_back(x + sx, sy, sz);
    return Hull{make_hull(corners).hull};
  };
  Setup setup;
  setup.add(make_compound({box(-1), box(1)}), {0, -0.1, 0}, Mat3::Identity(), 0.01, true);
  setup.add(Sphere{0.3}, {-0.05, 0.3095, 0}, Mat3::Identity(), 0.01);
  const auto found = contacts(setup);
  REQUIRE(found.size() == 1);
  CHECK((found[0].n - Vec3(0, 1, 0)).norm() < 1e-12);
}

}  // namespace pabd::test_seams
