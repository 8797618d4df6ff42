// SPDX-License-Identifier: MIT
// A step that ends unsolved is made again in halves, and what is unsolved at the end makes no energy: over shapes, sizes,
// steps and joints that nobody chose for it.

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "sim/math/so3.h"
#include "sim/scene/scene.h"
#include "sim/solver/step_summary.h"
#include "tests/support/places.h"
#include "tests/support/sanitized.h"
#include "tests/support/scenario.h"

namespace pabd::test_halving {

using testing::World;

namespace {

// Long boxes that lie across each other, each at its own angle, and fall.
World planks(int count, double length, double h, unsigned seed) {
  World world;
  world.params.h = h;
  std::mt19937 rng(seed);
  std::uniform_real_distribution<double> one(-1, 1);
  world.add_ground();
  for (int k = 0; k < count; ++k)
    world.add(Box{{length / 2, 0.05, 0.05}}, 10 * length, {0.3 * one(rng), 0.2 + 0.15 * k, 0.3 * one(rng)},
              exp_so3({0, 3 * one(rng), 0}));
  return world;
}

// A ball that flies into a hanging chain of links.
World struck_chain(int links, double speed, double h) {
  World world;
  world.params.h = h;
  Index before = kWorld;
  for (int k = 0; k < links; ++k) {
    const Index link = world.add(Box{{0.05, 0.1, 0.05}}, 2, {0, -0.1 - 0.2 * k, 0});
    testing::add_joint(world,
                       testing::make_joint(world, JointType::spherical, before, link, {0, -0.2 * k, 0}));
    if (before != kWorld) world.model.no_collide.emplace_back(before, link);
    before = link;
  }
  world.state.v[world.add(Sphere{0.3}, 200, {-2, -0.1 * links, 0.01})] = {speed, 0, 0};
  return world;
}

#ifdef PABD_SANITIZED
constexpr int kSteps = 20;  // it is the memory that is looked at then
#else
constexpr int kSteps = 240;
#endif

double energy(const StepReport& r) { return r.kinetic + r.potential + r.elastic; }

struct Outcome {
  double scale = 0, rise = 0, gained = 0, joint_error = 0;  // J, J, J (rise without Ψ), m
  int halved = 0, unsolved = 0, deepest = 0;                // steps, steps, levels
};
Outcome measured(World& world, double seconds) {
  Outcome out;
  const double most =
      kinetic_energy(world.model, world.state) + potential_energy(world.model, world.params, world.state);
  out.scale = std::abs(most);
  testing::run(world, static_cast<int>(std::lround(seconds / world.params.h)), {}, [&](const StepReport& r) {
    REQUIRE(r.status != StepStatus::non_finite);
    out.rise = std::max(out.rise, energy(r) - most);
    out.gained = std::max(out.gained, r.kinetic + r.potential - most);
    out.joint_error = std::max(out.joint_error, r.max_joint_error);
    out.halved += r.halved_bodies > 0 ? 1 : 0;
    out.unsolved += r.status == StepStatus::iteration_limit && r.residual > 0.03 ? 1 : 0;
    out.deepest = std::max(out.deepest, r.halvings);
  });
  return out;
}

}  // namespace

TEST_CASE("planks of any length that fall in a heap make no energy, with the defaults") {
  const double length = GENERATE(0.5, 0.7, 1.0, 2.0);
  const double h = GENERATE(1.0 / 30, 1.0 / 60, 1.0 / 240);
  World world = planks(30, length, h, static_cast<unsigned>(100 * length));
  const Outcome out = measured(world, 1.5);
  CAPTURE(length, h, out.halved, out.unsolved, out.deepest);
  CHECK(out.rise < 1e-6 * out.scale);
  CHECK(out.deepest <= SolverParams{}.halvings);
}

TEST_CASE("a ball that strikes a hanging chain opens no joint and makes no energy") {
  const double speed = GENERATE(5, 20, 60);
  const double h = GENERATE(1.0 / 60, 1.0 / 240);
  World world = struck_chain(12, speed, h);
  const Outcome out = measured(world, 1);
  CAPTURE(speed, h, out.halved, out.unsolved);
  CHECK(out.rise < 1e-6 * out.scale);
  CHECK(out.joint_error < 1e-4);
}

TEST_CASE("hits that turn bodies into others make no energy: whole scenes, with the defaults") {
  for (const char* name : {"dominoes", "wall", "chairs", "arch"}) {
    Scene scene = load_scene(places::assets() + "/scenes/" + name + ".json");
    scene.params.h = Params{}.h;
    scene.params.solver = SolverParams{};
    World world;
    world.model = scene.model;
    world.params = scene.params;
    world.state = scene.initial;
    // Where a scene starts bodies may be pressed against each other.
    double last = std::numeric_limits<double>::infinity();
    double rise = 0, fastest = 0, overlap = 0;
    testing::run(world, kSteps, {}, [&](const StepReport& r) {
      rise = std::max(rise, energy(r) - last);
      last = energy(r);
      fastest = std::max(fastest, r.kinetic);
      overlap = std::max(overlap, r.max_penetration);
    });
    CAPTURE(name, fastest);
    CHECK(rise < 1e-6 * fastest);
    CHECK(overlap == 0);
  }
}

TEST_CASE(
    "an island that is halved leaves the bits of others alone, and the bits are the same for every number of "
    "threads") {
  World planks_alone = planks(12, 1, 1.0 / 60, 3), together = planks_alone;
  const Index ball = together.add(Sphere{0.2}, 1, {50, 0.5, 0}),
              box = together.add_cube(0.3, 2, {53, 0.16, 0});
  together.state.omega[ball] = {0, 0, -9};
  planks_alone.params.contact.kappa = together.params.contact.kappa = 5e3;  // "auto" knows all masses
  World alone;
  alone.params = together.params;
  alone.add_ground();
  alone.state.omega[alone.add(Sphere{0.2}, 1, {50, 0.5, 0})] = {0, 0, -9};
  alone.add_cube(0.3, 2, {53, 0.16, 0});
  World threaded = together;
  StepOptions many;
  many.threads = 3;
  int halved = 0;
  const auto count = [&](const StepReport& r) {
    halved += r.halved_bodies > 0 ? 1 : 0;
    CHECK(r.halved_bodies <= 12);
  };
  testing::run(together, 60, {}, count);
  testing::run(threaded, 60, many);
  testing::run(planks_alone, 60);
  testing::run(alone, 60);
  CHECK(halved > 0);
  CHECK(same_bits(together.state, threaded.state));
  for (Index i = 0; i <= 12; ++i) {
    CHECK(together.state.c[i] == planks_alone.state.c[i]);
    CHECK(together.state.omega[i] == planks_alone.state.omega[i]);
  }
  for (const auto& [here, there] : {std::pair(ball, 1), std::pair(box, 2)}) {
    CHECK(together.state.c[here] == alone.state.c[there]);
    CHECK(together.state.R[here] == alone.state.R[there]);
    CHECK(together.state.v[here] == alone.state.v[there]);
    CHECK(together.state.omega[here] == alone.state.omega[there]);
  }
}

TEST_CASE("the report of a step in halves is that of all bodies") {
  World world = planks(12, 1, 1.0 / 60, 3);
  const Index hinged = world.add_cube(0.2, 1, {40, 5, 0});
  testing::add_joint(world, testing::make_joint(world, JointType::hinge, kWorld, hinged, {39.8, 5, 0}));
  StepOptions options;
  options.report_contacts = options.report_bodies = options.report_joints = true;
  int halved = 0;
  testing::run(world, 90, options, [&](const StepReport& r) {
    if (r.halved_bodies == 0) return;
    ++halved;
    CHECK(r.kinetic == Approx(kinetic_energy(world.model, world.state)).epsilon(1e-12));
    CHECK(r.potential == Approx(potential_energy(world.model, world.params, world.state)).epsilon(1e-12));
    CHECK(r.time == Approx(world.state.time));
    CHECK(r.step == world.state.step);
    CHECK(r.body_reports.size() == world.model.shape.size());
    CHECK(r.joint_reports.size() == 1);
    CHECK(r.joint_reports[0].force.norm() > 0);
    CHECK(static_cast<std::size_t>(r.contacts) == r.contact_reports.size());
    int ends = 0;
    for (const BodyReport& body : r.body_reports) ends += body.contacts;
    CHECK(ends == 2 * r.contacts);
    for (const ContactReport& contact : r.contact_reports) {
      // Where the bodies are at the end of the step: y_b is on b.
      const Vec3 in_b = world.state.R[contact.b].transpose() * (contact.y_b - world.state.c[contact.b]);
      CHECK((in_b.cwiseAbs() - Vec3(0.5, 0.05, 0.05)).maxCoeff() < 1e-6);
    }
  });
  CHECK(halved > 0);
}

TEST_CASE("without halvings nothing is made again, and energy is bounded all the same") {
  const unsigned seed = GENERATE(100u, 101u, 102u, 103u);
  CAPTURE(seed);
  World world = planks(30, 1, 1.0 / 60, seed);
  world.params.solver.halvings = 0;
  const Outcome out = measured(world, 1.5);
  CHECK(out.halved == 0);
  // Ψ is left out: a step may find bodies deep in each other that no step before knew to touch.
  CHECK(out.gained < 1e-6 * out.scale);
  CHECK(out.unsolved > 0);
}

}  // namespace pabd::test_halving
