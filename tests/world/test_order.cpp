// SPDX-License-Identifier: MIT
// What solved steps give does not depend on the order in which a scene names its bodies.
#include <catch2/catch.hpp>

#include "sim/body/shape_kind.h"
#include "tests/world/world.h"

namespace pabd::test_order {

using namespace world;

struct Pair {
  const char* name;
  spec::Body below, above;
};

// Turned by so many degrees about `axis`, and spinning; degrees/s.
spec::Body put(const Shape& shape, const Vec3& at, double angle = 0, const Vec3& axis = Vec3::UnitY(),
               const Vec3& spin = Vec3::Zero()) {
  return {.shape = shape,
          .mass = 8.0,
          .position = at,
          .orientation = spec::AxisAngle{axis, angle},
          .angular_velocity = spin};
}

std::vector<Pair> pairs() {
  const Shape box = Box{Vec3(0.1, 0.1, 0.1)}, plank = Box{Vec3(0.5, 0.05, 0.1)};
  const Shape can = make_shape("cylinder", {0.1, 0.2}), ball = Sphere{0.1}, pill = Capsule{0.1, 0.3};
  const Vec3 low(0, 0.1, 0), high(0.03, 0.33, 0.02), spin(300, 0, 100);
  return {
      {"a box flat on a box", put(box, low), put(box, {0.05, 0.34, 0.03}, 20, Vec3::UnitY(), {0, 100, 0})},
      {"a box with a corner on a box", put(box, low), put(box, {0.05, 0.42, 0.03}, 50, {1, 0.3, 0.7})},
      {"a plank that tips over a box", put(box, low), put(plank, {0.49, 0.26, 0})},
      {"a plank across a plank", put(plank, {0, 0.05, 0}), put(plank, {0, 0.3, 0}, 60, {0, 1, 0.5})},
      {"a can on a can", put(can, low), put(can, high, 10, {1, 0, 0.2})},
      {"cans on their sides", put(can, low, 90, {1, 0, 0}), put(can, high, 90, {1, 0, 0.2})},
      {"a spinning ball on a ball", put(ball, low), put(ball, high, 0, Vec3::UnitY(), spin)},
      {"a spinning capsule across a capsule", put(pill, low, 90, {1, 0, 0}),
       put(pill, high, 85, {1, 0, 0.2}, spin)}};
}

TEST_CASE("what one body does to another is the same whichever of them is named first") {
  const double h = GENERATE(1.0 / 60, 1.0 / 240);
  const Pair pair = GENERATE(from_range(pairs()));
  CAPTURE(pair.name, h);
  Setting first(h), second(h);
  first.ground();
  second.ground();
  const std::string low = first.add(pair.below), high = first.add(pair.above);
  const std::string other_high = second.add(pair.above), other_low = second.add(pair.below);
  Run one(first), other(second);
  one.go(0.5);
  other.go(0.5);
  CHECK((one.c(low) - other.c(other_low)).norm() < 2e-5);
  CHECK((one.c(high) - other.c(other_high)).norm() < 2e-5);
  CHECK((one.c(high) - one.start(high)).norm() > 1e-3);
}

// T11 of the findings. Each rounding grows with every hit: solved to the end, orders differ by no more than that.
TEST_CASE("a heap that falls together goes the same way whichever body comes first in the file") {
  const Shape shape = GENERATE(Shape(Sphere{0.12}), Shape(Box{Vec3(0.1, 0.08, 0.07)}));
  const double h = GENERATE(1.0 / 60, 1.0 / 240);
  CAPTURE(shape.index(), h);
  const auto fallen = [&](bool backwards) {
    std::vector<spec::Body> bodies;
    for (int k = 0; k < 27; ++k) {
      const Vec3 tilt(std::sin(1.0 + k), std::cos(2.0 * k), std::sin(3.0 * k));
      bodies.push_back(put(shape,
                           Vec3(0.32 * (k % 3), 0.4 + 0.34 * (k / 9), 0.32 * (k / 3 % 3)) + 0.02 * tilt,
                           13.0 * k, tilt));
      bodies.back().name = "x" + std::to_string(k);
    }
    if (backwards) std::reverse(bodies.begin(), bodies.end());
    Setting setting(h);
    setting.builder.params.solver.tolerance = 1e-9;
    setting.builder.params.solver.iterations = 400;
    if (!backwards) setting.ground();
    for (const spec::Body& body : bodies) setting.add(body);
    if (backwards) setting.ground();
    Run run(setting);
    run.go(1);
    return run;
  };
  const Run one = fallen(false), other = fallen(true);
  double apart = 0, way = 0;
  for (int k = 0; k < 27; ++k) {
    const std::string name = "x" + std::to_string(k);
    apart = std::max(apart, (one.c(name) - other.c(name)).norm());
    way = std::max(way, one.way(name).norm());
  }
  CHECK(apart < 1e-7);
  CHECK(way > 0.5);
}

// T7 of the findings: moves shrink with the square of the step, and what ends a solve must not be larger.
TEST_CASE("sweeps pass a hit on through a stack as newton does, at steps of 1 ms to 1 µs") {
  const double h = GENERATE(1e-3, 1e-4, 1e-5, 1e-6);
  CAPTURE(h);
  const auto hit = [&](SolverMethod method) {
    Setting setting(h);
    setting.builder.params.solver.method = method;
    setting.ground();
    for (int k = 0; k < 5; ++k) setting.add(Box{Vec3::Constant(0.25)}, 10, {0, 0.26 + 0.51 * k, 0});
    setting.add(spec::Body{
        .shape = Sphere{0.3}, .mass = 20.0, .position = Vec3(0, 2.612, 0), .velocity = Vec3(0, -2, 0)});
    Run run(setting);
    run.go(std::min(0.05, 1000 * h));
    return run;
  };
  const Run sweeps = hit(SolverMethod::descent), newton = hit(SolverMethod::newton);
  for (std::size_t i = 0; i < sweeps.state.c.size(); ++i)
    CHECK((sweeps.state.v[i] - newton.state.v[i]).norm() < 1e-3);
}

}  // namespace pabd::test_order
