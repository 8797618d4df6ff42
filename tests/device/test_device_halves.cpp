// SPDX-License-Identifier: MIT
// Steps on the GPU that end unsolved are made again in halves (sim/solver/halving.h).
#include <catch2/catch.hpp>

#include "sim/scene/builder.h"
#include "sim/solver/halving.h"
#include "sim/solver/step_summary.h"
#include "tests/device/device_scenes.h"

namespace pabd::test_device_halves {

using namespace testing;

namespace {

constexpr int kPlanks = 8;

// Planks that fall on each other crosswise, faster the higher they are, with too few iterations for that.
Scene falling_planks() {
  SceneBuilder builder("planks");
  builder.params.solver.iterations = 8;
  builder.add(spec::Body{.name = "ground", .shape = Plane{{0, 1, 0}, 0}});
  for (int k = 0; k < kPlanks; ++k) {
    const double turn = 0.25 * kPi * (k % 2) + 0.05 * k;
    builder.add(spec::Body{.name = {},
                           .shape = Box{{0.6, 0.03, 0.1}},
                           .density = 600,
                           .position = Vec3(0.05 * k, 0.3 + 0.12 * k, 0),
                           .orientation = std::array{std::cos(turn), 0.0, std::sin(turn), 0.02},
                           .velocity = Vec3(0, -0.6 * k, 0)});
  }
  return builder.build();
}

}  // namespace

TEST_CASE("a step on the GPU that ends unsolved is that of its two halves, to the bit") {
  Scene scene = falling_planks();
  scene.params.solver.halvings = 1;
  DeviceOptions options;
  options.keep_contacts = false;  // a state that is set has none
  // A solver binds its buffers in its context: one each.
  const auto context = any_context(), other = any_context();
  DeviceSolver stepping(*other, scene.model, scene.initial, options);
  context->make_current();
  DeviceSolver halving(*context, scene.model, scene.initial, options);
  Params whole = scene.params;
  whole.solver.halvings = 0;
  State before = scene.initial, expected, found;
  int halved = 0;
  for (int k = 0; k < 20; ++k) {
    CAPTURE(k);
    context->make_current();
    halving.set_state(before);
    const StepSummary made = halving.step(scene.params);
    halving.read_state(found);
    other->make_current();
    stepping.set_state(before);
    StepSummary told = stepping.step(whole);  // colors of bodies are those of the steps before
    if (made.halvings > 0) {
      ++halved;
      CHECK(made.halved_bodies == kPlanks);
      const Params half = of_half(scene.params, made.kappa);
      stepping.set_state(before);
      const StepSummary first = stepping.step(half);
      told = both(first, stepping.step(half));
    } else {
      CHECK(made.halved_bodies == 0);
    }
    stepping.read_state(expected);
    CHECK(made.status == told.status);
    CHECK(made.iterations == told.iterations);
    CHECK(made.kinetic == told.kinetic);
    CHECK(found.step == before.step + 1);
    CHECK(found.time == Approx(before.time + scene.params.h));
    expected.step = found.step;
    expected.time = found.time;
    CHECK(same_bits(found, expected));
    before = found;
  }
  CHECK(halved > 2);
  CHECK(halved < 20);
  context->make_current();
}

TEST_CASE("halves on the GPU have the same bits however many steps are under way") {
  Scene scene = falling_planks();
  DeviceOptions options;
  const State at_once = run(scene, options, 20);
  const auto context = any_context();
  DeviceSolver solver(*context, scene.model, scene.initial, options);
  int halvings = 0;
  for (int k = 0; k < 20; ++k) halvings = std::max(halvings, solver.step(scene.params).halvings);
  State one_by_one;
  solver.read_state(one_by_one);
  CHECK(halvings > 1);
  CHECK(same_bits(at_once, one_by_one));
}

TEST_CASE(
    "planks that fall in a heap on the GPU are pressed through each other, and not where steps are made in "
    "halves") {
  double without_halves = 0;
  for (const int seed : {1, 2, 3, 4}) {
    SceneBuilder builder("planks");
    builder.add(spec::Body{.name = "ground", .shape = Plane{{0, 1, 0}, 0}});
    builder.add(spec::Pile{
        .count = 40, .shape = "box", .size = Vec3(1, 0.1, 0.1), .position = Vec3(0, 0.1, 0), .seed = seed});
    Scene scene = builder.build();
    const double start = potential_energy(scene.model, scene.params, scene.initial);
    const auto context = any_context();
    double deepest[2] = {0, 0}, rise = 0;
    for (const int halvings : {0, 4}) {
      scene.params.solver.halvings = halvings;
      DeviceSolver solver(*context, scene.model, scene.initial, {});
      double last = start;
      for (int k = 0; k < 72; ++k) {
        const StepSummary& made = solver.step(scene.params);
        const double energy = made.kinetic + made.potential + made.elastic;
        deepest[halvings / 4] = std::min(deepest[halvings / 4], made.min_gap);
        if (halvings > 0) rise = std::max(rise, energy - last);
        last = energy;
      }
    }
    CAPTURE(seed);
    CHECK(deepest[1] > -0.005);
    CHECK(rise < 0.01 * start);
    without_halves = std::min(without_halves, deepest[0]);
  }
  CHECK(without_halves < -0.05);
}

}  // namespace pabd::test_device_halves
