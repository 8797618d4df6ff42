// SPDX-License-Identifier: MIT
// BDF2 about free flight (sim/solver/second_order.h): orders of error, what is kept, and where Euler goes on.
#include <catch2/catch.hpp>

#include <functional>

#include "sim/body/mass_properties.h"
#include "sim/scene/builder.h"
#include "sim/solver/step_summary.h"
#include "sim/solver/time_step.h"
#include "sim/trace/trace.h"

namespace pabd::test_second_order {

namespace {

Scene on_a_pin(double h, Integrator integrator, int links = 1) {
  SceneBuilder builder("swings");
  builder.params.h = h;
  builder.params.solver.integrator = integrator;
  builder.params.solver.tolerance = 1e-9;
  builder.params.solver.iterations = 100;
  for (int k = 0; k < links; ++k)
    builder.add(spec::Body{
        .name = "b" + std::to_string(k), .shape = Sphere{0.05}, .mass = 1, .position = Vec3(k + 1, 0, 0)});
  for (int k = 0; k < links; ++k)
    builder.add(spec::Joint{.type = JointType::hinge,
                            .i = k == 0 ? "" : "b" + std::to_string(k - 1),
                            .j = "b" + std::to_string(k),
                            .anchor = Vec3(k, 0, 0),
                            .axis = Vec3::UnitZ()});
  return builder.build();
}

double energy(const Scene& scene, const State& state) {
  return kinetic_energy(scene.model, state) + potential_energy(scene.model, scene.params, state);
}

State after(const Scene& scene, double seconds) {
  State state = scene.initial;
  StepWorkspace workspace;
  StepReport report;
  for (int k = 0; k < std::lround(seconds / scene.params.h); ++k) {
    step(scene.model, scene.params, {}, state, workspace, report);
    REQUIRE(report.status == StepStatus::converged);
    REQUIRE(report.halved_bodies == 0);
  }
  return state;
}

}  // namespace

TEST_CASE("a pendulum keeps its energy by bdf2 where Euler loses most of it") {
  struct Row {
    int rate;
    double euler, bdf2;  // of 9.81 J, lost in 10 s
  };
  for (const Row& row : {Row{60, 8.79, 0.19}, {240, 5.01, 0.007}, {1000, 1.71, 0.000325}}) {
    CAPTURE(row.rate);
    for (const auto integrator : {Integrator::euler, Integrator::bdf2}) {
      const Scene scene = on_a_pin(1.0 / row.rate, integrator);
      const double lost = energy(scene, scene.initial) - energy(scene, after(scene, 10));
      CHECK(lost == Approx(integrator == Integrator::euler ? row.euler : row.bdf2).epsilon(0.1));
    }
  }
}

// A heavy top on a ball joint, leaning by 40°, which spins, precesses and nods.
Scene top(double h, double rate = 30) {
  SceneBuilder builder("top");
  builder.params.h = h;
  builder.params.solver.integrator = Integrator::bdf2;
  builder.params.solver.tolerance = 1e-9;
  builder.params.solver.iterations = 100;
  const Vec3 up(std::sin(0.7), std::cos(0.7), 0);
  const double half = 0.5 * -0.7;
  builder.add(spec::Body{.name = "top",
                         .shape = Box{{0.1, 0.05, 0.1}},
                         .mass = 1,
                         .position = 0.2 * up,
                         .orientation = std::array{std::cos(half), 0.0, 0.0, std::sin(half)},
                         .angular_velocity = rate * 180 / kPi * up});
  builder.add(spec::Joint{.j = "top", .anchor = Vec3::Zero()});
  return builder.build();
}

TEST_CASE("errors of bdf2 fall with the square of the step: a double pendulum and a heavy top") {
  const auto pendulum = [](double h) { return on_a_pin(h, Integrator::bdf2, 2); };
  for (const auto& scene : {std::function<Scene(double)>(pendulum),
                            std::function<Scene(double)>([](double h) { return top(h); })}) {
    const State exact = after(scene(1.0 / 30720), 1);
    const auto error = [&](int rate) {
      const State end = after(scene(1.0 / rate), 1);
      return (end.c.back() - exact.c.back()).norm() + (end.R.back() - exact.R.back()).norm();
    };
    const double coarse = error(480), middle = error(960), fine = error(1920);
    CAPTURE(exact.size(), coarse, middle, fine);
    CHECK(std::log2(coarse / middle) == Approx(2).margin(0.1));
    CHECK(std::log2(middle / fine) == Approx(2).margin(0.1));
  }
}

TEST_CASE("a top that turns by radians in a step of bdf2 makes no energy") {
  for (const double rate : {35.0, 70.0, 140.0, 280.0}) {
    for (const double h : {1.0 / 60, 1.0 / 240}) {
      CAPTURE(rate, h);
      const Scene scene = top(h, rate);
      State state = scene.initial;
      StepWorkspace workspace;
      StepReport report;
      const double start = energy(scene, state), spins = kinetic_energy(scene.model, state);
      double most = start;
      for (int k = 0; k < 600; ++k) {
        step(scene.model, scene.params, {}, state, workspace, report);
        most = std::max(most, energy(scene, state));
      }
      CHECK(most < start + 2e-3 * spins);
    }
  }
}

// The hinge takes out at once what turns the bar across its axis; what is remembered of that must fall.
TEST_CASE(
    "a bar that a hinge drives does not wobble by bdf2, however slender or flat it is and far it turns in a "
    "step") {
  // Greatest by least moment of inertia: 2, 79 and 1250 across the bar, 2 of a disc about its axis, a bar about its own.
  for (const Vec3& size : {Vec3(0.07, 0.04, 0.04), Vec3(0.5, 0.04, 0.04), Vec3(2, 0.04, 0.04),
                           Vec3(0.3, 0.3, 0.02), Vec3(0.04, 0.04, 0.5)}) {
    for (const double turn : {0.1, 0.2, 0.39, 0.7, 1.0}) {
      CAPTURE(size.transpose(), turn);
      const double h = 1.0 / 60;
      SceneBuilder builder("bar");
      builder.params.h = h;
      builder.params.solver.integrator = Integrator::bdf2;
      builder.params.solver.tolerance = 1e-9;
      builder.params.solver.iterations = 100;
      builder.params.solver.halvings = 0;
      builder.add(spec::Body{
          .name = "bar", .shape = Box{size / 2}, .angular_velocity = Vec3(1e-3, 1e-3, turn / h) / kDegree});
      builder.add(spec::Joint{.type = JointType::hinge,
                              .j = "bar",
                              .anchor = Vec3::Zero(),
                              .axis = Vec3::UnitZ(),
                              .drive = Profile{{{0, 0}, {100, 100 * turn / h / kDegree}}}});
      const State end = after(builder.build(), 1);
      CHECK(end.omega[0].head<2>().norm() < 1e-5);
      CHECK(end.omega[0].z() == Approx(turn / h).epsilon(1e-5));
    }
  }
}

TEST_CASE("what flies freely by bdf2 flies along a parabola, and turns as by Euler") {
  SceneBuilder builder("thrown");
  builder.params.h = 1.0 / 60;
  builder.add(spec::Body{.name = "brick",
                         .shape = Box{{0.3, 0.2, 0.1}},
                         .position = Vec3(1, 2, 3),
                         .velocity = Vec3(3, 4, -1),
                         .angular_velocity = Vec3(100, 200, 300)});
  Scene scene = builder.build();
  scene.params.solver.integrator = Integrator::euler;
  const State euler = after(scene, 2);
  scene.params.solver.integrator = Integrator::bdf2;
  const State end = after(scene, 2);
  const Vec3& g = scene.params.gravity;
  const double h = scene.params.h;
  const Vec3 parabola = Vec3(1, 2, 3) + 2 * Vec3(3, 4, -1) + 2 * g;
  CHECK((end.c[0] - parabola).norm() < 1e-12);
  CHECK((euler.c[0] - parabola).norm() > 50 * h * h * g.norm());
  CHECK((end.v[0] - Vec3(3, 4, -1) - 2 * g).norm() < 1e-12);
  CHECK((end.R[0] - euler.R[0]).norm() < 1e-12);
  CHECK((end.omega[0] - euler.omega[0]).norm() < 1e-10);
}

TEST_CASE("what flies within reach of a mechanism, and does not touch it, flies along its parabola") {
  for (const int rate : {30, 60, 240}) {
    for (const double gap : {0.02, 0.05, 0.2}) {
      CAPTURE(rate, gap);
      const double h = 1.0 / rate;
      Scene scene = [&] {
        SceneBuilder builder("swings beside");
        builder.params.h = h;
        builder.add(spec::Body{.name = "bob", .shape = Sphere{0.05}, .mass = 1, .position = Vec3(1, 0, 0)});
        builder.add(
            spec::Joint{.type = JointType::hinge, .j = "bob", .anchor = Vec3::Zero(), .axis = Vec3::UnitZ()});
        builder.add(spec::Body{.name = "ball",
                               .shape = Sphere{0.05},
                               .position = Vec3(1, 0, 0.1 + gap),
                               .velocity = Vec3(0, 0, 2 * gap)});
        return builder.build();
      }();
      const State end = after(scene, 10 * h);
      const double t = 10 * h;
      const Vec3 parabola = Vec3(1, 0, 0.1 + gap + 2 * gap * t) + 0.5 * t * t * scene.params.gravity;
      CHECK((end.c[1] - parabola).norm() < 1e-12);
    }
  }
}

TEST_CASE("a chain in free flight keeps its momentum by bdf2 to rounding, and its energy to second order") {
  const auto lost = [](double h) {
    SceneBuilder builder("chain");
    builder.params.h = h;
    builder.params.gravity = Vec3(0, 0, -1);
    builder.params.solver.integrator = Integrator::bdf2;
    builder.params.solver.tolerance = 1e-9;
    builder.params.solver.iterations = 100;
    for (int k = 0; k < 4; ++k) {
      const std::string name = "b" + std::to_string(k);
      builder.add(spec::Body{.name = name,
                             .shape = Box{{0.4, 0.1, 0.2}},
                             .position = Vec3(k, 0, 0),
                             .velocity = Vec3(0, 2.0 * (k % 2), 0.5 * k)});
      if (k > 0)
        builder.add(spec::Joint{.i = "b" + std::to_string(k - 1), .j = name, .anchor = Vec3(k - 0.5, 0, 0)});
    }
    const Scene scene = builder.build();
    const auto momentum = [&](const State& state, Vec3& L) {
      Vec3 P = Vec3::Zero(), centre = Vec3::Zero();
      double mass = 0;
      L.setZero();
      for (std::size_t i = 0; i < state.c.size(); ++i) {
        mass += scene.model.mass[i];
        centre += scene.model.mass[i] * state.c[i];
      }
      centre /= mass;
      for (std::size_t i = 0; i < state.c.size(); ++i) {
        const Vec3 p = scene.model.mass[i] * state.v[i];
        P += p;
        L += (state.c[i] - centre).cross(p) +
             state.R[i] * (inertia_tensor(scene.model.J[i]) * (state.R[i].transpose() * state.omega[i]));
      }
      return P;
    };
    const State first = after(scene, h), end = after(scene, 1);  // the joints take up the start at once
    Vec3 L_first, L_end;
    const Vec3 P_first = momentum(first, L_first), P_end = momentum(end, L_end);
    double mass = 0;
    for (const double m : scene.model.mass) mass += m;
    const Vec3 fallen = mass * (1 - h) * scene.params.gravity;
    CHECK((P_end - P_first - fallen).norm() < 1e-11 * P_end.norm());
    CHECK((L_end - L_first).norm() < 1e-11 * L_first.norm());
    return energy(scene, first) - energy(scene, end);
  };
  const double coarse = lost(1.0 / 240), fine = lost(1.0 / 960);
  CAPTURE(coarse, fine);
  CHECK(std::abs(coarse) > 8 * std::abs(fine));
}

TEST_CASE("bdf2 steps by Euler where something touches: no hit is seen through the memory") {
  for (const double h : {1.0 / 60, 1.0 / 240}) {
    CAPTURE(h);
    SceneBuilder builder("dropped");
    builder.params.h = h;
    builder.params.solver.integrator = Integrator::bdf2;
    builder.add(spec::Body{.name = "ground", .shape = Plane{{0, 1, 0}, 0}});
    builder.add(spec::Body{.name = "ball", .shape = Sphere{0.2}, .position = Vec3(0, 1.5, 0)});
    builder.add(spec::Body{
        .name = "box", .shape = Box{{0.2, 0.2, 0.2}}, .position = Vec3(2, 1, 0), .velocity = Vec3(1, 0, 0)});
    const Scene scene = builder.build();
    State state = scene.initial;
    StepWorkspace workspace;
    StepReport report;
    double last = energy(scene, state), rise = 0;
    for (int k = 0; k < std::lround(3 / h); ++k) {
      step(scene.model, scene.params, {}, state, workspace, report);
      const double now = energy(scene, state) + report.elastic;
      rise = std::max(rise, now - last);
      last = now;
      CHECK(state.change.empty());
    }
    CHECK(rise < 1e-9 * energy(scene, scene.initial));
    CHECK(kinetic_energy(scene.model, state) < 1e-3);
  }
}

TEST_CASE(
    "a state file takes along what bdf2 remembers: the run goes on with the same bits, with any threads") {
  const Scene scene = on_a_pin(1.0 / 120, Integrator::bdf2, 3);
  const State half = after(scene, 0.5), whole = after(scene, 1);
  State read = state_from_json(scene.model, state_to_json(scene.model, half), "half");
  CHECK(same_bits(read, half));
  StepWorkspace workspace;
  StepReport report;
  StepOptions threads;
  threads.threads = 4;
  for (int k = 0; k < 60; ++k) step(scene.model, scene.params, threads, read, workspace, report);
  CHECK(same_bits(read, whole));
  State forgotten = half;
  forgotten.change.clear();
  for (int k = 0; k < 60; ++k) step(scene.model, scene.params, {}, forgotten, workspace, report);
  CHECK_FALSE(same_bits(forgotten, whole));
  // Another step size, or a joint that is cut, begins anew.
  Params other = scene.params;
  other.h /= 2;
  State changed = half, anew = half;
  anew.change.clear();
  step(scene.model, other, {}, changed, workspace, report);
  step(scene.model, other, {}, anew, workspace, report);
  changed.change.clear();  // it still knows what it gained in all
  anew.change.clear();
  CHECK(same_bits(changed, anew));
}

}  // namespace pabd::test_second_order
