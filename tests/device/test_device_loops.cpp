// SPDX-License-Identifier: MIT
// A driver that ends the loops of a shader early: what it leaves out is told, not left out.
#include <catch2/catch.hpp>

#include "sim/base/error.h"
#include "sim/body/shape_kind.h"
#include "sim/scene/builder.h"
#include "sim/solver/time_step.h"
#include "tests/device/device_scenes.h"

namespace pabd::test_device_loops {

using namespace testing;

namespace {

// Pairs of sticks that meet at an angle each, at a speed at which they could pass each other: many faces, looked at again
// and again along the way.
Scene sticks(double speed) {
  SceneBuilder builder("sticks");
  builder.params.h = 1.0 / 60;
  builder.params.gravity = Vec3::Zero();
  solve_exactly(builder.params);
  builder.params.contact.mu_static = builder.params.contact.mu_dynamic = 0;
  for (int k = 0; k < 16; ++k) {
    const double half = 0.2 + 0.09 * k, turn = 0.5 * k;
    const Vec3 at(2 * k, 0, 0);
    const auto stick = [&](double y, double v, double angle) {
      const double c = std::sqrt(0.5) * std::cos(angle / 2), s = std::sqrt(0.5) * std::sin(angle / 2);
      builder.add(spec::Body{.name = {},
                             .shape = make_shape("cylinder", {0.02, 0.5}),
                             .density = 1000,
                             .position = at + Vec3(0.03 * k, y, 0.01),
                             .orientation = std::array{c, c, s, -s},
                             .velocity = Vec3(0, v, 0)});
    };
    const double y = 0.02 + 0.5 * speed * builder.params.h;
    stick(-y, speed, half);
    stick(y, -speed, half + turn);
  }
  return builder.build();
}

}  // namespace

TEST_CASE("contacts of bodies with many faces are found by the GPU, or its driver is refused") {
  const double speed = GENERATE(1.0, 30.0, 100.0);
  CAPTURE(speed);
  const Scene scene = sticks(speed);
  State expected = scene.initial;
  StepWorkspace workspace;
  StepReport report;
  step(scene.model, scene.params, {}, expected, workspace, report);
  std::string refused;
  double off = 0;
  try {
    off = pose_difference(run(scene, {.precision = DevicePrecision::twofold}, 1), expected);
  } catch (const Error& error) {
    refused = error.what();
    CHECK(error.kind() == ErrorKind::no_context);
  }
  CHECK(report.contacts == 64);
  CAPTURE(refused, off);
  CHECK((refused.find("ends a shader's loops") != std::string::npos || off < 1e-6));
  CHECK((speed > 30 || refused.empty()));
}

}  // namespace pabd::test_device_loops
