// SPDX-License-Identifier: MIT
// Mechanisms by steps of second order (sim/solver/second_order.h): published values, orders of error, and what acts along
// joints.
#include <catch2/catch.hpp>

#include <functional>

#include "sim/scene/builder.h"
#include "sim/solver/step_summary.h"
#include "sim/solver/time_step.h"

namespace pabd::test_mechanisms {

namespace {

constexpr double kDegrees = 180 / kPi;

SceneBuilder mechanism(const char* name, double h) {
  SceneBuilder builder(name);
  builder.params.h = h;
  builder.params.solver.integrator = Integrator::bdf2;
  builder.params.solver.tolerance = 1e-9;
  builder.params.solver.iterations = 100;
  builder.add(spec::NoCollide{spec::Group{"links"}, spec::Group{"links"}});
  return builder;
}

// Makes steps; `each` sees every end.
State run(const Scene& scene, double seconds,
          const std::function<void(const State&, const StepReport&)>& each) {
  State state = scene.initial;
  StepWorkspace workspace;
  StepReport report;
  for (int k = 0; k < std::lround(seconds / scene.params.h); ++k) {
    step(scene.model, scene.params, {}, state, workspace, report);
    REQUIRE(report.status == StepStatus::converged);
    each(state, report);
  }
  return state;
}
State after(const Scene& scene, double seconds) {
  return run(scene, seconds,
             [](const State&, const StepReport& report) { REQUIRE(report.halved_bodies == 0); });
}

// The largest error within a second falls with the square of the step. (That at one time may go through 0.)
void check_order(const std::function<Scene(double)>& scene) {
  constexpr int kRate = 240;
  const auto way = [&](int rate) {
    std::vector<Pose> out;
    run(scene(1.0 / rate), 1, [&](const State& state, const StepReport& report) {
      REQUIRE(report.halved_bodies == 0);
      if (state.step % (rate / 20) == 0) out.push_back({state.c.back(), state.R.back()});
    });
    return out;
  };
  const std::vector<Pose> exact = way(16 * kRate);
  const auto error = [&](int rate) {
    const std::vector<Pose> found = way(rate);
    double largest = 0;
    for (std::size_t k = 0; k < exact.size(); ++k)
      largest = std::max(largest, (found[k].c - exact[k].c).norm() + (found[k].R - exact[k].R).norm());
    return largest;
  };
  const double coarse = error(kRate), middle = error(2 * kRate), fine = error(4 * kRate);
  CAPTURE(coarse, middle, fine);
  CHECK(std::log2(coarse / middle) == Approx(2).margin(0.15));
  CHECK(std::log2(middle / fine) == Approx(2).margin(0.15));
}

// A rod of 1 m that hangs by its end beside the origin, let go from the horizontal; `joint` says what acts.
Scene rod(double h, spec::Joint joint) {
  SceneBuilder builder = mechanism("rod", h);
  builder.add(spec::Body{.name = "rod",
                         .shape = Box{{0.5, 0.05, 0.05}},
                         .mass = 2,
                         .position = Vec3(0.5, 0, 0),
                         .groups = {"links"}});
  joint.type = JointType::hinge;
  joint.j = "rod";
  joint.anchor = Vec3::Zero();
  joint.axis = Vec3::UnitZ();
  builder.add(joint);
  return builder.build();
}

}  // namespace

TEST_CASE("errors fall with the square of the step where dampers, springs and motors act") {
  const auto check = [](const char* what, const spec::Joint& joint) {
    CAPTURE(what);
    check_order([&](double h) { return rod(h, joint); });
  };
  check("damper", {.damping = 3.0});
  check("spring and damper", {.damping = 1.0, .spring = spec::Spring{.stiffness = 200.0}});
  check("torque", {.motor = spec::Motor{.force = Profile{{{0, 2.0}}}}});
  check("torque that grows", {.motor = spec::Motor{.force = Profile{{{0, 0.0}, {10, 100.0}}}}});
  check("speed with a gain", {.motor = spec::Motor{.speed = Profile{{{0, 360.0}}}, .gain = 5.0}});
}

TEST_CASE("a damper on a ball turns a top down to second order") {
  check_order([](double h) {
    SceneBuilder builder = mechanism("ball", h);
    builder.add(spec::Body{.name = "top",
                           .shape = Box{{0.1, 0.05, 0.2}},
                           .mass = 1,
                           .position = Vec3(0.3, 0, 0),
                           .angular_velocity = kDegrees * Vec3(3, 2, 5),
                           .groups = {"links"}});
    builder.add(spec::Joint{.j = "top", .anchor = Vec3::Zero(), .damping = 0.2});
    return builder.build();
  });
}

TEST_CASE("dampers of any strength end with less energy, and never with more than there was") {
  for (const double c : {1e-3, 1.0, 1e3, 1e6}) {
    for (const double rate : {60.0, 240.0}) {
      CAPTURE(c, rate);
      const Scene scene = rod(1 / rate, {.damping = c});
      double most = 0, last = 0;
      const double start = potential_energy(scene.model, scene.params, scene.initial);
      run(scene, 3, [&](const State&, const StepReport& report) {
        last = report.kinetic + report.potential + report.elastic - start;
        most = std::max(most, last);
      });
      CHECK(most < 1e-3);  // of 9.81 J
      CHECK(last < 0);
    }
  }
}

TEST_CASE("what hangs from a driven slide swings to second order") {
  check_order([](double h) {
    SceneBuilder builder = mechanism("crane", h);
    builder.add(spec::Body{.name = "trolley", .shape = Box{{0.1, 0.1, 0.1}}, .mass = 1, .groups = {"links"}});
    builder.add(spec::Body{
        .name = "load", .shape = Sphere{0.1}, .mass = 3, .position = Vec3(0, -1, 0), .groups = {"links"}});
    builder.add(spec::Joint{.type = JointType::slider,
                            .j = "trolley",
                            .anchor = Vec3::Zero(),
                            .axis = Vec3::UnitX(),
                            .drive = Profile{{{0, 0.0}, {10, 20.0}}}});
    builder.add(spec::Joint{.type = JointType::hinge,
                            .i = "trolley",
                            .j = "load",
                            .anchor = Vec3::Zero(),
                            .axis = Vec3::UnitZ()});
    return builder.build();
  });
}

TEST_CASE("a drive is told to have put in what is found as energy") {
  const double h = GENERATE(1.0 / 60, 1.0 / 240);
  SceneBuilder builder("driven rod");
  builder.params.solver.integrator = GENERATE(Integrator::euler, Integrator::bdf2);
  builder.params.h = h;
  builder.add(
      spec::Body{.name = "rod", .shape = Box{{0.5, 0.05, 0.05}}, .mass = 4, .position = Vec3(0.5, 0, 0)});
  builder.add(spec::Joint{.type = JointType::hinge,
                          .j = "rod",
                          .anchor = Vec3::Zero(),
                          .axis = Vec3::UnitZ(),
                          .drive = Profile{{{0, 0.0}, {10, 1200.0}}}});
  double work = 0, first = 0, most = 0;
  run(builder.build(), 2, [&](const State& state, const StepReport& report) {
    const double energy = report.kinetic + report.potential;
    if (state.step == 1) first = energy;
    if (state.step > 1) work += report.drive_work;
    most = std::max(most, std::abs(energy - first - work));
  });
  CAPTURE(h, first, work);
  CHECK(most < 0.02 * 4 * 9.81 * 0.5);
}

TEST_CASE("a rod that swings against the limit of its hinge gains nothing, at any step") {
  for (const double rate : {60.0, 120.0, 240.0, 1000.0}) {
    for (const double end : {-35.0, -80.0, -130.0}) {
      CAPTURE(rate, end);
      const Scene scene = rod(1 / rate, {.limits = spec::Limits{end, 10.0}});
      double most = 0, lowest = 0;
      const double start = potential_energy(scene.model, scene.params, scene.initial);
      run(scene, 4, [&](const State& state, const StepReport& report) {
        most = std::max(most, report.kinetic + report.potential + report.elastic - start);
        lowest = std::min(lowest, std::atan2(state.R[0](1, 0), state.R[0](0, 0)) * kDegrees);
      });
      CHECK(most < 1e-2);  // of 9.81 J
      CHECK(lowest < end);
      CHECK(lowest > end - 3);
    }
  }
}

TEST_CASE("a rod swings free within the limits of its hinge by second order") {
  const Scene limited = rod(1.0 / 60, {.limits = spec::Limits{-179.0, 10.0}}), free = rod(1.0 / 60, {});
  CHECK((after(limited, 0.5).c[0] - after(free, 0.5).c[0]).norm() == 0);
}

}  // namespace pabd::test_mechanisms
