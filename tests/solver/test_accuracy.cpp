// SPDX-License-Identifier: MIT
// What sim/accuracy.md tells of damping, bounces and overlap.

#include <catch2/catch.hpp>
#include <cmath>

#include "sim/potential/barrier.h"
#include "tests/support/scenario.h"

namespace pabd::test_accuracy {

using testing::World;

namespace {

// How fast the amplitude of a pendulum of length L falls, 1/s: from its kinetic energy at the lowest points.
double damping(double L, double h, int swings, Integrator integrator) {
  World world;
  world.params.h = h;
  world.params.solver.integrator = integrator;
  const double start = 0.08;  // rad
  const Index ball = world.add(Sphere{0.02}, 1, {L * std::sin(start), -L * std::cos(start), 0});
  add_joint(world, make_joint(world, JointType::spherical, kWorld, ball, Vec3::Zero()));
  const int steps = static_cast<int>(swings * 2 * kPi * std::sqrt(L / 9.81) / h);
  double before = 0, last = 0, first_peak = 0, first_time = 0, peak = 0, time = 0;
  testing::run(world, steps, {}, [&](const StepReport& r) {
    if (last > before && last >= r.kinetic) {
      if (first_peak == 0) {
        first_peak = last;
        first_time = r.time;
      }
      peak = last;
      time = r.time;
    }
    before = last;
    last = r.kinetic;
  });
  return std::log(first_peak / peak) / (2 * (time - first_time));
}

struct Bounce {
  double restitution;
  double depth;  // m
};

// A ball of 1 kg that comes down at `speed`, without gravity; it is seen `phase` of a step before d̂.
Bounce bounce(double kappa, int N, double h, double speed, double phase) {
  World world;
  world.params.gravity.setZero();
  world.params.h = h;
  world.params.contact.kappa = kappa;
  world.params.contact.N = N;
  world.add_ground();
  const double d_hat = world.params.contact.d_hat;
  const Index ball = world.add(Sphere{0.1}, 1, {0, 0.1 + d_hat + speed * h * (3 + phase), 0});
  world.state.v[static_cast<std::size_t>(ball)] = {0, -speed, 0};
  Bounce out{0, 0};
  const int steps = std::max(60, static_cast<int>(0.06 / speed / h));
  testing::run(world, steps, {},
               [&](const StepReport& r) { out.depth = std::max(out.depth, r.max_penetration); });
  out.restitution = world.state.v[static_cast<std::size_t>(ball)].y() / speed;
  return out;
}

}  // namespace

TEST_CASE("by Euler a pendulum loses ω² h/2 of its amplitude a second, to 1 %") {
  struct Case {
    double L, h;
    int swings;
  };
  for (const Case& c :
       {Case{0.25, 1.0 / 60, 4}, Case{1, 1.0 / 120, 5}, Case{4, 1.0 / 60, 5}, Case{1, 1.0 / 400, 5}}) {
    INFO("L " << c.L << ", h " << c.h);
    const double squared = 9.81 / c.L;  // ω²
    CHECK(damping(c.L, c.h, c.swings, Integrator::euler) ==
          Approx(0.5 * std::log1p(squared * c.h * c.h) / c.h).epsilon(0.01));
  }
}

TEST_CASE("by bdf2 a pendulum loses (ω h)⁴/6 of its amplitude a step, to 5 %") {
  const double L = GENERATE(0.25, 0.5), h = 1.0 / 60, turn = std::sqrt(9.81 / L) * h;
  CAPTURE(L);
  CHECK(damping(L, h, 150, Integrator::bdf2) == Approx(std::pow(turn, 4) / 6 / h).epsilon(0.05));
}

TEST_CASE("what is left of a bounce, by κ, N and h") {
  struct Row {
    double kappa;
    int N;
    double h, least, most;
  };
  const Row rows[] = {
      {1, 1, 1.0 / 240, 0.28, 0.38},   {1, 3, 1.0 / 60, 0.01, 0.06},    {1, 3, 1.0 / 240, 0.22, 0.26},
      {1, 3, 1.0 / 1000, 0.73, 0.75},  {1, 3, 1.0 / 4000, 0.92, 0.94},  {1, 8, 1.0 / 1000, 0.72, 0.75},
      {10, 1, 1.0 / 4000, 0.75, 0.77}, {10, 3, 1.0 / 240, 0.02, 0.08},  {10, 3, 1.0 / 1000, 0.30, 0.35},
      {100, 3, 1.0 / 60, 0, 0.01},     {100, 3, 1.0 / 4000, 0.38, 0.43}};
  for (const Row& row : rows) {
    for (const double phase : {0.1, 0.4, 0.7}) {
      INFO("κ " << row.kappa << ", N " << row.N << ", h " << row.h << ", phase " << phase);
      const double e = bounce(row.kappa, row.N, row.h, 1, phase).restitution;
      CHECK(e >= row.least);
      CHECK(e <= row.most);
    }
  }
}

TEST_CASE("bounces are alike where κ h²/(m d̂²) and v h/d̂ are: four times the steps, four times the speed") {
  for (const double kappa : {1.0, 30.0}) {
    const double slow = bounce(kappa, 3, 1.0 / 240, 1, 0.4).restitution;
    CHECK(bounce(16 * kappa, 3, 1.0 / 960, 4, 0.4).restitution == Approx(slow).epsilon(1e-3));
  }
}

TEST_CASE("an impact goes no deeper than to where the barrier holds its energy, and a hard one stays out") {
  for (const double speed : {5.0, 10.0}) {
    for (const int N : {1, 3, 8}) {
      for (const double kappa : {0.4, 10.0, 100.0}) {
        const Barrier barrier{BarrierKind::polynomial, N, 0.01, kappa, Params{}.contact.onset};
        for (const double h : {1.0 / 60, 1.0 / 1000}) {
          const double depth = bounce(kappa, N, h, speed, 0.3).depth;
          INFO(speed << " m/s, N " << N << ", κ " << kappa << ", h " << h << ", depth " << depth);
          CHECK((depth == 0 || evaluate(barrier, -depth).value <= 0.5 * speed * speed));
          if (evaluate(barrier, 0).value >= 0.5 * speed * speed) CHECK(depth == 0);
        }
      }
    }
  }
}

TEST_CASE(
    "balls of 100 and 300 m/s do not come through a wall of 1 cm or 2 mm whose barrier holds their energy") {
  const double mu = GENERATE(0.0, 0.5);
  for (const double speed : {100.0, 300.0}) {
    for (const double thickness : {0.01, 0.002}) {
      for (const double angle : {0.0, 0.6}) {
        for (const double phase : {0.1, 0.35, 0.8}) {
          World world;
          world.params.contact.mu_static = world.params.contact.mu_dynamic = mu;
          const double mass = 0.03, h = world.params.h;
          world.params.contact.kappa = mass * speed * speed;
          world.add(Box{{thickness / 2, 4, 4}}, 0, Vec3::Zero());
          const Vec3 along(std::cos(angle), std::sin(angle), 0);
          const Index ball = world.add(Sphere{0.01}, mass, -(0.1 + phase * speed * h) * along);
          world.state.v[static_cast<std::size_t>(ball)] = speed * along;
          testing::run(world, 4);
          INFO("friction " << mu << ", " << speed << " m/s, " << thickness << " m, " << angle
                           << " rad, phase " << phase);
          CHECK(world.state.c[static_cast<std::size_t>(ball)].x() < -thickness / 2);
        }
      }
    }
  }
}

}  // namespace pabd::test_accuracy
