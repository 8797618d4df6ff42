// SPDX-License-Identifier: MIT
// Forces and torques from outside, against closed forms (sim/solver/free_flight.h).
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/body/mass_properties.h"
#include "sim/scene/builder.h"
#include "sim/solver/step_summary.h"
#include "sim/solver/time_step.h"

namespace pabd::test_external {

namespace {

using Push = Keyed<Vec3>;

Push always(const Vec3& value) { return {{{0, value}}}; }

struct Run {
  explicit Run(SceneBuilder& builder) : scene(builder.build()), state(scene.initial) {}
  void go(double seconds) {
    for (int k = 0; k < std::lround(seconds / scene.params.h); ++k) {
      step(scene.model, scene.params, {}, state, workspace, report);
      REQUIRE(report.status == StepStatus::converged);
      work += report.drive_work;
      halved += report.halved_bodies;
    }
  }
  double energy() const {
    return kinetic_energy(scene.model, state) + potential_energy(scene.model, scene.params, state);
  }
  Scene scene;
  State state;
  StepWorkspace workspace;
  StepReport report;
  double work = 0;
  int halved = 0;
};

SceneBuilder in_space(double h, Integrator integrator = Integrator::bdf2) {
  SceneBuilder builder("pushed");
  builder.params.h = h;
  builder.params.gravity.setZero();
  builder.params.solver.integrator = integrator;
  return builder;
}

// 2 × 1 × 0.5 m, 3 kg.
spec::Body brick() {
  return {.name = "brick", .shape = Box{{1, 0.5, 0.25}}, .mass = 3.0, .position = Vec3(1, 2, 3)};
}
const Vec3 kInertia = 3.0 / 12 * Vec3(1 + 0.25, 4 + 0.25, 4 + 1);

}  // namespace

TEST_CASE("a body alone goes as forces that are constant or grow steadily have it, exactly at any step") {
  for (const double h : {1.0 / 30, 1.0 / 60, 1.0 / 1000}) {
    CAPTURE(h);
    SceneBuilder builder = in_space(h);
    builder.params.gravity = Vec3(0, -9.81, 0);
    spec::Body body = brick();
    body.velocity = Vec3(1, 0, 0);
    body.force = Push{{{0, Vec3(6, 0, 0)}, {10, Vec3(6, 0, 30)}}};  // N
    builder.add(body);
    Run run(builder);
    run.go(2);
    CHECK((run.state.v[0] - Vec3(1 + 2 * 2, -9.81 * 2, 3 * 4 / 2 / 3.0)).norm() < 1e-9);
    CHECK((run.state.c[0] - Vec3(1 + 2 + 4, 2 - 9.81 * 2, 3 + 3 * 8 / 6 / 3.0)).norm() < 1e-9);
  }
}

TEST_CASE("a torque about a principal axis turns a body as τ t²/2I, each axis with its own moment") {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double h : {1.0 / 60, 1.0 / 240}) {
      CAPTURE(axis, h);
      SceneBuilder builder = in_space(h);
      spec::Body body = brick();
      body.torque = always(Vec3::Unit(axis));
      builder.add(body);
      Run run(builder);
      run.go(1);
      CHECK(run.state.omega[0][axis] == Approx(1 / kInertia[axis]).epsilon(1e-9));
      const double angle = log_so3(run.state.R[0])[axis];
      CHECK(angle == Approx(0.5 / kInertia[axis]).epsilon(1e-9));
      CHECK(run.work == Approx(run.energy()).epsilon(0.05));
    }
  }
}

TEST_CASE("by Euler a force acts as at the end of each step") {
  const double h = 1.0 / 60;
  SceneBuilder builder = in_space(h, Integrator::euler);
  spec::Body body = brick();
  body.force = Push{{{0, Vec3::Zero()}, {1, Vec3(3, 0, 0)}}};
  builder.add(body);
  Run run(builder);
  double v = 0, x = 1;
  for (int k = 1; k <= 60; ++k) {
    v += h * k * h;
    x += h * v;
  }
  run.go(1);
  CHECK(run.state.v[0].x() == Approx(v).epsilon(1e-12));
  CHECK(run.state.c[0].x() == Approx(x).epsilon(1e-12));
}

TEST_CASE("a block on a plane is pushed away by what is above μ m g, and stays below it") {
  for (const double share : {0.9, 1.5}) {
    for (const double h : {1.0 / 60, 1.0 / 240}) {
      CAPTURE(share, h);
      SceneBuilder builder("pushed");
      builder.params.h = h;
      builder.params.contact.mu_static = builder.params.contact.mu_dynamic = 0.4;
      builder.add(spec::Body{.name = "ground", .shape = Plane{{0, 1, 0}, 0}});
      spec::Body block{
          .name = "block", .shape = Box{{0.5, 0.1, 0.5}}, .mass = 2.0, .position = Vec3(0, 0.11, 0)};
      block.force = always(Vec3(share * 0.4 * 2 * 9.81, 0, 0));
      builder.add(block);
      Run run(builder);
      run.go(1);
      const double right = std::max(0.0, share - 1) * 0.4 * 9.81;
      CHECK(run.state.v[1].x() == Approx(right).margin(1e-4));
      CHECK(run.halved == 0);
    }
  }
}

TEST_CASE("a press of a thousand weights does not go through: κ knows of forces") {
  for (const double h : {1.0 / 60, 1.0 / 240}) {
    CAPTURE(h);
    SceneBuilder builder("pressed");
    builder.params.h = h;
    builder.add(spec::Body{.name = "ground", .shape = Plane{{0, 1, 0}, 0}});
    builder.add(
        spec::Body{.name = "low", .shape = Box{{0.1, 0.1, 0.1}}, .mass = 1.0, .position = Vec3(0, 0.11, 0)});
    spec::Body high{.name = "high", .shape = Box{{0.1, 0.1, 0.1}}, .mass = 1.0, .position = Vec3(0, 0.32, 0)};
    high.force = Push{{{0, Vec3::Zero()}, {0.5, Vec3(0, -9810, 0)}}};
    builder.add(high);
    Run run(builder);
    run.go(2);
    CHECK(run.report.min_gap > 0.8 * run.scene.params.contact.d_hat);
    CHECK(run.report.kinetic < 1e-9);
  }
}

TEST_CASE("a pendulum that is pushed aside hangs at atan F/m g, and its energy is the work of the force") {
  SceneBuilder builder("pendulum");
  builder.params.h = 1.0 / 240;
  spec::Body bob{.name = "bob", .shape = Sphere{0.05}, .mass = 1.0, .position = Vec3(0, -1, 0)};
  bob.force = always(Vec3(9.81, 0, 0));
  builder.add(bob);
  builder.add(spec::Joint{.j = "bob", .anchor = Vec3::Zero(), .damping = 2.0});
  Run run(builder);
  run.go(15);
  CHECK(run.state.c[0].x() == Approx(std::sqrt(0.5)).epsilon(1e-6));
  SceneBuilder free("pendulum");
  free.params.h = 1.0 / 240;
  free.add(bob);
  free.add(spec::Joint{.j = "bob", .anchor = Vec3::Zero()});
  Run swings(free);
  const double start = swings.energy();
  swings.go(0.5);
  CHECK(swings.energy() - start == Approx(9.81 * swings.state.c[0].x()).epsilon(1e-3));
  CHECK(swings.work == Approx(9.81 * swings.state.c[0].x()).epsilon(1e-6));
  CHECK(swings.halved == 0);
}

TEST_CASE("errors fall with the square of the step where a force on a jointed body changes") {
  const auto end = [](double h) {
    SceneBuilder builder("pendulum");
    builder.params.h = h;
    builder.params.solver.tolerance = 1e-9;
    builder.params.solver.iterations = 100;
    spec::Body rod{.name = "rod", .shape = Box{{0.5, 0.05, 0.05}}, .mass = 2.0, .position = Vec3(0.5, 0, 0)};
    rod.force = Push{{{0, Vec3(0, 0, 0)}, {2, Vec3(30, 60, 0)}}};
    rod.torque = Push{{{0, Vec3(0, 0, 1)}, {2, Vec3(0, 0, -3)}}};
    builder.add(rod);
    builder.add(
        spec::Joint{.type = JointType::hinge, .j = "rod", .anchor = Vec3::Zero(), .axis = Vec3::UnitZ()});
    Run run(builder);
    run.go(1);
    CHECK(run.halved == 0);
    return run.state.c[0];
  };
  const Vec3 exact = end(1.0 / 7680);
  const double coarse = (end(1.0 / 240) - exact).norm(), middle = (end(1.0 / 480) - exact).norm(),
               fine = (end(1.0 / 960) - exact).norm();
  CAPTURE(coarse, middle, fine);
  CHECK(std::log2(coarse / middle) == Approx(2).margin(0.15));
  CHECK(std::log2(middle / fine) == Approx(2).margin(0.15));
}

TEST_CASE("two bodies that hang together are pushed as one, and alike whichever of them is pushed") {
  const double h = 1.0 / 60;
  for (const int pushed : {0, 1}) {
    CAPTURE(pushed);
    SceneBuilder builder = in_space(h);
    for (int k = 0; k < 2; ++k) {
      spec::Body body{.name = std::to_string(k),
                      .shape = Box{{0.2, 0.2, 0.2}},
                      .mass = 1.0 + k,
                      .position = Vec3(k, 0, 0)};
      if (k == pushed) body.force = always(Vec3(6, 0, 0));
      builder.add(body);
    }
    builder.add(spec::Joint{.type = JointType::fixed, .i = "0", .j = "1", .anchor = Vec3(0.5, 0, 0)});
    Run run(builder);
    run.go(1);
    for (int k = 0; k < 2; ++k) CHECK(run.state.v[k].x() == Approx(2).epsilon(1e-3));
    CHECK(run.halved == 0);
  }
}

}  // namespace pabd::test_external
