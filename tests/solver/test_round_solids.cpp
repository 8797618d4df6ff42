// SPDX-License-Identifier: MIT
// Cylinders and cones in motion against statics and closed forms: they stand, tip, slide, roll, and make no
// energy.
//
//   a body whose centre of mass is y above a base of radius r tips at tan α = r/y, slides at tan α = μ
//   one that rolls has k = I/(m r²), 1/2 for a cylinder: a slope accelerates it with g sin θ/(1 + k)
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/body/shape_kind.h"
#include "sim/math/so3.h"
#include "sim/solver/contact_setup.h"
#include "sim/trace/trace.h"
#include "tests/support/scenario.h"

namespace pabd::test_round_solids {

using testing::World;

namespace {

constexpr double kG = 9.81, kRadius = 0.3, kHeight = 1.0;

struct Kind {
  const char* name;
  double centre;  // of mass, of the height above the base
};
constexpr Kind kKinds[] = {{"cylinder", 0.5}, {"cone", 0.25}};

Shape solid(const Kind& kind) { return make_shape(kind.name, {kRadius, kHeight}); }

// Stands 0.8 d̂ above the ground, which leans by the slope and is the plane through 0 with that friction; downhill
// is towards +x, turned by `turn` about the normal.
World standing(const Kind& kind, double slope, double mu, double turn = 0, double d_hat = 0.004) {
  World world;
  world.params.contact.d_hat = d_hat;
  world.params.contact.mu_static = world.params.contact.mu_dynamic = mu;
  world.params.gravity = kG * Vec3(std::sin(slope), -std::cos(slope), 0);
  world.add_ground();
  world.add(solid(kind), 50, {0, kind.centre * kHeight + 0.8 * d_hat, 0}, exp_so3({0, turn, 0}));
  return world;
}

// d where −Ψ'(d) = f.
double gap_under(const World& world, double f) {
  const Barrier barrier = contact_law(world.model, world.params).barrier;
  double lo = 0, hi = barrier.d_hat;
  for (int k = 0; k < 200; ++k) {
    const double d = 0.5 * (lo + hi);
    (-evaluate(barrier, d).first > f ? lo : hi) = d;
  }
  return lo;
}

double tilt(const World& world) { return std::acos(std::min(1.0, world.state.R[1](1, 1))); }

}  // namespace

TEST_CASE("round solids stand upright at the gap of theory, and each contact carries its share") {
  for (const Kind& kind : kKinds) {
    INFO(kind.name);
    World world = standing(kind, 0, 0.5);
    StepReport last;
    testing::run(world, 600, {false, true, 1}, [&](const StepReport& r) { last = r; });
    REQUIRE(last.contact_reports.size() == 8);
    for (const ContactReport& c : last.contact_reports)
      CHECK(c.normal_force == Approx(50 * kG / 8).epsilon(1e-5));
    CHECK(world.state.c[1].y() ==
          Approx(kind.centre * kHeight + gap_under(world, 50 * kG / 8)).epsilon(1e-9));
    CHECK(tilt(world) < 1e-7);
    CHECK(last.kinetic < 1e-12);
  }
}

TEST_CASE("round solids tip where the plumb line leaves the base, to 2 %, whichever side is downhill") {
  for (const Kind& kind : kKinds) {
    const double tips = kRadius / (kind.centre * kHeight);
    for (const double turn : {0.0, kPi / 32, 1.0}) {
      for (const double part : {0.98, 1.02}) {
        // The slope grows from nothing: what settling gives could tip what stands a third of a degree from that.
        World world = standing(kind, 0, 5, turn, 0.0005);
        for (int k = 1; k <= 480; ++k) {
          const double slope = std::atan(part * tips) * std::min(1.0, k / 360.0);
          world.params.gravity = kG * Vec3(std::sin(slope), -std::cos(slope), 0);
          testing::run(world, 1);
        }
        INFO(kind.name << " turned by " << turn << " at " << part << ": tilt " << tilt(world));
        if (part < 1) CHECK(tilt(world) < 0.02);
        if (part > 1) CHECK(tilt(world) > 0.3);
      }
    }
  }
}

TEST_CASE("round solids slide where the slope is steeper than friction, to 1 %, with g (sin α − μ cos α)") {
  for (const Kind& kind : kKinds) {
    const double mu = 0.3;
    for (const double part : {0.99, 1.01, 1.5}) {
      const double slope = std::atan(part * mu);
      World world = standing(kind, slope, mu);
      testing::run(world, 60);
      const double before = world.state.v[1].x();
      testing::run(world, 60);
      const double gained = world.state.v[1].x() - before;
      INFO(kind.name << " at " << part << ": speed " << world.state.v[1].norm() << ", gained " << gained);
      if (part < 1) CHECK(world.state.v[1].norm() < 1e-6);
      if (part > 1) CHECK(gained > 0.01);
      if (part > 1.1) CHECK(gained == Approx(kG * (std::sin(slope) - mu * std::cos(slope))).epsilon(0.01));
      CHECK(tilt(world) < 0.02);
    }
  }
}

TEST_CASE("a cylinder that lies on its side rolls: it keeps its speed, and a slope gives it 2/3 g sin θ") {
  const Mat3 lying = exp_so3({kPi / 2, 0, 0});  // its axis along z
  const auto rolling = [&](double slope, double v) {
    World world = standing(kKinds[0], slope, 0.6);
    world.state.R[1] = lying;
    world.state.c[1] = {0, kRadius + gap_under(world, 50 * kG * std::cos(slope) / 2), 0};
    world.state.v[1] = {v, 0, 0};
    world.state.omega[1] = {0, 0, -v / kRadius};
    return world;
  };
  World level = rolling(0, 1);  // 0.056 rad a step
  testing::run(level, 600);
  CHECK(level.state.v[1].x() == Approx(1).epsilon(0.003));
  CHECK(-kRadius * level.state.omega[1].z() == Approx(1).epsilon(0.003));
  CHECK(std::abs(level.state.v[1].y()) < 1e-6);
  CHECK(std::abs(level.state.v[1].z()) < 1e-6);

  // What belongs to the surface turns away from the ground, v = sin(ω h) r/h in a solve; halves keep what that would lose.
  World fast = rolling(0, 6);
  testing::run(fast, 600);
  const double turn = -fast.state.omega[1].z() * fast.params.h;
  CHECK(turn > 0.3);
  CHECK(fast.state.v[1].x() == Approx(6).epsilon(0.003));
  CHECK(turn == Approx(6 * fast.params.h / kRadius).epsilon(0.005));

  const double slope = 0.1;
  World down = rolling(slope, 0);
  testing::run(down, 60);
  CHECK(down.state.v[1].x() == Approx(2.0 / 3 * kG * std::sin(slope)).epsilon(0.01));
}

TEST_CASE("round solids that are thrown make no energy and come to rest, and the ground carries them") {
  for (const Kind& kind : kKinds) {
    for (const double turn : {0.3, 1.2, 2.4}) {
      World world = standing(kind, 0, 0.5);
      world.params.contact.d_hat = 0.01;
      world.state.c[1].y() = 1.5;
      world.state.R[1] = exp_so3({turn, 0.5, -0.7 * turn});
      world.state.v[1] = {1, 0, 0.5};
      world.state.omega[1] = {2, -3, 4};
      const Mat3 I = world.state.R[1] * inertia_tensor(world.model.J[1]) * world.state.R[1].transpose();
      const double start =
          50 * kG * 1.5 + 0.5 * 50 * 1.25 + 0.5 * world.state.omega[1].dot(I * world.state.omega[1]);
      double highest = 0;
      StepReport last;
      testing::run(world, 1200, {false, true, 1}, [&](const StepReport& r) {
        highest = std::max(highest, r.kinetic + r.potential + r.elastic);
        last = r;
      });
      INFO(kind.name << ", turn " << turn << ": " << highest / start);
      CHECK(highest < start * 1.001);
      double force = 0;
      for (const ContactReport& c : last.contact_reports) force += c.normal_force;
      CHECK(force == Approx(50 * kG).epsilon(0.01));
      CHECK(last.min_gap > 0);
    }
  }
}

TEST_CASE("round solids among boxes and balls: the same bytes for every number of threads") {
  const auto hash = [](int threads) {
    World world;
    world.add_ground();
    for (int k = 0; k < 40; ++k) {
      const Kind& kind = kKinds[static_cast<std::size_t>(k) % std::size(kKinds)];
      Shape shape = make_shape(kind.name, {0.2, 0.5});
      if (k % 5 == 3) shape = Box{{0.2, 0.25, 0.2}};
      if (k % 5 == 4) shape = k % 2 ? Shape(Sphere{0.2}) : Shape(Capsule{0.15, 0.3});
      const Mat3 R = exp_so3({0.3 * k, 0.1 * k * k, -0.7 * k});
      world.add(shape, 20, {0.75 * (k % 3), 0.7 + 0.75 * (k / 9), 0.75 * (k / 3 % 3)}, R);
    }
    StepOptions options;
    options.threads = threads;
    testing::run(world, 150, options, [](const StepReport& r) { CHECK(r.status != StepStatus::non_finite); });
    return state_hash(world.state);
  };
  const std::string one = hash(1);
  CHECK(hash(3) == one);
  CHECK(hash(1) == one);
}

}  // namespace pabd::test_round_solids
