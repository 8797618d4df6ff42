// SPDX-License-Identifier: MIT
// What a step reports about every body: islands, shares of the contact energy, the affine part.

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "sim/math/so3.h"
#include "tests/support/scenario.h"

namespace pabd::test_body_reports {

using testing::World;

namespace {

StepOptions with_reports() {
  StepOptions options;
  options.report_bodies = true;
  options.report_contacts = true;
  options.record_iterations = true;
  return options;
}

// Ground, a free body, two stacks, a chain of two from the world.
World mixed_world() {
  World world;
  world.add_ground();
  world.add_cube(1, 10, {0, 5000, 0});  // 1: far from everything
  world.add_cube(1, 100, {5, 0.509, 0});
  world.add_cube(1, 100, {0, 0.509, 0});
  world.add_cube(1, 100, {5, 1.518, 0});  // 4: on 2
  world.add(Box{{0.5, 0.1, 0.1}}, 2, {-9.5, 8, 0});
  world.add(Box{{0.5, 0.1, 0.1}}, 2, {-8.5, 8, 0});
  testing::add_joint(world, testing::make_joint(world, JointType::spherical, kWorld, 5, {-10, 8, 0}));
  testing::add_joint(world, testing::make_joint(world, JointType::spherical, 5, 6, {-9, 8, 0}));
  world.model.no_collide.emplace_back(5, 6);
  return world;
}

}  // namespace

TEST_CASE("islands are numbered by their lowest body; free and fixed bodies have none") {
  for (const SolverMethod method : {SolverMethod::automatic, SolverMethod::descent, SolverMethod::newton}) {
    World world = mixed_world();
    world.params.solver.method = method;
    StepReport report;
    testing::run(world, 1, with_reports(), [&](const StepReport& r) { report = r; });
    REQUIRE(report.body_reports.size() == 7);
    const Index expected[] = {-1, -1, 0, 1, 0, 2, 2};
    for (std::size_t i = 0; i < 7; ++i) {
      CAPTURE(to_string(method), i);
      CHECK(report.body_reports[i].island == expected[i]);
      CHECK(report.body_reports[i].projection_change == 0);
      CHECK(report.body_reports[i].det_A == 1);
    }
    CHECK(report.body_reports[6].solver ==
          (method == SolverMethod::descent ? SolverMethod::descent : SolverMethod::newton));
    double residual = 0;
    for (const BodyReport& body : report.body_reports) {
      residual = std::max(residual, body.residual);
      CHECK(body.residual == (body.island < 0 ? 0 : report.islands[body.island].residual));
    }
    CHECK(residual > 0);
    CHECK(residual == report.residual);
    if (method != SolverMethod::automatic)
      for (const int i : {2, 3, 4}) CHECK(report.body_reports[i].solver == method);
  }
}

TEST_CASE("contact energies of the bodies add up to the elastic energy to 1e-12, contacts count twice") {
  World world = mixed_world();
  world.model.joints.clear();
  world.params.solver.iterations = 200;
  StepReport report;
  testing::run(world, 200, with_reports(), [&](const StepReport& r) { report = r; });
  double energy = 0;
  int contacts = 0;
  for (const BodyReport& body : report.body_reports) {
    energy += body.contact_energy;
    contacts += body.contacts;
  }
  REQUIRE(report.contacts >= 12);
  CHECK(contacts == 2 * report.contacts);
  CHECK(energy == Approx(report.elastic).epsilon(1e-12));
  CHECK(report.body_reports[3].contacts == 4);
  CHECK(report.body_reports[4].contacts == 4);
  CHECK(report.body_reports[2].contacts == 8);
  // At rest a cube's four corners carry m g: Ψ(d) of a quarter of the weight each, half of it the ground's.
  const double kappa = report.kappa, d_hat = world.params.contact.d_hat;
  double d = d_hat;
  for (const ContactReport& contact : report.contact_reports)
    if (contact.b == 3) d = contact.d;
  const Barrier barrier{world.params.contact.barrier, world.params.contact.N, d_hat, kappa,
                        world.params.contact.onset};
  CHECK(evaluate(barrier, d).first == Approx(-100 * 9.81 / 4).epsilon(1e-4));
  CHECK(report.body_reports[3].contact_energy == Approx(2 * evaluate(barrier, d).value).epsilon(1e-4));
}

TEST_CASE("sissm reports each body's ‖A − R‖ and det A: the largest is that of the last record") {
  World world = mixed_world();
  world.model.joints.clear();
  world.params.solver.method = SolverMethod::sissm;
  world.params.solver.iterations = 30;
  world.params.solver.tolerance = 0;
  world.params.contact.kappa = 2000;
  StepReport report;
  testing::run(world, 20, with_reports(), [&](const StepReport& r) { report = r; });
  double largest = 0;
  for (const BodyReport& body : report.body_reports) largest = std::max(largest, body.projection_change);
  CHECK(largest > 1e-6);
  CHECK(largest == report.records.back().projection_change);
  CHECK(report.body_reports[2].solver == SolverMethod::sissm);
  CHECK(report.body_reports[1].projection_change == 0);  // flies free
  CHECK(report.body_reports[1].det_A == 1);
  // The lower of two stacked cubes is squeezed from above and below: thinner. |det A − 1| ≤ √3 ‖A − R‖ + ….
  const BodyReport& squeezed = report.body_reports[2];
  CHECK(squeezed.det_A < 1);
  CHECK(1 - squeezed.det_A < 1.8 * squeezed.projection_change);
  CHECK(1 - squeezed.det_A > 0.5 * squeezed.projection_change);
}

TEST_CASE("asking for body reports changes no bit of the result") {
  for (const SolverMethod method : {SolverMethod::automatic, SolverMethod::sissm}) {
    World with = mixed_world();
    with.params.solver.method = method;
    World without = with;
    testing::run(with, 40, with_reports());
    testing::run(without, 40, {}, [&](const StepReport& r) { CHECK(r.body_reports.empty()); });
    for (std::size_t i = 0; i < with.state.c.size(); ++i) {
      CHECK(std::memcmp(with.state.c[i].data(), without.state.c[i].data(), sizeof(Vec3)) == 0);
      CHECK(std::memcmp(with.state.R[i].data(), without.state.R[i].data(), sizeof(Mat3)) == 0);
    }
  }
}

}  // namespace pabd::test_body_reports
