// SPDX-License-Identifier: MIT
// Sweeps on the GPU: threads share bodies, bodies of one color are solved at the same time.
#include <catch2/catch.hpp>

#include "render/device/device_solver.h"
#include "sim/scene/builder.h"
#include "sim/solver/time_step.h"
#include "tests/device/device_scenes.h"

namespace pabd::test_device_sweeps {

using namespace testing;

TEST_CASE("however many threads share a body on the GPU, a step is the same but for rounding") {
  Scene scene = mixed_heap(2);
  scene.params.solver.iterations = 20;
  DeviceOptions options;
  options.precision = DevicePrecision::twofold;
  options.team = 1;
  const double rounding = keeps_doubles(*any_context()) ? 1e-12 : 1e-6;  // m
  scene.initial = run(scene, options, 40);                               // they touch
  const State alone = run(scene, options, 1);
  for (const int team : {4, 16}) {
    CAPTURE(team);
    options.team = team;
    const State together = run(scene, options, 1);
    CHECK(pose_difference(alone, together) < rounding);
  }
  options.team = 1;
  struct Shares {
    int few, crowd, repeated;
  };
  for (const Shares shares : {Shares{1, 1, 1}, {2, 2, 1}, {3, 3, 1}, {1, 64, 1}, {2, 3, 2}, {64, 64, 0}}) {
    CAPTURE(shares.few, shares.crowd);
    options.few = shares.few;
    options.crowd = shares.crowd;
    int repeated = 0;
    const State together = run(scene, options, 1, &repeated);
    // A time for each share that nobody knew there were bodies for; two at once where threads run side by side.
    CHECK(repeated <= shares.repeated);
    CHECK((repeated > 0) == (shares.repeated > 0));
    CHECK(pose_difference(alone, together) < rounding);
  }
  options.few = options.crowd = 0;
  // Sums are made in another order.
  options.precision = DevicePrecision::single;
  options.team = 1;
  const State one = run(scene, options, 20);
  options.team = 4;
  CHECK(!same_bits(one, run(scene, options, 20)));
}

TEST_CASE("bodies of one color on the GPU share no contact") {
  const Scene scene = mixed_heap(6);
  const auto context = any_context();
  DeviceOptions options;
  options.report_contacts = true;
  DeviceSolver device(*context, scene.model, scene.initial, options);
  std::vector<ContactReport> contacts;
  std::vector<int> colors;
  std::size_t between = 0;
  for (int k = 0; k < 60; ++k) {
    device.step(scene.params);
    device.read_contacts(contacts);
    device.read_colors(colors);
    for (const ContactReport& c : contacts) {
      const auto a = static_cast<std::size_t>(c.a), b = static_cast<std::size_t>(c.b);
      if (scene.model.fixed[a] || scene.model.fixed[b]) continue;
      ++between;
      REQUIRE(colors[a] >= 0);
      REQUIRE(colors[a] != colors[b]);
    }
  }
  CHECK(between > 50);
}

// One driver summed up the inertia of a turned body wrongly: no trial step was taken then.
TEST_CASE("a box that tumbles on the GPU in float takes the steps of the processor") {
  SceneBuilder builder("box");
  builder.params.h = 1.0 / 720;
  builder.add(spec::Body{.name = "ground", .shape = Plane{{0, 1, 0}, 0}});
  builder.add(spec::Pile{.shape = "box", .size = Vec3(0.5, 0.4, 0.3), .position = Vec3(0, 0.1, 0)});
  const Scene scene = builder.build();
  const auto context = any_context();
  DeviceSolver device(*context, scene.model, scene.initial);
  State state = scene.initial, there;
  StepWorkspace workspace;
  StepReport report;
  int touched = 0;
  for (int k = 0; k < 360; ++k) {
    CAPTURE(k);
    device.set_state(state);
    const StepSummary made = device.step(scene.params);
    device.read_state(there);
    step(scene.model, scene.params, {}, state, workspace, report);
    touched += report.contacts > 0 ? 1 : 0;
    CHECK(made.status == StepStatus::converged);
    CHECK(made.halvings == report.halvings);
    CHECK(pose_difference(there, state) < 1e-6);
  }
  CHECK(touched > 30);
}

}  // namespace pabd::test_device_sweeps
