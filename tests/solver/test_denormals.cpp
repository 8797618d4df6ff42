// SPDX-License-Identifier: MIT
// Denormal numbers are zero within a step, in every thread, and nowhere else.

#include <catch2/catch.hpp>
#include <cfenv>
#include <cstring>
#include <limits>

#include "sim/math/flush_denormals.h"
#include "sim/math/team.h"
#include "tests/support/scenario.h"

namespace pabd::test_denormals {

using testing::World;

#if defined(__SSE2__)

namespace {

constexpr unsigned kFlush = 0x8040;  // flush to zero, denormals are zero

// Half of the smallest normal number, computed now.
double half_of_least() {
  volatile double least = std::numeric_limits<double>::min();
  volatile double half = 0.5 * least;
  return half;
}

// Bodies that swing in a plane, with speeds across it that no normal number holds.
World pendulums() {
  World world;
  for (int k = 0; k < 600; ++k) {
    const Index i = world.add_cube(0.2, 1 + 0.01 * k, {1.0 * k, -0.5, 0});
    world.state.v[i] = {1, 0, 3e-310};
    world.state.omega[i] = {2e-309, 0, 0.1};
    testing::add_joint(world, testing::make_joint(world, JointType::spherical, kWorld, i, {1.0 * k, 0, 0}));
  }
  return world;
}

State stepped(int threads) {
  World world = pendulums();
  testing::run(world, 3, {false, false, threads});
  return world.state;
}

bool same_bytes(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
}

}  // namespace

TEST_CASE("a step leaves the floating point settings of its caller as they were") {
  const unsigned before = _mm_getcsr();
  for (const unsigned setting : {before, before | kFlush, before | 0x6000u}) {  // the last rounds to zero
    World world = pendulums();
    StepWorkspace workspace;
    StepReport report;
    _mm_setcsr(setting);
    step(world.model, world.params, {false, false, 2}, world.state, workspace, report);
    const unsigned after = _mm_getcsr();
    _mm_setcsr(before);
    CHECK(after == setting);
  }
}

TEST_CASE("the result of a step does not depend on the settings of its caller, nor on threads") {
  const unsigned before = _mm_getcsr();
  const State expected = stepped(1);
  CHECK(expected.v[0].z() == 0);  // flushed
  for (const unsigned setting : {before | kFlush, before | 0x2000u, before | 0x6000u}) {
    for (const int threads : {1, 3}) {
      _mm_setcsr(setting);
      const State state = [&] {
        _mm_setcsr(before);
        World w = pendulums();  // the scene itself is built as always
        _mm_setcsr(setting);
        StepWorkspace workspace;
        StepReport report;
        for (int k = 0; k < 3; ++k)
          step(w.model, w.params, {false, false, threads}, w.state, workspace, report);
        return w.state;
      }();
      _mm_setcsr(before);
      CHECK(same_bytes(state.c, expected.c));
      CHECK(same_bytes(state.v, expected.v));
      CHECK(same_bytes(state.omega, expected.omega));
    }
  }
}

TEST_CASE("members of a team flush, the caller does as it likes") {
  Team team;
  CHECK(half_of_least() > 0);
  {
    const FlushDenormals flush;
    CHECK(half_of_least() == 0);
    std::vector<double> halves(4096, 1);
    team.for_each(4, halves.size(), 1, [&](std::size_t k) { halves[k] = half_of_least(); });
    for (const double half : halves) REQUIRE(half == 0);
  }
  CHECK(half_of_least() > 0);
}

#endif

}  // namespace pabd::test_denormals
