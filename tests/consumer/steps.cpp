// SPDX-License-Identifier: MIT
// The simulation alone, compiled with what pkg-config says: a ball falls for a second.
#include <cstdio>

#include "sim/scene/builder.h"
#include "sim/solver/time_step.h"

int main() {
  pabd::SceneBuilder builder("steps");
  builder.add(pabd::spec::Body{.shape = pabd::Sphere{0.5}, .position = pabd::Vec3(0, 100, 0)});
  const pabd::Scene scene = builder.build();
  pabd::State state = scene.initial;
  pabd::StepWorkspace workspace;
  pabd::StepReport report;
  for (int k = 0; k < 60; ++k) step(scene.model, scene.params, {}, state, workspace, report);
  std::printf("%.3f\n", state.c[0].y());
}
