// SPDX-License-Identifier: MIT
// Deep overlap comes apart at contact.recovery_speed, and nothing else is touched by it.

#include <catch2/catch.hpp>
#include <cstring>

#include "sim/math/so3.h"

#include "tests/support/scenario.h"

namespace pabd::test_recovery {

namespace {

// Two cubes in weightlessness, `deep` in each other along y.
testing::World overlapping(double deep) {
  testing::World world;
  world.params.gravity.setZero();
  world.add_cube(1, 1000, {0, 0, 0});
  world.add_cube(1, 1000, {0.1, 1 - deep, -0.05});
  return world;
}

double speed_apart(const testing::World& world) { return (world.state.v[1] - world.state.v[0]).norm(); }

bool same_bytes(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  return std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)) == 0;
}

}  // namespace

TEST_CASE("overlapping cubes come apart at the speed asked for, whatever step and stiffness") {
  const auto h = GENERATE(1.0 / 60, 1.0 / 240, 1.0 / 1000);
  const auto kappa = GENERATE(0.0, 5.0, 5e5);
  const auto deep = GENERATE(0.5, 0.07);
  const auto method = GENERATE(SolverMethod::automatic, SolverMethod::descent);
  constexpr double kSpeed = 1.5;
  testing::World world = overlapping(deep);
  world.params.h = h;
  if (kappa > 0) world.params.contact.kappa = kappa;
  world.params.contact.recovery_speed = kSpeed;
  world.params.solver.method = method;
  CAPTURE(h, kappa, deep, to_string(method));
  double fastest = 0, longest = 0, gap = 0;
  const auto between = [&] { return Vec3(world.state.c[1] - world.state.c[0]); };
  Vec3 before = between();
  testing::run(world, static_cast<int>(1.2 * deep / kSpeed / h) + 10, {}, [&](const StepReport& r) {
    fastest = std::max(fastest, speed_apart(world));
    longest = std::max(longest, (between() - before).norm());
    before = between();
    gap = r.min_gap;
  });
  CHECK(fastest <= 1.03 * kSpeed);  // a solve that stops early may be 2 % beyond
  CHECK(longest >= 0.5 * kSpeed * h);
  CHECK(gap > 0);
}

TEST_CASE("without a limit they fly apart") {
  testing::World world = overlapping(0.5);
  world.params.h = 1.0 / 240;
  world.params.contact.recovery_speed = 0;
  testing::run(world, 40);
  CHECK(speed_apart(world) > 20);
}

TEST_CASE("a crate deep in the ground rises under its load") {
  const auto h = GENERATE(1.0 / 60, 1.0 / 1000);
  testing::World world;
  world.params.h = h;
  world.params.contact.recovery_speed = 0.8;
  world.add_ground();
  world.add_cube(1, 500, {0, 0.3, 0});
  world.add_cube(1, 500, {0, 1.31, 0});
  double fastest = 0;
  // The upper one may bounce off the one that rises.
  testing::run(world, static_cast<int>(1.0 / h), {},
               [&](const StepReport&) { fastest = std::max(fastest, world.state.v[1].y()); });
  CAPTURE(h);
  CHECK(fastest <= 1.03 * 0.8);
  CHECK(world.state.c[1].y() > 0.5);
}

TEST_CASE("what is not deep does not change by a bit") {
  const auto speed = GENERATE(0.01, 3.0, 1e6);
  testing::World plain, limited;
  for (auto* world : {&plain, &limited}) {
    world->add_ground();
    world->add_cube(1, 100, {0, 0.9, 0}, exp_so3({0.3, 0.1, 0.2}));
    world->add_cube(0.5, 30, {0.1, 2.2, 0});
    world->add(Sphere{0.3}, 20, {0.5, 3.0, 0.4});
    world->params.h = 1.0 / 120;
  }
  plain.params.contact.recovery_speed = 0;
  limited.params.contact.recovery_speed = speed;
  double deepest = 0;
  testing::run(plain, 150, {}, [&](const StepReport& r) { deepest = std::max(deepest, r.max_penetration); });
  testing::run(limited, 150);
  REQUIRE(deepest < 2 * plain.params.contact.d_hat);
  CHECK(same_bytes(plain.state.c, limited.state.c));
  CHECK(same_bytes(plain.state.v, limited.state.v));
}

}  // namespace pabd::test_recovery
