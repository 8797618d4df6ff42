// SPDX-License-Identifier: MIT
// A step that is warm takes no memory from the system, whatever the number of iterations.

#include <catch2/catch.hpp>

#include "sim/body/compound.h"
#include "sim/body/convex_hull.h"
#include "tests/support/allocations.h"
#include "tests/support/scenario.h"

namespace pabd::test_allocation {

namespace {

Hull tetrahedron(double shift) {
  std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (Vec3& p : points) p.x() += shift;
  return Hull{make_hull(points).hull};
}

}  // namespace

TEST_CASE("a warm step allocates nothing") {
  for (const SolverMethod method : {SolverMethod::descent, SolverMethod::sissm, SolverMethod::newton}) {
    testing::World world;
    world.params.solver.method = method;
    world.params.solver.tolerance = 0;
    world.params.contact.rolling = world.params.contact.torsional = 0.001;
    world.add_ground();
    for (int k = 0; k < 20; ++k) world.add_cube(1, 100, {1.5 * (k % 5), 0.509 + 1.01 * (k / 5), 0});
    world.add(make_compound({tetrahedron(0), tetrahedron(0.3)}), 100, {0, 0.3, 3});
    world.add(make_compound({tetrahedron(0), tetrahedron(0.3)}), 100, {0, 1.1, 3});
    for (int k = 0; k < 10; ++k) {  // a chain, solved for its forces where `newton` has it
      const Index link = world.add(Box{{0.45, 0.05, 0.05}}, 10, {k + 0.5, 20, 8});
      testing::add_joint(world, testing::make_joint(world, JointType::spherical, k == 0 ? kWorld : link - 1,
                                                    link, Vec3(k, 20, 8)));
      if (k > 0) world.model.no_collide.emplace_back(link - 1, link);
    }
    for (int k = 0; k < 4; ++k) {  // gears, each after the one before
      const Index gear = world.add(Box{{0.3, 0.3, 0.05}}, 5, {1.5 * k, 30, 0});
      Joint joint = testing::make_joint(world, JointType::hinge, kWorld, gear, Vec3(1.5 * k, 30, 0));
      const auto number = static_cast<Index>(world.model.joints.size());
      if (k > 0) joint.follows = JointCoupling{number - 1, -1, 0};
      testing::add_joint(world, joint);
      world.state.omega[static_cast<std::size_t>(gear)] = Vec3(0, 0, k % 2 ? -3 : 3);
    }
    world.add(Sphere{0.3}, 5, {0, 0.305, 6});
    StepWorkspace workspace;
    StepReport report;
    const StepOptions options{true, true, 1};
    // The chain whips for ten seconds, and lists more pairs now and then.
    for (int k = 0; k < 600; ++k) step(world.model, world.params, options, world.state, workspace, report);
    const std::size_t before = test::allocations().count;
    REQUIRE(before > 0);  // it does count
    for (int k = 0; k < 10; ++k) step(world.model, world.params, options, world.state, workspace, report);
    const std::size_t during = test::allocations().count - before;
    INFO(to_string(method));
    CHECK(during == 0);
    CHECK(report.contacts > 0);
  }
}

}  // namespace pabd::test_allocation
