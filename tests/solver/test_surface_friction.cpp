// SPDX-License-Identifier: MIT
// Friction of a body's own: a crate on a slope holds and slides as the rule says of its surface and the slope's.
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/math/so3.h"
#include "tests/support/scenario.h"

namespace pabd::test_surface_friction {

using testing::World;

namespace {

constexpr double kG = 9.81;
constexpr FrictionRule kRules[] = {FrictionRule::geometric_mean, FrictionRule::average, FrictionRule::min,
                                   FrictionRule::max, FrictionRule::product};

struct Slope {
  World world;
  Vec3 down;  // unit, along the slope
};

// Crates side by side on a slope, each with friction of its own.
Slope crates_on_slope(double angle, FrictionRule rule, std::optional<SurfaceFriction> slope,
                      const std::vector<std::optional<SurfaceFriction>>& crates) {
  Slope s;
  s.world.params.contact.friction_rule = rule;
  const Mat3 tilt = exp_so3({0, 0, angle});
  s.down = -(tilt * Vec3::UnitX());
  s.world.add_ground(tilt * Vec3::UnitY());
  s.world.model.friction = {slope};
  for (const auto& own : crates) {
    const double z = 2 * static_cast<double>(s.world.model.size());
    s.world.add(Box{{0.5, 0.1, 0.5}}, 200, tilt * Vec3(0, 0.1 + 0.0099, z), tilt);
    s.world.model.friction.push_back(own);
  }
  return s;
}

double speed(const Slope& s, std::size_t body) { return s.world.state.v[body].dot(s.down); }

}  // namespace

TEST_CASE("two surfaces make one friction, as each rule says") {
  const SurfaceFriction a{0.8, 0.2}, b{0.5, 0.45};
  const auto made = [&](FrictionRule rule) { return combined(rule, a, b); };
  CHECK(made(FrictionRule::geometric_mean).mu_static == Approx(std::sqrt(0.4)).epsilon(1e-15));
  CHECK(made(FrictionRule::geometric_mean).mu_dynamic == Approx(0.3).epsilon(1e-15));
  CHECK(made(FrictionRule::average) == SurfaceFriction{0.65, 0.325});
  CHECK(made(FrictionRule::min) == SurfaceFriction{0.5, 0.2});
  CHECK(made(FrictionRule::max) == SurfaceFriction{0.8, 0.45});
  CHECK(made(FrictionRule::product) == SurfaceFriction{0.4, 0.2 * 0.45});
  for (const FrictionRule rule : kRules) {
    INFO(to_string(rule));
    CHECK(combined(rule, a, b) == combined(rule, b, a));
    if (rule == FrictionRule::product) continue;
    for (const double mu : {0.0, 1e-9, 0.1, 0.3, 1.0 / 3, 0.7, 99.0})
      CHECK(combined(rule, {mu, mu}, {mu, mu}) == SurfaceFriction{mu, mu});  // to the bit
  }
}

TEST_CASE("a crate holds a degree below the angle of the combined friction, and slides a degree above it") {
  const double ground = 0.3, crate = 0.6;
  const double expected[] = {std::sqrt(ground * crate), 0.45, 0.3, 0.6, 0.18};
  for (std::size_t k = 0; k < std::size(kRules); ++k) {
    for (const SolverMethod method : {SolverMethod::descent, SolverMethod::newton}) {
      const double mu = expected[k], limit = std::atan(mu);
      INFO(to_string(kRules[k]) << ", " << to_string(method));
      const SurfaceFriction of_ground{ground, ground}, of_crate{crate, crate};
      Slope holds = crates_on_slope(limit - kDegree, kRules[k], of_ground, {of_crate});
      holds.world.params.solver.method = method;
      testing::run(holds.world, 120);
      const Vec3 start = holds.world.state.c[1];
      testing::run(holds.world, 120);
      CHECK((holds.world.state.c[1] - start).norm() < 1e-6);

      const double above = limit + kDegree;
      Slope slides = crates_on_slope(above, kRules[k], of_ground, {of_crate});
      slides.world.params.solver.method = method;
      testing::run(slides.world, 60);
      const double before = speed(slides, 1);
      testing::run(slides.world, 60);
      CHECK(speed(slides, 1) - before == Approx(kG * (std::sin(above) - mu * std::cos(above))).epsilon(0.01));
    }
  }
}

TEST_CASE("of crates on one slope each has its own friction, and who has none that of the scene") {
  // contact.friction is 0.5, of the slope as well: √(0.5 μ) is 0.32 for 0.2 and 0.63 for 0.8; tan 22° = 0.40.
  const double angle = 22 * kDegree;
  Slope s = crates_on_slope(
      angle, FrictionRule::geometric_mean, std::nullopt,
      {SurfaceFriction{0.2, 0.2}, SurfaceFriction{0.8, 0.8}, std::nullopt, SurfaceFriction{0, 0}});
  testing::run(s.world, 60);
  const double slippery = speed(s, 1), ice = speed(s, 4);
  testing::run(s.world, 60);
  CHECK(speed(s, 1) - slippery ==
        Approx(kG * (std::sin(angle) - std::sqrt(0.1) * std::cos(angle))).epsilon(0.01));
  CHECK(speed(s, 4) - ice == Approx(kG * std::sin(angle)).epsilon(1e-3));
  CHECK(std::abs(speed(s, 2)) < 1e-6);
  CHECK(std::abs(speed(s, 3)) < 1e-6);
}

TEST_CASE("friction of a body's own acts where the scene has none") {
  const double angle = 20 * kDegree;
  for (const bool own : {false, true}) {
    const auto some = own ? std::optional(SurfaceFriction{0.6, 0.6}) : std::nullopt;
    Slope s = crates_on_slope(angle, FrictionRule::max, std::nullopt, {some});
    s.world.params.contact.mu_static = s.world.params.contact.mu_dynamic = 0;
    testing::run(s.world, 60);
    CHECK(speed(s, 1) == Approx(own ? 0 : kG * std::sin(angle)).epsilon(1e-3).margin(1e-6));
  }
}

TEST_CASE("a pair lets go with the dynamic friction of its two surfaces") {
  const double angle = 22 * kDegree;  // between atan 0.2 and atan 0.5
  for (const double push : {0.0, 0.5}) {
    const SurfaceFriction own{0.5, 0.2};
    Slope s = crates_on_slope(angle, FrictionRule::geometric_mean, own, {own});
    s.world.params.contact.mu_static = s.world.params.contact.mu_dynamic = 0.9;
    const Vec3 gravity = s.world.params.gravity;  // settles under its weight first
    s.world.params.gravity = gravity - s.down * s.down.dot(gravity);
    testing::run(s.world, 60);
    s.world.params.gravity = gravity;
    s.world.state.v[1] = push * s.down;
    testing::run(s.world, 120);
    const double slid = push + 2 * kG * (std::sin(angle) - 0.2 * std::cos(angle));
    CHECK(speed(s, 1) == Approx(push == 0 ? 0 : slid).epsilon(0.02).margin(1e-6));
  }
}

TEST_CASE("bodies that say what the scene says change no bit") {
  const auto made = [](bool own, FrictionRule rule) {
    World world;
    world.params.contact.mu_static = 0.35;
    world.params.contact.mu_dynamic = 0.3;
    world.params.contact.friction_rule = rule;
    world.add_ground();
    for (int k = 0; k < 6; ++k)
      world.add_cube(0.5, 50, {0.1 * k, 0.27 + 0.53 * k, 0}, exp_so3({0.1 * k, 0.2, 0.05}));
    if (own) world.model.friction.assign(world.model.shape.size(), SurfaceFriction{0.35, 0.3});
    testing::run(world, 90);
    return world.state;
  };
  const State plain = made(false, FrictionRule::geometric_mean);
  CHECK(same_bits(plain, made(false, FrictionRule::product)));  // the rule alone says nothing
  for (const FrictionRule rule : kRules) {
    INFO(to_string(rule));
    CHECK(same_bits(plain, made(true, rule)) == (rule != FrictionRule::product));
  }
}

}  // namespace pabd::test_surface_friction
