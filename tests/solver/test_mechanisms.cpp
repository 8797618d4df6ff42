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

// Andrews' squeezing mechanism: seven plane bodies, a spring and a torque (Hairer and Wanner, Solving Ordinary Differential
// Equations II, VII.7; test set for initial value problems, Bari). Names of lengths are those of the book.
Scene andrews(double h) {
  constexpr double beta = -0.0617138900142764496, Theta = 0, gamma = 0.455279819163070380,
                   Phi = 0.222668390165885885, delta = 0.487364979543842550, Omega = -0.222668390165885885,
                   epsilon = 1.23054744454982119;
  constexpr double d = 0.028, da = 0.0115, e = 0.02, ea = 0.01421, rr = 0.007, ra = 0.00092, sa = 0.01874,
                   sb = 0.01043, sc = 0.018, sd = 0.02, ta = 0.02308, tb = 0.00916, u = 0.04, ua = 0.01228,
                   ub = 0.00449, zf = 0.02, zt = 0.04, fa = 0.01421;
  const Vec3 A(-0.06934, -0.00227, 0), B(-0.03635, 0.03273, 0), C(0.014, 0.072, 0);
  const auto along = [](double angle, double x, double y = 0) {
    return Vec3(x * std::cos(angle) - y * std::sin(angle), x * std::sin(angle) + y * std::cos(angle), 0);
  };
  const Vec3 P = along(beta, rr), E = P - along(beta + Theta, d);

  SceneBuilder builder = mechanism("andrews", h);
  builder.params.gravity.setZero();
  const auto body = [&](const char* name, double mass, double inertia, const Vec3& c) {
    const double half = std::sqrt(1.5 * inertia / mass);  // of a square with that moment
    builder.add(spec::Body{
        .name = name, .shape = Box{{half, half, 0.001}}, .mass = mass, .position = c, .groups = {"links"}});
  };
  body("K1", 0.04325, 2.194e-6, along(beta, ra));
  body("K2", 0.00365, 4.410e-7, P - along(beta + Theta, da));
  body("K3", 0.02373, 5.255e-6, B + along(gamma, sb, -sa));
  body("K4", 0.00706, 5.667e-7, A + along(delta, zt) + along(Phi + delta, 0, -(e - ea)));
  body("K5", 0.07050, 1.169e-5, A + along(delta, ta, tb));
  body("K6", 0.00706, 5.667e-7, A + along(epsilon, 0, -u) + along(Omega + epsilon, zf - fa));
  body("K7", 0.05498, 1.912e-5, A + along(epsilon, -ub, -ua));
  const auto pin = [&](const char* i, const char* j, const Vec3& at) {
    builder.add(spec::Joint{
        .type = JointType::hinge, .i = i, .j = j, .anchor = at, .axis = Vec3::UnitZ(), .arm = 0.01});
  };
  builder.add(spec::Joint{.type = JointType::hinge,
                          .j = "K1",
                          .anchor = Vec3::Zero(),
                          .axis = Vec3::UnitZ(),
                          .arm = 0.01,
                          .motor = spec::Motor{.force = Profile{{{0, 0.033}}}}});
  pin("K1", "K2", P);
  pin("K2", "K3", E);
  pin("K2", "K4", E);
  pin("K2", "K6", E);
  pin("", "K3", B);
  pin("K4", "K5", A + along(delta, zt));
  pin("", "K5", A);
  pin("K6", "K7", A + along(epsilon, 0, -u));
  pin("", "K7", A);
  builder.add(spec::Joint{.type = JointType::distance,
                          .j = "K3",
                          .points = {C, B + along(gamma, sd, -sc)},
                          .length = 0.07785,
                          .law = {.potential = BondPotential::soft, .kappa = 4530}});
  return builder.build();
}

// The angle of K1 at 0.03 s, whole turns and all; rad.
double crank_of_andrews(double h) {
  double beta = -0.0617138900142764496, from = 0;
  run(andrews(h), 0.03, [&](const State& state, const StepReport&) {
    const double turned = std::atan2(state.R[0](1, 0), state.R[0](0, 0));
    beta += std::remainder(turned - from, 2 * kPi);
    from = turned;
  });
  return beta;
}

}  // namespace

TEST_CASE("Andrews' squeezing mechanism turns its crank as published, to second order") {
  constexpr double published = 15.81077;
  const double coarse = crank_of_andrews(1e-5) - published, fine = crank_of_andrews(5e-6) - published;
  CAPTURE(coarse, fine);
  CHECK(std::abs(coarse) < 5e-4);
  CHECK(coarse / fine == Approx(4).margin(0.6));
}

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
