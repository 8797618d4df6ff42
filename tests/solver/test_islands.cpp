// SPDX-License-Identifier: MIT
// Islands are independent: what happens in one leaves the bits of all others alone.

#include <catch2/catch.hpp>
#include <cstring>

#include "sim/math/so3.h"
#include "tests/support/scenario.h"

namespace pabd::test_islands {

using testing::World;

namespace {

// A heap that falls onto the ground, and a chain on it.
World heap(SolverMethod method) {
  World world;
  world.params.solver.method = method;
  world.params.contact.kappa = 500;  // "auto" knows all masses
  world.add_ground();
  for (int k = 0; k < 12; ++k) {
    const Vec3 c{0.7 * std::sin(2.0 * k), 0.6 + 0.55 * k, 0.7 * std::cos(3.0 * k)};
    const Mat3 R = cayley(Vec3(0.3 * std::sin(k), 0.2, 0.1 * k));
    if (k % 3 == 2) {
      world.add(Sphere{0.25}, 1 + k, c, R);
    } else {
      world.add(Box{{0.3, 0.25, 0.2}}, 1 + k, c, R);
    }
  }
  Joint joint =
      testing::make_joint(world, JointType::spherical, 5, 6, 0.5 * (world.state.c[5] + world.state.c[6]));
  joint.law.kappa = 1e5;
  world.model.joints.push_back(joint);
  world.model.no_collide.emplace_back(5, 6);
  return world;
}

// Far from it: a stiff pendulum that is hit by a fast ball, a ball that spins, and one that flies.
void add_distant_company(World& world) {
  const Index rod = world.add(Box{{0.5, 0.05, 0.05}}, 2, {200.5, 10, 0});
  Joint joint = testing::make_joint(world, JointType::hinge, kWorld, rod, {200, 10, 0});
  joint.law.kappa = 1e6;
  world.model.joints.push_back(joint);
  world.state.v[world.add(Sphere{0.2}, 5, {201, 14, 0})] = {0, -80, 0};
  world.state.omega[world.add(Sphere{0.3}, 1, {-300, 0.3, 0})] = {0, 0, 50};
  world.state.v[world.add_cube(0.4, 3, {0, 500, 0})] = {100, 0, 0};
}

bool same(const Vec3& a, const Vec3& b) { return std::memcmp(a.data(), b.data(), sizeof(Vec3)) == 0; }
bool same(const Mat3& a, const Mat3& b) { return std::memcmp(a.data(), b.data(), sizeof(Mat3)) == 0; }

}  // namespace

TEST_CASE("what is far away leaves the bits of an island alone, whatever solves it") {
  const auto method =
      GENERATE(SolverMethod::automatic, SolverMethod::descent, SolverMethod::newton, SolverMethod::sissm);
  const int threads = GENERATE(1, 3);
  World alone = heap(method), together = heap(method);
  add_distant_company(together);
  StepOptions options;
  options.threads = threads;
  StepWorkspace workspace_alone, workspace_together;
  StepReport report;
  std::size_t most_islands = 0;
  bool all_same = true;
  for (int k = 0; k < 90; ++k) {
    step(alone.model, alone.params, options, alone.state, workspace_alone, report);
    step(together.model, together.params, options, together.state, workspace_together, report);
    most_islands = std::max(most_islands, report.islands.size());
    for (std::size_t i = 0; i < alone.state.c.size(); ++i) {
      all_same &=
          same(alone.state.c[i], together.state.c[i]) && same(alone.state.R[i], together.state.R[i]) &&
          same(alone.state.v[i], together.state.v[i]) && same(alone.state.omega[i], together.state.omega[i]);
    }
  }
  CAPTURE(to_string(method), threads);
  CHECK(all_same);
  CHECK(most_islands >= 3);
  CHECK(alone.state.c[12].y() < 3);  // the heap did fall
}

TEST_CASE("the report names every island, its bodies, its solver and how its solve went") {
  World world;
  world.add_ground();
  for (int k = 0; k < 3; ++k) world.add_cube(1, 10, {0, 0.5099 + 1.0099 * k, 0});  // 1, 2, 3
  const Index rod = world.add(Box{{0.5, 0.05, 0.05}}, 2, {20.5, 10, 0});           // 4
  testing::add_joint(world, testing::make_joint(world, JointType::hinge, kWorld, rod, {20, 10, 0}));
  world.add_cube(1, 10, {0, 100, 0});  // 5: flies
  StepReport last;
  StepOptions options;
  options.report_bodies = true;
  testing::run(world, 5, options, [&](const StepReport& report) { last = report; });
  REQUIRE(last.islands.size() == 2);
  CHECK(last.islands[0].first_body == 1);
  CHECK(last.islands[0].bodies == 3);
  CHECK(last.islands[0].manifolds == 3);
  CHECK(last.islands[0].joints == 0);
  CHECK(last.islands[1].first_body == rod);
  CHECK(last.islands[1].bodies == 1);
  CHECK(last.islands[1].joints == 1);
  CHECK(last.islands[1].solver == SolverMethod::newton);
  CHECK(last.iterations == std::max(last.islands[0].iterations, last.islands[1].iterations));
  CHECK(last.residual == std::max(last.islands[0].residual, last.islands[1].residual));
  CHECK(last.body_reports[2].island == 0);
  CHECK(last.body_reports[2].solver == last.islands[0].solver);
  CHECK(last.body_reports[static_cast<std::size_t>(rod)].island == 1);
  CHECK(last.body_reports[5].island == -1);
}

}  // namespace pabd::test_islands
