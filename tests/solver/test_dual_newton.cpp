// SPDX-License-Identifier: MIT
// `newton` from the forces of the joints: the same steps as from the moves of the bodies, and what the joints
// remember from step to step.

#include <catch2/catch.hpp>
#include <random>

#include "sim/math/so3.h"
#include "tests/support/draws.h"
#include "tests/support/scenario.h"

namespace pabd::test_dual_newton {

using testing::make_joint;
using testing::World;

namespace {

// Spinning boxes in a tree of ball joints that hangs in space or from the world, some of its branches joined
// to loops; the same for a seed.
World random_tree(unsigned seed, int bodies, double kappa, bool hangs) {
  World world;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto vector = [&] { return testing::draw_vector([&] { return number(random); }); };
  world.params.solver.method = SolverMethod::newton;
  world.params.solver.iterations = 60;
  world.params.solver.tolerance = 1e-9;
  const auto join = [&](Index i, Index j, const Vec3& at) {
    Joint joint = make_joint(world, JointType::spherical, i, j, at);
    joint.law.kappa = kappa;
    world.model.joints.push_back(joint);
    if (i != kWorld) world.model.no_collide.push_back(std::minmax(i, j));
  };
  for (int k = 0; k < bodies; ++k) {
    const Vec3 half = 0.2 * (Vec3::Constant(1.2) + vector().cwiseAbs());
    const double mass = 1 + 5 * std::abs(number(random));
    const Vec3 c = Vec3(1.5 * k, 0, 0) + 0.3 * vector();
    const Index j = world.add(Box{half}, mass, c, exp_so3(vector()));
    world.state.omega.back() = 2 * vector();
    if (k == 0 && !hangs) continue;
    const Index i = k == 0 ? kWorld : static_cast<Index>(random() % static_cast<unsigned>(k));
    join(i, j, world.state.c[static_cast<std::size_t>(j)] - Vec3(0.75, 0.1, 0) + 0.3 * vector());
    if (k > 4 && k % 5 == 0 && i != k - 2) join(k - 2, j, world.state.c[static_cast<std::size_t>(j)]);
  }
  std::sort(world.model.no_collide.begin(), world.model.no_collide.end());
  for (Index i = 0; i < world.model.size(); ++i) {
    for (Index j = i + 1; j < world.model.size(); ++j) world.model.no_collide.emplace_back(i, j);
  }
  std::sort(world.model.no_collide.begin(), world.model.no_collide.end());
  return world;
}

// The same with a bond that is as good as none, but not a ball joint.
World by_moves(World world) {
  Joint joint = make_joint(world, JointType::distance, 0, 1, Vec3::Zero());
  joint.law.kappa = 1e-30;
  world.model.joints.push_back(joint);
  return world;
}

World row_of_links(int links, const Vec3& origin) {
  World world;
  world.params.h = 0.01;
  world.params.solver.method = SolverMethod::newton;
  for (int k = 0; k < links; ++k) world.add(Box{{0.45, 0.05, 0.05}}, 10, origin + Vec3(k + 0.5, 0, 0));
  for (int k = 0; k < links; ++k) {
    testing::add_joint(
        world, make_joint(world, JointType::spherical, k == 0 ? kWorld : k - 1, k, origin + Vec3(k, 0, 0)));
    if (k > 0) world.model.no_collide.emplace_back(k - 1, k);
  }
  return world;
}

}  // namespace

TEST_CASE("from the forces or from the moves, newton ends at the same poses") {
  const auto seed = GENERATE(1u, 2u, 3u, 4u);
  const auto kappa = GENERATE(1e3, 1e5, 1e8);
  const bool hangs = seed % 2 == 0;
  World forces = random_tree(seed, 12, kappa, hangs), moves = by_moves(forces);
  INFO("seed " << seed << ", kappa " << kappa);
  testing::run(forces, 10, {}, [](const StepReport& r) { CHECK(r.status == StepStatus::converged); });
  testing::run(moves, 10, {}, [](const StepReport& r) { CHECK(r.status == StepStatus::converged); });
  double apart = 0;
  for (std::size_t i = 0; i < forces.state.c.size(); ++i)
    apart = std::max(apart, (forces.state.c[i] - moves.state.c[i]).norm());
  CHECK(apart < 1e-7);
  REQUIRE(forces.state.joint_force.size() == forces.model.joints.size());
  for (std::size_t k = 0; k < forces.state.joint_force.size(); ++k) {
    const Vec3 f = forces.state.joint_force[k];
    CHECK((f - moves.state.joint_force[k]).norm() < 1e-5 * (1 + f.norm()));
  }
}

TEST_CASE("a state's joint forces are the reactions that the report tells") {
  World world = random_tree(7, 15, 1e7, true);
  StepReport report;
  testing::run(world, 5, {false, false, 1, {}, false, true}, [&](const StepReport& r) { report = r; });
  REQUIRE(report.status == StepStatus::converged);
  REQUIRE(report.joint_reports.size() == world.state.joint_force.size());
  for (std::size_t k = 0; k < report.joint_reports.size(); ++k) {
    const Vec3 f = report.joint_reports[k].force;
    CHECK((f - world.state.joint_force[k]).norm() < 1e-5 * (1 + f.norm()));
  }
}

TEST_CASE("a step that calls itself converged is as close to the minimum as its tolerance says") {
  const auto seed = GENERATE(21u, 22u, 23u, 24u, 25u, 26u);
  const auto kappa = GENERATE(1e4, 1e8, 1e11);
  World world = random_tree(seed, 25, kappa, seed % 2 == 0);
  world.params.solver.tolerance = 1e-6;
  World exact = world;
  exact.params.solver.tolerance = 0;
  exact.params.solver.iterations = 20;
  StepWorkspace workspace;
  StepReport report;
  for (int k = 0; k < 10; ++k) {
    exact.state = world.state;
    step(exact.model, exact.params, {}, exact.state, workspace, report);
    step(world.model, world.params, {}, world.state, workspace, report);
    REQUIRE(report.status == StepStatus::converged);
    double apart = 0;
    for (std::size_t i = 0; i < world.state.c.size(); ++i)
      apart = std::max(apart, (world.state.c[i] - exact.state.c[i]).norm());
    CHECK(apart < world.params.solver.tolerance * world.params.contact.d_hat);
  }
}

TEST_CASE("one iteration a step holds a chain to 1e-6 of a link, also 500 km from the origin") {
  const auto origin = GENERATE(Vec3(0, 0, 0), Vec3(-5e5, 0, 0), Vec3(3e5, 2e5, -4e5));
  World world = row_of_links(300, origin);
  world.params.solver.iterations = 1;
  double worst = 0;
  testing::run(world, 200, {}, [&](const StepReport& r) { worst = std::max(worst, r.max_joint_error); });
  CHECK(worst < 1e-6);
  CHECK(world.state.c.back().y() < origin.y() - 5);  // it does fall
}

TEST_CASE("a chain that meets the ground keeps its joints, and lies on it") {
  World world = row_of_links(20, Vec3(0, 0.8, 0));
  world.model.joints.erase(world.model.joints.begin());  // not held
  world.params.solver.iterations = 30;
  world.add_ground();
  double worst = 0;
  testing::run(world, 200, {}, [&](const StepReport& r) { worst = std::max(worst, r.max_joint_error); });
  CHECK(worst < 1e-6);
  for (int k = 0; k < 20; ++k) {
    CHECK(world.state.c[static_cast<std::size_t>(k)].y() > 0.05);
    CHECK(world.state.c[static_cast<std::size_t>(k)].y() < 0.07);
  }
}

TEST_CASE("a workspace that has seen another graph of joints gives the same bits as a fresh one") {
  const World tree = random_tree(11, 14, 1e6, true);
  World other = tree;
  std::swap(other.model.joints[3].i, other.model.joints[9].i);  // the same counts
  StepWorkspace used, fresh;
  StepReport report;
  State a = tree.state, b = tree.state;
  for (int k = 0; k < 10; ++k) {
    State elsewhere = other.state;
    step(other.model, other.params, {}, elsewhere, used, report);
    step(tree.model, tree.params, {}, a, used, report);
    step(tree.model, tree.params, {}, b, fresh, report);
    REQUIRE(same_bits(a, b));
    fresh = StepWorkspace();
  }
}

}  // namespace pabd::test_dual_newton
