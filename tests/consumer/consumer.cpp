// SPDX-License-Identifier: MIT
// Three crates drop on a plate that hangs by a hinge: built, stepped for a second, drawn to the file that is named.
#include <cstdio>

#include "render/context/context.h"
#include "render/gl/renderer.h"
#include "render/output/png.h"
#include "render/visual/build_visual.h"
#include "sim/scene/builder.h"
#include "sim/solver/time_step.h"

int main(int, char** arguments) {
  using namespace pabd;
  SceneBuilder builder("consumer");
  builder.add(spec::Body{.name = "ground", .shape = Plane{Vec3::UnitY(), 0}});
  builder.add(spec::Body{.name = "plate", .shape = Box{{1, 0.05, 1}}, .position = Vec3(0, 1, 0)});
  builder.add(
      spec::Joint{.type = JointType::hinge, .j = "plate", .anchor = Vec3(-1, 1, 0), .axis = Vec3::UnitZ()});
  builder.add(spec::Stack{{.size = Vec3(0.5, 0.5, 0.5), .position = Vec3(0.5, 1.2, 0)}, 3});
  const Scene scene = builder.build();

  State state = scene.initial;
  StepWorkspace workspace;
  StepReport report;
  while (state.time < 1) step(scene.model, scene.params, {}, state, workspace, report);

  std::vector<ContextAttempt> attempts;
  const auto context = create_headless_context(Backend::automatic, attempts);
  Renderer renderer(*context, 640, 360);
  VisualScene visual;
  visual.camera = frame_camera(scene.model, state, 640.0 / 360);
  build_visual(scene.model, state, report, {}, visual);
  renderer.draw(visual, nullptr);
  renderer.queue_read();
  Image image;
  renderer.fetch(image);
  write_png(arguments[1], image);
  std::printf("%d bodies, joint error %.1e m\n", scene.model.size(), report.max_joint_error);
}
