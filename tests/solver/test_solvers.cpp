// SPDX-License-Identifier: MIT
// What each solver promises about one step.

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <random>

#include "sim/math/so3.h"
#include "tests/support/scenario.h"

namespace pabd::test_solvers {

using testing::World;

namespace {

// Boxes thrown together: contacts of every kind, deep ones among them.
World heap(int count, double mu) {
  World world;
  world.params.contact.mu_static = world.params.contact.mu_dynamic = mu;
  world.params.contact.d_hat = 0.02;
  world.params.solver.method = SolverMethod::descent;
  world.add_ground();
  std::mt19937 rng(5);
  const auto uniform = [&](double lo, double hi) { return lo + (hi - lo) * (rng() / 4294967296.0); };
  for (int k = 0; k < count; ++k) {
    const double x = uniform(-2, 2), z = uniform(-2, 2);
    const Vec3 c(x, 0.6 + 0.35 * k, z);
    const Mat3 R = exp_so3({uniform(-3, 3), uniform(-3, 3), uniform(-3, 3)});
    switch (k % 3) {
      case 0:
        world.add(Box{{0.4, 0.3, 0.5}}, 100, c, R);
        break;
      case 1:
        world.add(Sphere{0.35}, 80, c, R);
        break;
      default:
        world.add(Capsule{0.25, 0.6}, 60, c, R);
        break;
    }
  }
  return world;
}

// Two cubes, the upper one on a corner, 0.1 inside the lower.
World corner_contact() {
  World world;
  world.params.gravity.setZero();
  world.params.contact.d_hat = 0.05;
  world.params.contact.kappa = 1e3;
  world.params.contact.onset = 0;
  world.params.contact.mu_static = world.params.contact.mu_dynamic = 0;
  world.params.solver.tolerance = 0;
  world.add_cube(1, 1000, {0, 0.5, 0});
  const Mat3 on_corner = rotation_between(Vec3(1, 1, 1), Vec3(0.1, 1, 0.05));
  world.add_cube(1, 1000, {0, 1 - 0.1 + std::sqrt(3.0) / 2, 0}, on_corner);
  return world;
}

StepReport one_step(World& world) {
  StepReport out;
  testing::run(world, 1, {true, true, 1}, [&](const StepReport& r) { out = r; });
  return out;
}

bool same_bytes(const State& a, const State& b) {
  const auto equal = [](const auto& x, const auto& y) {
    return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof(x[0])) == 0;
  };
  return equal(a.c, b.c) && equal(a.R, b.R) && equal(a.v, b.v) && equal(a.omega, b.omega) && a.time == b.time;
}

}  // namespace

TEST_CASE("E never rises within a descent solve") {
  for (const Projection projection : {Projection::tangent, Projection::weighted}) {
    World world = heap(30, 0);
    world.params.solver.projection = projection;
    int falls = 0;
    testing::run(world, 200, {true, false, 1}, [&](const StepReport& r) {
      for (std::size_t k = 1; k < r.records.size(); ++k) {
        // Rounding of places: m (1e-16 m)²/h² of each body that flies.
        CHECK(r.records[k].energy <= r.records[k - 1].energy * (1 + 1e-12) + 1e-25);
        if (r.records[k].energy < r.records[k - 1].energy) ++falls;
      }
    });
    CHECK(falls > 100);
  }
}

TEST_CASE("both projections of descent and weighted sissm end at the same minimum of E") {
  std::vector<double> energies;
  for (const auto& [method, projection] : {std::pair{SolverMethod::descent, Projection::tangent},
                                           std::pair{SolverMethod::descent, Projection::weighted},
                                           std::pair{SolverMethod::sissm, Projection::weighted}}) {
    World world = corner_contact();
    world.params.solver.method = method;
    world.params.solver.projection = projection;
    world.params.solver.iterations = 5000;
    energies.push_back(one_step(world).records.back().energy);
  }
  CHECK(energies[1] == Approx(energies[0]).epsilon(1e-9));
  CHECK(energies[2] == Approx(energies[0]).epsilon(1e-6));
}

TEST_CASE("the projection curves of sissm become flat within 100 iterations, and A is no rotation there") {
  World world = corner_contact();
  world.params.solver.method = SolverMethod::sissm;
  world.params.solver.projection = Projection::polar;
  world.params.solver.iterations = 100;
  const StepReport report = one_step(world);
  REQUIRE(report.records.size() == 100);
  const IterationRecord& last = report.records[99];
  const IterationRecord& previous = report.records[98];
  CHECK(std::abs(last.min_gap_before - previous.min_gap_before) < 1e-6);
  CHECK(std::abs(last.min_gap_after - previous.min_gap_after) < 1e-6);
  CHECK(last.projection_change > 1e-3);
  CHECK(last.min_gap_before >
        last.min_gap_after);  // the projection takes back the squeeze of the affine boxes
}

TEST_CASE("sissm's unweighted fixed point is not the minimum of E; descent's is") {
  World paper = corner_contact(), ours = corner_contact();
  paper.params.solver.method = SolverMethod::sissm;
  paper.params.solver.projection = Projection::polar;
  ours.params.solver.method = SolverMethod::descent;
  paper.params.solver.iterations = ours.params.solver.iterations = 2000;
  const double e_paper = one_step(paper).records.back().energy;
  const double e_ours = one_step(ours).records.back().energy;
  CHECK(e_paper > e_ours * 1.01);
}

TEST_CASE("the same scene gives the same bytes in every run and for 1, 2 and 8 threads") {
  for (const SolverMethod method : {SolverMethod::descent, SolverMethod::sissm}) {
    std::vector<State> ends;
    for (const int threads : {1, 1, 2, 8}) {
      World world = heap(400, 0.5);
      world.params.solver.method = method;
      testing::run(world, 20, {false, false, threads});
      ends.push_back(world.state);
    }
    for (const State& end : ends) CHECK(same_bytes(end, ends[0]));
  }
}

TEST_CASE("tolerance stops early and the report says so") {
  World world;
  world.params.solver.iterations = 500;
  world.add_ground();
  world.add_cube(1, 1000, {0, 0.509, 0});
  testing::run(world, 60);
  const StepReport report = one_step(world);
  CHECK(report.status == StepStatus::converged);
  CHECK(report.iterations < 20);
  world.params.solver.tolerance = 0;
  CHECK(one_step(world).status == StepStatus::iteration_limit);
}

TEST_CASE("converged means converged: bodies that waited are where a solve without end puts them") {
  World world = heap(40, 0);
  world.params.solver.iterations = 5000;
  int converged = 0;
  StepWorkspace workspace;
  StepReport report;
  for (int k = 0; k < 60; ++k) {
    World exact = world;
    exact.params.solver.tolerance = 1e-12;
    step(exact.model, exact.params, {}, exact.state, workspace, report);
    step(world.model, world.params, {}, world.state, workspace, report);
    if (report.status != StepStatus::converged) continue;
    ++converged;
    // A sweep takes at least a tenth of the error away here, and the last one moved nobody by 1e-6 d̂.
    for (std::size_t i = 0; i < world.state.c.size(); ++i)
      CHECK((world.state.c[i] - exact.state.c[i]).norm() < 1e-3 * world.params.contact.d_hat);
  }
  CHECK(converged > 50);
}

TEST_CASE("descent does not call joints solved that it has hardly begun to move") {
  // Sweeps take long over joints. At short steps their moves are below the tolerance from the first one on.
  const double h = GENERATE(5e-6, 1e-5, 2e-5);
  const auto falls = [&](SolverMethod method, int iterations) {
    World world;
    world.params.h = h;
    world.params.solver.method = method;
    world.params.solver.iterations = iterations;
    world.params.solver.halvings = 0;
    for (int k = 0; k < 4; ++k) {
      const Vec3 c(0.1 + 0.2 * k, 0, 0);
      const Index link = world.add(Box{{0.1, 0.02, 0.02}}, k < 3 ? 0.1 : 2, c);
      Joint hinge = testing::make_joint(world, JointType::spherical, k > 0 ? link - 1 : kWorld, link,
                                        c - Vec3(0.1, 0, 0));
      testing::add_joint(world, hinge);
    }
    int converged = 0;
    testing::run(world, 5, {}, [&](const StepReport& r) { converged += r.status == StepStatus::converged; });
    return std::make_pair(world.state.v.back(), converged);
  };
  const auto [exact, solved] = falls(SolverMethod::newton, 20);
  REQUIRE(solved == 5);
  CHECK(falls(SolverMethod::descent, 20).second == 0);
  const auto [swept, converged] = falls(SolverMethod::descent, 20000);
  CAPTURE(h, converged, swept.transpose(), exact.transpose());
  CHECK((swept - exact).norm() < 0.01 * exact.norm());
}

TEST_CASE("surprises stay finite: stiff, soft, light, heavy, coarse, deep") {
  for (const double kappa : {1e-3, 1.0, 1e12}) {
    for (const double h : {1e-4, 0.1}) {
      for (const int N : {1, 8, 32}) {
        World world = heap(12, 0.5);
        world.params.contact.kappa = kappa;
        world.params.contact.N = N;
        world.params.h = h;
        for (Index i = 1; i < world.model.size(); i += 2) {
          world.model.mass[i] *= 1e6;
          world.model.J[i] *= 1e6;
        }
        for (Vec3& c : world.state.c) c.y() = std::min(c.y(), 1.0);  // all in one place
        testing::run(world, 20, {}, [&](const StepReport& r) {
          INFO("κ " << kappa << " h " << h << " N " << N);
          CHECK(r.status != StepStatus::non_finite);
        });
      }
    }
  }
}

}  // namespace pabd::test_solvers
