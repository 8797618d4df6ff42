// SPDX-License-Identifier: MIT
// Stacks stay where they are.

#include <catch2/catch.hpp>

#include "tests/support/scenario.h"

namespace pabd::test_stack {

using testing::World;

namespace {

World stack(int count, BarrierKind kind) {
  World world;
  world.params.contact.barrier = kind;
  world.params.contact.N = kind == BarrierKind::even ? 4 : 3;
  world.params.contact.d_hat = 0.02;
  world.params.solver.method = SolverMethod::descent;
  world.params.solver.tolerance = 1e-10;  // the default, 1e-6 d̂ a step, stops at 1e-9 J
  world.add_ground();
  for (int k = 0; k < count; ++k) world.add_cube(1, 1000, {0, 0.5 + 0.019 + 1.019 * k, 0});
  return world;
}

// Rows of bricks with room at their sides, the rows `gap` apart. In a pyramid each has one brick less than
// that below, in a wall as many, by turns a quarter of a brick to the side.
World bricks(int rows, int columns, bool pyramid, double gap) {
  World world;
  world.add_ground();
  for (int row = 0; row < rows; ++row) {
    const int count = pyramid ? columns - row : columns;
    const double shift = pyramid || row % 2 == 0 ? 0 : 0.25;
    for (int k = 0; k < count; ++k) {
      const double x = (k - 0.5 * (count - 1)) * 1.01 + shift;
      world.add(Box{{0.5, 0.25, 0.25}}, 250, {x, 0.25 + gap + row * (0.5 + gap), 0});
    }
  }
  return world;
}

}  // namespace

TEST_CASE("a stack of ten cubes is at rest after 5 s: below 1e-12 J, no penetration, drift below 1e-3 m") {
  for (const BarrierKind kind : {BarrierKind::polynomial, BarrierKind::even}) {
    World world = stack(10, kind);
    StepReport last;
    double worst = 0;
    testing::run(world, 300, {}, [&](const StepReport& r) {
      last = r;
      worst = std::max(worst, r.max_penetration);
    });
    INFO(to_string(kind));
    CHECK(last.kinetic < 1e-12);
    CHECK(worst == 0);
    for (Index i = 1; i <= 10; ++i) {
      CHECK(std::abs(world.state.c[i].x()) < 1e-3);
      CHECK(std::abs(world.state.c[i].z()) < 1e-3);
    }
  }
}

TEST_CASE("a pyramid of 55 bricks stands for 5 s") {
  World world;
  world.params.solver.method = SolverMethod::descent;
  world.add_ground();
  const double d = world.params.contact.d_hat;
  for (int row = 0; row < 10; ++row) {
    for (int k = 0; k < 10 - row; ++k) {
      world.add(Box{{0.5, 0.25, 0.25}}, 250,
                {(k - 0.5 * (9 - row)) * (1 + d), 0.25 + 0.95 * d + row * (0.5 + 0.95 * d), 0});
    }
  }
  const Index top = world.model.size() - 1;
  const Vec3 start = world.state.c[top];
  StepReport last;
  testing::run(world, 300, {}, [&](const StepReport& r) { last = r; });
  CHECK(last.max_penetration == 0);
  CHECK((world.state.c[top] - start).norm() < 0.01);
  CHECK(last.kinetic < 1e-5);  // 14 t of bricks: below 40 µm/s
}

TEST_CASE(
    "ten cubes of 1 and 1000 kg in turn, the light one at the bottom, stand for 5 s without penetration") {
  for (const SolverMethod method : {SolverMethod::descent, SolverMethod::automatic}) {
    World world;
    world.params.solver.method = method;
    world.add_ground();
    const double d = world.params.contact.d_hat;
    for (int k = 0; k < 10; ++k)
      world.add_cube(1, k % 2 == 0 ? 1 : 1000, {0, 0.5 + 0.9 * d + k * (1 + 0.9 * d), 0});
    const State start = world.state;
    double deepest = 0;
    StepReport last;
    testing::run(world, 300, {}, [&](const StepReport& r) {
      deepest = std::max(deepest, r.max_penetration);
      last = r;
    });
    INFO(to_string(method));
    CHECK(deepest == 0);
    CHECK(last.kinetic < 1e-6);                                             // 5 t: below 20 µm/s
    CHECK(last.max_normal_force == Approx(5005 * 9.81 / 4).epsilon(1e-3));  // a corner of the lowest cube
    for (Index i = 1; i <= 10; ++i) CHECK((world.state.c[i] - start.c[i]).norm() < 10 * d);
  }
}

TEST_CASE("high stacks settle by less than a tenth of d̂ a level") {
  const auto [levels, edge, light, heavy] = GENERATE(table<int, double, double, double>(
      {{30, 1, 1000, 1000}, {100, 1, 1000, 1000}, {60, 0.2, 4, 4}, {30, 1, 1, 100}, {40, 0.5, 900, 9}}));
  testing::World world;
  world.add_ground();
  const double d_hat = world.params.contact.d_hat, pitch = edge + d_hat;
  for (int k = 0; k < levels; ++k)
    world.add_cube(edge, k % 2 == 0 ? light : heavy, {0, k * pitch + 0.5 * edge + d_hat, 0});
  double smallest = d_hat;
  testing::run(world, 180, {}, [&](const StepReport& r) { smallest = std::min(smallest, r.min_gap); });
  CAPTURE(levels, edge, light, heavy);
  CHECK(smallest > 0.5 * d_hat);
  for (int k = 1; k < world.model.size(); ++k) {
    const double support = k == 1 ? 0 : world.state.c[k - 1].y() + 0.5 * edge;
    const double gap = world.state.c[k].y() - 0.5 * edge - support;
    CHECK(gap > 0.89 * d_hat);
  }
}

TEST_CASE("walls and pyramids of bricks come to rest upright, also where they start without a gap") {
  struct Case {
    int rows, columns;
    bool pyramid;
    double gap;    // of d̂
    double angle;  // about the vertical; rad
  };
  // Without gaps the rows have to rise by d̂ each first.
  for (const Case c : {Case{20, 20, true, 0, 0}, Case{20, 20, true, 0.95, 0}, Case{20, 20, true, 0.95, 0.6},
                       Case{14, 9, false, 0, 0}, Case{14, 9, false, 0.1, 0}, Case{14, 9, false, 0.1, 0.6},
                       Case{14, 9, false, 0.95, 0}}) {
    World world = bricks(c.rows, c.columns, c.pyramid, c.gap * ContactParams{}.d_hat);
    const Mat3 turn = Eigen::AngleAxisd(c.angle, Vec3::UnitY()).toRotationMatrix();
    for (Index i = 1; i < world.model.size(); ++i) {
      world.state.c[i] = turn * world.state.c[i];
      world.state.R[i] = turn;
    }
    const Index top = world.model.size() - 1;
    const Vec3 start = world.state.c[top];
    StepReport last;
    testing::run(world, 300, {}, [&](const StepReport& r) { last = r; });
    Vec3 way = world.state.c[top] - start;
    way.y() = 0;
    CAPTURE(c.rows, c.columns, c.pyramid, c.gap, c.angle, way.norm());
    CHECK(last.kinetic < 1e-15);  // 50 t of bricks: rounding
    CHECK(last.iterations <= 1);
    CHECK(last.max_penetration == 0);
    CHECK(way.norm() < 2e-3);
  }
}

TEST_CASE("what rests stays where it is to the last bit, and moves as soon as something pushes it") {
  const double angle = GENERATE(0.0, 0.6), x = GENERATE(0.0, 3000.0);
  World world = bricks(6, 6, true, 0.0095);
  const Mat3 turn = Eigen::AngleAxisd(angle, Vec3::UnitY()).toRotationMatrix();
  for (Index i = 1; i < world.model.size(); ++i) {
    world.state.c[i] = turn * world.state.c[i] + x * Vec3::UnitX();
    world.state.R[i] = turn;
  }
  testing::run(world, 120, {}, [](const StepReport&) {});
  const State before = world.state;
  testing::run(world, 60, {}, [](const StepReport& r) {
    CHECK(r.iterations == 0);
    CHECK(r.status == StepStatus::converged);
    CHECK(r.kinetic == 0);
  });
  CHECK(world.state.c == before.c);
  CHECK(world.state.R == before.R);

  // Steeper than friction holds: all of it slides with g (sin φ − μ cos φ).
  const double g = 9.81, slope = 0.6, mu = world.params.contact.mu_static;
  world.params.gravity = {g * std::sin(slope), -g * std::cos(slope), 0};
  testing::run(world, 1, {}, [](const StepReport&) {});
  CHECK(world.state.v.back().x() > 0.01);
  testing::run(world, 29, {}, [](const StepReport&) {});
  const double faster = g * (std::sin(slope) - mu * std::cos(slope)) * 0.5;
  Vec3 sum = Vec3::Zero();
  for (const Vec3& v : world.state.v) sum += v;
  CHECK(sum.x() / (world.model.size() - 1) == Approx(faster).epsilon(0.02));
}

TEST_CASE("a wall whose bricks touch on all sides widens by d̂ a joint, and does not burst") {
  const auto [rows, columns, gap] =
      GENERATE(table<int, int, double>({{9, 14, 0.0}, {6, 9, 0.2}, {5, 3, 0.0}}));
  World world;
  world.add_ground();
  const double d_hat = world.params.contact.d_hat, space = gap * d_hat;
  for (int row = 0; row < rows; ++row) {
    for (int k = 0; k < columns; ++k) {
      const double x = (k - 0.5 * (columns - 1)) * (1 + space) + (row % 2 == 0 ? 0 : 0.25);
      world.add(Box{{0.5, 0.25, 0.25}}, 250, {x, 0.25 + space + row * (0.5 + space), 0});
    }
  }
  const State start = world.state;
  double fastest = 0;
  testing::run(world, 240, {}, [&](const StepReport&) {
    for (const Vec3& v : world.state.v) fastest = std::max(fastest, v.norm());
  });
  CAPTURE(rows, columns, gap);
  CHECK(fastest < 0.3);
  for (std::size_t i = 1; i < start.c.size(); ++i) {
    const Vec3 way = world.state.c[i] - start.c[i];
    CHECK(std::abs(way.x()) < 0.55 * columns * d_hat);
    CHECK(std::abs(way.z()) < 0.1 * d_hat);
    CHECK(std::abs(way.y()) < rows * d_hat);
  }
}

}  // namespace pabd::test_stack
