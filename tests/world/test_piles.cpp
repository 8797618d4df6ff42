// SPDX-License-Identifier: MIT
// Heaps, stacks and what falls into them: no energy is made, nothing sinks in, nothing hangs in the air, and the floor
// carries the weight of all.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "sim/body/shape_kind.h"
#include "tests/world/world.h"

namespace pabd::test_piles {

using namespace world;

namespace {

spec::Pile poured(const char* shape, int count, const Vec3& size, int seed) {
  return {.count = count,
          .shape = shape,
          .size = size,
          .position = Vec3(0, 0.1, 0),
          .density = 600,
          .seed = seed};
}

// What a heap that was poured must be, some seconds later: no step made energy, and all have fallen, none through the floor.
void check_heap(Run& run, double seconds, double thickness) {
  run.go(seconds);
  CAPTURE(run.held, run.halved);
  CHECK(run.rise < 1e-6 * run.begin);
  CHECK(run.unsolved <= run.steps / 25);
  CHECK(run.report.potential < 0.4 * run.begin);
  for (std::size_t i = 1; i < run.state.c.size(); ++i) CHECK(run.state.c[i].y() > 0.3 * thickness);
}

}  // namespace

// Long thin boxes are the hard case of every engine: Bullet's and Jolt's threads on rods and planks; T1 of the findings.
TEST_CASE("planks that are poured fall in a heap and make no energy") {
  const double length = GENERATE(0.6, 1.3, 3.0), thin = GENERATE(0.05, 0.12),
               h = GENERATE(1.0 / 30, 1.0 / 60, 1.0 / 240);
  CAPTURE(length, thin, h);
  Setting setting(h);
  setting.ground();
  setting.builder.add(poured("box", 27, {length, thin, 1.5 * thin}, static_cast<int>(7 * length)));
  Run run(setting);
  check_heap(run, 4, thin);
}

TEST_CASE(
    "long thin capsules that are poured make no energy, stay out of each other and come to lie on the "
    "floor") {
  const double length = GENERATE(0.8, 4.0), h = GENERATE(1.0 / 30, 1.0 / 60, 1.0 / 240);
  CAPTURE(length, h);
  Setting setting(h);
  setting.ground();
  setting.builder.add(poured("capsule", 30, {length, 0.1, 0.1}, 5));
  Run run(setting);
  check_heap(run, 4, 0.075);
}

namespace {

// Coins of 24 mm.
const Shape kCoin = make_shape("cylinder", {0.012, 0.002});

}  // namespace

// A roll of coins that falls apart from rest: T1 of the findings.
TEST_CASE("a stack of coins stays where it is") {
  const int count = GENERATE(6, 12);
  const double shift = GENERATE(0.0, 0.0004), h = GENERATE(1.0 / 30, 1.0 / 60), d_hat = 0.0002;
  CAPTURE(count, shift, h);
  Setting setting(h, 0.5, d_hat);
  setting.ground();
  for (int k = 0; k < count; ++k)
    setting.add(spec::Body{.shape = kCoin,
                           .density = 8000,
                           .position = Vec3(shift * (k % 3), 0.001 + d_hat + (0.002 + d_hat) * k, 0)});
  Run run(setting);
  run.go(2);
  for (int k = 1; k <= count; ++k) {
    const std::string coin = "b" + std::to_string(k);
    CHECK(run.way(coin).norm() < d_hat * k);
    CHECK(run.R(coin)(1, 1) > 0.9999);
  }
  CHECK(run.kinetic() < 1e-9 * run.weight() * 0.001);
  CHECK(run.carried() == Approx(run.weight()).epsilon(1e-3));
}

TEST_CASE("coins that are poured fall in a heap and make no energy") {
  const auto [seed, h] = GENERATE(table<unsigned, double>({{1u, 1.0 / 30}, {2u, 1.0 / 60}, {3u, 1.0 / 240}}));
  CAPTURE(seed, h);
  std::mt19937 rng(seed);
  std::uniform_real_distribution<double> one(-1, 1);
  Setting setting(h, 0.4, 0.0002);
  setting.ground();
  for (int k = 0; k < 12; ++k) {
    const double x = 0.01 * one(rng), z = 0.01 * one(rng), angle = 60 * one(rng);
    setting.add(spec::Body{.shape = kCoin,
                           .density = 8000,
                           .position = Vec3(x, 0.02 + 0.025 * k, z),
                           .orientation = spec::AxisAngle{Vec3(1, 0, 0.4), angle}});
  }
  Run run(setting);
  check_heap(run, 0.9, 0.002);
}

// A heavy body on light ones: erwincoumans/experiments issue 4 (Bullet), godot-jolt issue 1041, reactphysics3d issue 329.
TEST_CASE("stacks stand for every ratio of masses, heavy ones above or below") {
  const double ratio = GENERATE(0.001, 0.01, 100.0, 1000.0), edge = GENERATE(0.1, 1.0),
               h = GENERATE(1.0 / 30, 1.0 / 60, 1.0 / 240);
  const int levels = GENERATE(2, 5);
  CAPTURE(ratio, edge, h, levels);
  const double d_hat = 0.01 * edge;
  Setting setting(h, 0.5, d_hat);
  setting.ground();
  for (int k = 0; k < levels; ++k)
    setting.add(Box{Vec3::Constant(edge / 2)}, k == levels - 1 ? ratio : 1.0,
                {0.03 * edge * (k % 2), (edge + d_hat) * (k + 1) - edge / 2, 0});
  Run run(setting);
  run.go(3);
  for (int k = 1; k <= levels; ++k) CHECK(run.way("b" + std::to_string(k)).norm() < 0.3 * d_hat * k);
  CHECK(run.kinetic() < 1e-9 * run.weight() * edge);
  CHECK(run.carried() == Approx(run.weight()).epsilon(1e-4));
  CHECK(run.rise < 1e-9 * run.weight() * edge);
}

TEST_CASE("a heavy drum stands on a light cube") {
  const double mass = GENERATE(6.0, 60.0, 600.0), h = GENERATE(1.0 / 60, 1.0 / 120);
  CAPTURE(mass, h);
  Setting setting(h);
  setting.ground();
  const std::string cube = setting.add(Box{Vec3::Constant(0.5)}, 1, {0, 0.51, 0});
  const std::string drum = setting.add(make_shape("cylinder", {0.4, 1.5}), mass, {0.05, 1.77 + 0.3, 0.02});
  Run run(setting);
  run.go(4);
  CHECK(run.c(cube).y() > 0.495);
  CHECK(run.c(drum).y() == Approx(1.77).margin(0.02));
  CHECK(run.R(drum)(1, 1) > 0.9999);
  CHECK(run.kinetic() < 1e-9 * mass);
}

// T12 of the findings: a ball that is let down on light boxes sinks into them.
TEST_CASE("a heavy ball lies on a bed of light boxes without sinking into them") {
  struct Bed {
    int layers;
    double mass;
  };
  const Bed bed = GENERATE(Bed{2, 100}, Bed{2, 1e4}, Bed{2, 1e6}, Bed{4, 1e4}, Bed{4, 1e5});
  const double mass = bed.mass, h = GENERATE(1.0 / 60, 1.0 / 240), drop = GENERATE(0.0, 0.05);
  CAPTURE(bed.layers, mass, h, drop);
  Setting setting(h);
  setting.ground();
  for (int k = 0; k < 16 * bed.layers; ++k)
    setting.add(Box{Vec3::Constant(0.1)}, 1,
                {0.21 * (k % 4 - 1.5), 0.11 + 0.21 * (k / 16), 0.21 * (k / 4 % 4 - 1.5)});
  const std::string ball =
      setting.add(Sphere{0.35}, mass, {0, 0.01 + 0.21 * bed.layers + 0.35 + 0.01 + drop, 0});
  Run run(setting);
  run.go(2);  // it bounces first
  // The place between four boxes is no stable one: rounding grows until they sway. So over a second, not at its end.
  double carried = 0;
  int steps = 0;
  run.go(1, [&] {
    carried += run.carried();
    ++steps;
  });
  CHECK(run.overlap < 0.001);
  CHECK(carried / steps == Approx(run.weight()).epsilon(0.01));
  CHECK(run.rise < 1e-6 * run.weight());
}

// T13 of the findings: dice of 1 cm.
TEST_CASE("a tower of small dice stays at rest at any d̂ below their size") {
  const double edge = GENERATE(0.01, 0.001), share = GENERATE(0.01, 0.02, 0.1),
               h = GENERATE(1.0 / 30, 1.0 / 60, 1.0 / 240);
  CAPTURE(edge, share, h);
  const double d_hat = share * edge;
  Setting setting(h, 0.5, d_hat);
  setting.ground();
  for (int k = 0; k < 8; ++k)
    setting.add(
        spec::Body{.shape = Box{Vec3::Constant(edge / 2)},
                   .density = 2000,
                   .position = Vec3(0.05 * edge * (k % 2), edge / 2 + d_hat + (edge + d_hat) * k, 0)});
  Run run(setting);
  run.go(2);
  CHECK(run.way("b8").norm() < 2 * d_hat);
  CHECK(run.carried() == Approx(run.weight()).epsilon(0.01));
}

// Towers are the engines' standard benchmark (Box2D's and PhysX's "tall stack").
TEST_CASE("a tall tower stays at rest") {
  const auto [count, size] = GENERATE(
      table<int, Vec3>({{30, Vec3(0.2, 0.2, 0.2)}, {60, Vec3(0.5, 0.06, 0.3)}, {18, Vec3(0.3, 1, 0.3)}}));
  const double h = GENERATE(1.0 / 60, 1.0 / 240);
  CAPTURE(count, h);
  const double d_hat = 0.02 * size.minCoeff();
  Setting setting(h, 0.5, d_hat);
  setting.ground();
  for (int k = 0; k < count; ++k)
    setting.add(Box{size / 2}, 2, {0, (size.y() + d_hat) * (k + 1) - size.y() / 2, 0},
                spec::AxisAngle{Vec3::UnitY(), 2.0 * (k % 4)});
  Run run(setting);
  run.go(4);
  const std::string top = "b" + std::to_string(count);
  CHECK(run.way(top).norm() < 0.15 * d_hat * count);
  CHECK(run.R(top)(1, 1) > 1 - 1e-6);
  CHECK(run.kinetic() < 1e-9 * run.weight() * size.y());
  CHECK(run.carried() == Approx(run.weight()).epsilon(1e-4));
}

// Galton's board, 1889. Two balls go side by side between two pegs: larger ones may well form an arch.
TEST_CASE("balls fall through a board of pegs, all of them, and make no energy") {
  const double h = GENERATE(1.0 / 60, 1.0 / 240);
  const unsigned seed = GENERATE(3u, 4u);
  CAPTURE(h, seed);
  std::mt19937 rng(seed);
  std::uniform_real_distribution<double> one(-1, 1);
  Setting setting(h, 0.2, 0.001);
  setting.ground();
  for (const double side : {-1.0, 1.0}) setting.add(Box{{0.7, 1.5, 0.05}}, 0, {0, 1.5, side * 0.075});
  for (int row = 0; row < 6; ++row)
    for (int k = -3; k <= 3; ++k)
      setting.add(Sphere{0.022}, 0, {0.1 * k + 0.05 * (row % 2), 0.4 + 0.1 * row, 0});
  std::vector<std::string> balls;
  for (int k = 0; k < 25; ++k) {
    const double x = 0.1 * one(rng);
    balls.push_back(setting.add(Sphere{0.013}, 0.02, {x, 1.2 + 0.05 * k, 0.003 * (k % 3)}));
  }
  Run run(setting);
  run.go(3);
  for (const std::string& ball : balls) CHECK(run.c(ball).y() < 0.35);
  CHECK(run.rise < 1e-6 * run.begin);
  CHECK(run.overlap < 0.003);
}

// A silo or hopper with an opening of more than five diameters never clogs: Beverloo 1961.
TEST_CASE("a funnel lets all balls out") {
  const double radius = GENERATE(0.02, 0.03), h = GENERATE(1.0 / 60, 1.0 / 240);
  CAPTURE(radius, h);
  Setting setting(h, 0.15, 0.002);
  setting.ground();
  const double hole = 6 * radius;  // half of the opening
  for (int side = 0; side < 4; ++side) {
    const double turn = 90.0 * side;
    const Mat3 R = Eigen::AngleAxisd(turn * kDegree, Vec3::UnitY()).toRotationMatrix();
    const Eigen::Quaterniond q(R * Eigen::AngleAxisd(45 * kDegree, Vec3::UnitZ()).toRotationMatrix());
    // Its lower end at the opening, rising outwards.
    const Vec3 middle = R * Vec3(hole + 0.4 * std::sqrt(0.5) + 0.02, 1 + 0.4 * std::sqrt(0.5), 0);
    setting.add(Box{{0.4, 0.02, 0.8}}, 0, middle, {q.w(), q.x(), q.y(), q.z()});
  }
  std::vector<std::string> balls;
  for (int k = 0; k < 48; ++k)
    balls.push_back(setting.add(Sphere{radius}, 0.05,
                                {2.3 * radius * (k % 4 - 1.5) + 0.001 * (k % 5),
                                 1.3 + 2.3 * radius * (k / 16), 2.3 * radius * (k / 4 % 4 - 1.5)}));
  Run run(setting);
  run.go(4);
  for (const std::string& ball : balls) CHECK(run.c(ball).y() < 0.5);
  CHECK(run.rise < 1e-6 * run.begin);
}

// Newton's third law: what nobody holds keeps its momentum.
TEST_CASE("free bodies of all shapes that collide keep their momentum to rounding, and make no energy") {
  const double ratio = GENERATE(1.0, 40.0, 1000.0), speed = GENERATE(1.0, 20.0),
               h = GENERATE(1.0 / 60, 1.0 / 1000);
  CAPTURE(ratio, speed, h);
  Setting setting(h, 0.4);
  setting.builder.params.gravity = Vec3::Zero();
  const Shape shapes[] = {Box{{0.2, 0.1, 0.15}}, Sphere{0.2}, Capsule{0.08, 0.4},
                          make_shape("cylinder", {0.2, 0.3}), make_shape("cone", {0.2, 0.4})};
  int k = 0;
  for (const Shape& shape : shapes) {
    const double angle = 2 * kPi * k / 5;
    const Vec3 out(std::cos(angle), std::sin(angle), 0.1 * k);
    setting.add(spec::Body{.shape = shape,
                           .mass = k % 2 ? 1 : ratio,
                           .position = out,
                           .orientation = spec::AxisAngle{Vec3(1, 2, k), 40.0 * k},
                           .velocity = Vec3(-speed * out),
                           .angular_velocity = Vec3(0, 50, 100.0 * k)});
    ++k;
  }
  Run run(setting);
  const Vec3 before = run.momentum();
  double scale = 0;
  for (std::size_t i = 0; i < 5; ++i) scale += run.scene.model.mass[i] * run.state.v[i].norm();
  run.go(3 / speed);
  CHECK((run.momentum() - before).norm() < 1e-11 * scale);
  CHECK(run.kinetic() < 0.98 * run.begin);  // they have met
  CHECK(run.rise < 1e-9 * run.begin);
}

// The same law, whoever comes first: engines that solve contact by contact depend on the order of bodies.
TEST_CASE("a heap at rest is the same whichever body comes first in the file") {
  const double h = GENERATE(1.0 / 60, 1.0 / 240);
  const int rows = GENERATE(3, 6);
  const auto at_rest = [&](bool backwards) {
    Setting setting(h, 0.5, 0.002);
    std::vector<spec::Body> bricks;
    for (int row = 0; row < rows; ++row)
      for (int k = 0; k < rows - row; ++k)
        bricks.push_back({.name = std::to_string(row) + "." + std::to_string(k),
                          .shape = Box{{0.1, 0.05, 0.06}},
                          .mass = 1.0,
                          .position = Vec3(0.21 * (k - 0.5 * (rows - row - 1)), 0.052 + 0.102 * row, 0)});
    if (backwards) std::reverse(bricks.begin(), bricks.end());
    if (backwards) {
      for (const spec::Body& brick : bricks) setting.add(brick);
      setting.ground();
    } else {
      setting.ground();
      for (const spec::Body& brick : bricks) setting.add(brick);
    }
    Run run(setting);
    run.go(3);
    return run;
  };
  const Run one = at_rest(false), other = at_rest(true);
  for (int row = 0; row < rows; ++row)
    for (int k = 0; k < rows - row; ++k) {
      const std::string name = std::to_string(row) + "." + std::to_string(k);
      CHECK((one.c(name) - other.c(name)).norm() < 1e-6);
    }
}

}  // namespace pabd::test_piles
