// SPDX-License-Identifier: MIT
// Numbers that are none, put in on purpose: the step says non_finite, changes nothing, and claims nothing.

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "sim/math/extremes.h"
#include "tests/support/scenario.h"

namespace pabd::test_non_finite {

using testing::World;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Two crates on each other, and one that hangs beside them.
World crates(SolverMethod method) {
  World world;
  world.params.solver.method = method;
  world.add_ground();
  world.add_cube(1, 10, {0, 0.505, 0});
  world.add_cube(1, 10, {0, 1.51, 0});
  const Index hanging = world.add_cube(1, 10, {5, 2, 0});
  add_joint(world, make_joint(world, JointType::spherical, kWorld, hanging, {5, 3, 0}));
  return world;
}

// Rest, then a step with `spoil`.
void require_non_finite(const char* what, const std::function<void(World&, StepOptions&)>& spoil) {
  for (const SolverMethod method :
       {SolverMethod::automatic, SolverMethod::descent, SolverMethod::newton, SolverMethod::sissm}) {
    INFO(what << ", " << to_string(method));
    World world = crates(method);
    StepOptions options{true, true};
    testing::run(world, 40, options,
                 [](const StepReport& r) { REQUIRE(r.status != StepStatus::non_finite); });
    spoil(world, options);
    const State before = world.state;
    testing::run(world, 1, options, [&](const StepReport& r) {
      CHECK(r.status == StepStatus::non_finite);
      for (const double quantity :
           {r.residual, r.kinetic, r.potential, r.elastic, r.min_gap, r.max_penetration, r.max_joint_error})
        CHECK_FALSE(std::isfinite(quantity));
      if (!r.records.empty()) CHECK_FALSE(std::isfinite(r.records.back().residual));
    });
    CHECK(same_bits(world.state, before));
  }
}

}  // namespace

TEST_CASE("the larger and the smaller of two numbers are none where one of them is none") {
  CHECK(larger(1, 2) == 2);
  CHECK(larger(2, 1) == 2);
  CHECK(smaller(1, 2) == 1);
  CHECK(smaller(2, 1) == 1);
  CHECK(larger(-kInfinity, kInfinity) == kInfinity);
  for (const double x : {0.0, -3.0, kInfinity}) {
    CHECK(std::isnan(larger(x, kNaN)));
    CHECK(std::isnan(larger(kNaN, x)));
    CHECK(std::isnan(smaller(x, kNaN)));
    CHECK(std::isnan(smaller(kNaN, x)));
  }
}

TEST_CASE("a force that is no number: the step fails, whatever line searches make of it") {
  require_non_finite("stiffness of a joint",
                     [](World& world, StepOptions&) { world.model.joints[0].law.kappa = kNaN; });
  require_non_finite("place of a joint",
                     [](World& world, StepOptions&) { world.model.joints[0].on_i.r.y() = kNaN; });
  require_non_finite("place of a hand on a crate of the stack", [](World&, StepOptions& options) {
    options.pulls = {{2, Vec3::Zero(), {0, kNaN, 0}, 100}};
  });
  require_non_finite("strength of a hand", [](World&, StepOptions& options) {
    options.pulls = {{1, Vec3::Zero(), {0, 1, 0}, kNaN}};
  });
  require_non_finite("stiffness of contacts",
                     [](World& world, StepOptions&) { world.params.contact.kappa = kNaN; });
}

TEST_CASE("a state or a mass that is no number, or runs out of the numbers, fails") {
  require_non_finite("place", [](World& world, StepOptions&) { world.state.c[2].x() = kNaN; });
  require_non_finite("rotation", [](World& world, StepOptions&) { world.state.R[1](0, 1) = kNaN; });
  require_non_finite("velocity", [](World& world, StepOptions&) { world.state.v[3].z() = kNaN; });
  require_non_finite("velocity, infinite",
                     [](World& world, StepOptions&) { world.state.v[1].x() = kInfinity; });
  require_non_finite("spin", [](World& world, StepOptions&) { world.state.omega[2].y() = kNaN; });
  require_non_finite("mass", [](World& world, StepOptions&) { world.model.mass[1] = kNaN; });
  require_non_finite("gravity", [](World& world, StepOptions&) { world.params.gravity.x() = kNaN; });
}

}  // namespace pabd::test_non_finite
