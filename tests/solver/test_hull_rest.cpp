// SPDX-License-Identifier: MIT
// Hulls in motion: they come to rest under their weight, hull cubes do as boxes do, and a spinning one keeps
// its angular momentum.
#include <catch2/catch.hpp>
#include <random>

#include "sim/math/so3.h"
#include "tests/support/draws.h"
#include "tests/support/hulls.h"
#include "tests/support/scenario.h"

namespace pabd::test_hull_rest {

using testing::hull_of;
using testing::World;

namespace {

Hull rock(int corners, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  std::vector<Vec3> points;
  for (int k = 0; k < corners; ++k) {
    points.push_back(0.5 * testing::draw_vector([&] { return normal(generator); }).normalized());
  }
  return hull_of(points);
}

Hull hull_cube() {
  std::vector<Vec3> points;
  for (int k = 0; k < 8; ++k) points.push_back(0.5 * Vec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1));
  return hull_of(points);
}

}  // namespace

TEST_CASE("dropped rocks come to rest, and the contacts carry the weight") {
  for (const unsigned seed : {1u, 2u, 3u}) {
    World world;
    world.add_ground();
    const double mass = 200;
    world.add(rock(14, seed), mass, {0, 1.2, 0}, exp_so3({0.3, 0.5, -0.4}));
    StepReport last;
    testing::run(world, 900, {false, true, 1}, [&](const StepReport& r) { last = r; });
    INFO("seed " << seed);
    CHECK(last.status != StepStatus::non_finite);
    CHECK(last.kinetic < 1e-6);
    Vec3 force = Vec3::Zero();
    for (const ContactReport& c : last.contact_reports) force += c.normal_force * c.n + c.friction;
    CHECK(last.contact_reports.size() >= 3);
    CHECK((force - Vec3(0, mass * 9.81, 0)).norm() < 1e-3 * mass * 9.81);
    CHECK(last.min_gap > 0);
  }
}

TEST_CASE("a stack of hull cubes stands as one of boxes does") {
  const auto heights = [](bool hulls) {
    World world;
    world.add_ground();
    const Hull cube = hull_cube();
    for (int k = 0; k < 4; ++k) {
      world.add(hulls ? Shape(cube) : Shape(Box{Vec3::Constant(0.5)}), 100, {0, 0.5 + 0.009 + 1.009 * k, 0});
    }
    testing::run(world, 300);
    Vec3 sum = Vec3::Zero();
    for (int k = 1; k <= 4; ++k) {
      CHECK(world.state.v[static_cast<std::size_t>(k)].norm() < 1e-6);
      sum += world.state.c[static_cast<std::size_t>(k)];
    }
    return sum;
  };
  CHECK((heights(true) - heights(false)).norm() < 1e-6);
}

TEST_CASE("a free hull with products in J keeps its angular momentum") {
  World world;
  world.params.gravity.setZero();
  world.add(hull_of({{0, 0, 0}, {1, 0.2, 0}, {0.3, 1.5, 0.1}, {0.2, 0.4, 0.6}}), 10, Vec3::Zero());
  const Mat3 J = world.model.J[0];
  REQUIRE(std::abs(J(0, 1)) > 1e-3 * J.trace());
  world.state.omega[0] = Vec3(1, 2, -0.5);
  const auto momentum = [&] {
    const Mat3& R = world.state.R[0];
    return Vec3(R * (inertia_tensor(J) * (R.transpose() * world.state.omega[0])));
  };
  const Vec3 before = momentum();
  testing::run(world, 600);
  CHECK((momentum() - before).norm() < 1e-9 * before.norm());
}

}  // namespace pabd::test_hull_rest
