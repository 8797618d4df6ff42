// SPDX-License-Identifier: MIT
// Pairs that are looked at on their way, in rounds: fast bodies on the GPU (sim/collision/passage.h).
#include <catch2/catch.hpp>

#include "render/device/device_solver.h"
#include "sim/scene/builder.h"
#include "sim/solver/time_step.h"
#include "tests/device/device_scenes.h"

namespace pabd::test_device_passage {

using namespace testing;

// Each flies two metres a step, towards a board of its own, four centimetres thick.
TEST_CASE("fast bodies on the GPU stop at thin boards where the processor stops them") {
  const Shape shapes[] = {Box{{0.1, 0.15, 0.2}}, Sphere{0.1}, Capsule{0.1, 0.3}};
  SceneBuilder builder("boards");
  builder.params.gravity = Vec3::Zero();
  solve_exactly(builder.params);
  for (int k = 0; k < 12; ++k) {
    const Vec3 middle(0, 0, 5 * k);
    builder.add(spec::Body{.name = {}, .shape = Box{{0.02, 1, 1}}, .fixed = true, .position = middle});
    builder.add(spec::Body{.name = {},
                           .shape = shapes[k % 3],
                           .position = middle - Vec3(0.5 + 0.1 * k, 0.02 * k, 0),
                           .velocity = Vec3(120, 0, 0)});
  }
  const Scene scene = builder.build();
  DeviceOptions options;
  options.precision = DevicePrecision::twofold;
  State state = scene.initial;
  StepWorkspace workspace;
  StepReport report;
  step(scene.model, scene.params, {}, state, workspace, report);
  const State there = run(scene, options, 1);
  CHECK(pose_difference(there, state) < (keeps_doubles(*any_context()) ? 1e-6 : 1e-4));
  for (std::size_t k = 1; k < there.c.size(); k += 2) {
    CAPTURE(k);
    CHECK(there.c[k].x() < 0);
    CHECK(there.c[k].x() > -0.5);  // it came there
  }
}

}  // namespace pabd::test_device_passage
