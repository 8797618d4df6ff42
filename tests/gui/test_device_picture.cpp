// SPDX-License-Identifier: MIT
// A window on a run whose bodies stay on the GPU: the same picture, and states when somebody asks for what takes them.
#include <catch2/catch.hpp>
#include <chrono>
#include <functional>
#include <thread>

#include "app/gui/scene_view.h"
#include "app/gui/viewer.h"
#include "render/output/compare_images.h"
#include "sim/scene/scene.h"
#include "tests/support/drift_device.h"
#include "tests/support/gpu_steps.h"
#include "tests/support/places.h"

namespace pabd::test_device_picture {

namespace {

std::unique_ptr<GlContext> any_context() {
  std::vector<ContextAttempt> attempts;
  return create_headless_context(Backend::automatic, attempts);
}

const std::string kDominoes = places::scenes() + "/dominoes.json",
                  kTwoBoxes = places::scenes() + "/two_boxes.json";

// Whether it is so within two minutes: the shaders of a run are compiled first, on a busy machine.
bool comes(const std::function<bool()>& condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(2);
  while (!condition())
    if (std::chrono::steady_clock::now() > end) return false;
  return true;
}

}  // namespace

TEST_CASE("a run is drawn from the GPU's memory as from its states, at rest and in motion, of any size") {
  const auto context = any_context();
  const auto shared = std::make_shared<SharedContext>();
  shared->put_beside(*context);
  auto scene = std::make_shared<Scene>(load_scene(kDominoes));
  scene->params.solver.device = SolverDevice::gpu;
  scene->params.solver.method = SolverMethod::automatic;
  Run run(scene, 1, 2 * state_bytes(scene->initial));
  run.offer(std::make_shared<test::GpuSteps>(shared));
  run.let_bodies_stay(true);
  context->make_current();

  constexpr int kWidth = 320, kHeight = 200;
  Renderer renderer(*context, kWidth, kHeight);
  DevicePicture device(*context);
  SceneView view;
  UiState ui;
  ui.contacts = ui.bonds = false;
  ui.open = {};
  look_as_scene(*scene, {kWidth, kHeight}, ui);
  const GuiLayout layout = layout_gui(ui, kWidth, kHeight, 1, false);
  Snapshot sim;
  sim.scene = scene;
  const auto picture = [&] {
    static_cast<FrameView&>(sim.a) = run.view();
    sim.a.scene = scene;
    Image image;
    for (int frame = 0; frame < 6; ++frame) {  // the maps of light are late
      ++sim.serial;
      REQUIRE(view.draw(sim, ui, {}, layout, {}, 1, renderer, device));
    }
    const std::vector<ViewPlace> places = {{0, 0, 0, kWidth, kHeight}};
    renderer.compose(kWidth, kHeight, places, {}, nullptr);
    renderer.queue_read();
    renderer.fetch(image);
    return image;
  };
  int compared = 0;
  for (int round = 0; round < 3; ++round) {
    // In a thread of its own, as engines leave no context current.
    std::thread([&] {
      for (int k = 0; k < 12 || (k < 100 && !run.bodies_stayed()); ++k) run.advance();
    }).join();
    CAPTURE(run.device().why);
    REQUIRE(run.bodies_stayed());
    REQUIRE(device.can_draw([&] {
      static_cast<FrameView&>(sim.a) = run.view();
      sim.a.scene = scene;
      return sim.a;
    }()));
    REQUIRE(run.view().poses);
    const Image of_gpu = picture();
    std::thread([&] { run.complete(); }).join();
    run.let_bodies_stay(false);
    REQUIRE(run.view().poses == nullptr);
    const Image of_state = picture();
    const CompareResult result = compare_images(of_gpu, of_state, CompareTier::same_class);
    CAPTURE(round, result.reason);
    CHECK(result.equal);
    ++compared;
    run.let_bodies_stay(true);
    ui.camera.eye += Vec3(0.3, 0.2, -0.4);
  }
  CHECK(compared == 3);
}

TEST_CASE("the window lets bodies stay while it plays, and has states for what takes them") {
  const auto context = any_context();
  const auto shared = std::make_shared<SharedContext>();
  shared->put_beside(*context);
  WorkbenchOptions bench;
  bench.memory = 3000;  // few states
  bench.devices = std::make_shared<test::GpuSteps>(shared);
  Runner runner(std::make_unique<Workbench>(bench, command::Load{kTwoBoxes, {"solver.device=gpu"}, false}));
  context->make_current();
  ViewerOptions options;
  options.steady = true;
  options.start.contacts = options.start.bonds = false;
  options.start.open = {};
  Viewer viewer(*context, runner, options);
  const auto draw = [&] { viewer.draw(320, 200, 0.02); };
  const auto stays = [&] {
    return comes([&] {
      draw();
      return viewer.snapshot().a.poses != nullptr;
    });
  };
  const auto whole = [&] { return viewer.snapshot().a.state->size() == viewer.snapshot().a.model->size(); };
  draw();
  CHECK(whole());
  viewer.send(Command(command::Speed{0}));
  viewer.send(Command(command::Play{}));
  REQUIRE(stays());

  SECTION("turning the camera takes no states, a key and a double click do") {
    viewer.handle(MouseMoved{160, 90});
    viewer.handle(MouseScrolled{0, 1});
    CHECK(stays());
    viewer.handle(KeyChanged{Key::c, {}, true, false});
    draw();
    CHECK(whole());
    viewer.handle(KeyChanged{Key::c, {}, false, false});
    viewer.handle(KeyChanged{Key::c, {}, true, false});
    viewer.handle(KeyChanged{Key::c, {}, false, false});
    CHECK(stays());
    for (const bool pressed : {true, false, true, false})
      viewer.handle(MouseClicked{MouseButton::left, pressed, {}});
    for (int k = 0; k < 8; ++k) draw();
    CHECK(viewer.ui().selection.kind == Selection::Kind::body);
    CHECK(whole());
  }
  SECTION("so do colours, a camera that follows, and the end of playing") {
    const auto takes = [&](const ViewCommand& on, const ViewCommand& off) {
      viewer.send(on);
      for (int k = 0; k < 5; ++k) {
        draw();
        CHECK(whole());
      }
      viewer.send(off);
      CHECK(stays());
    };
    takes(command::ColorBy{"speed"}, command::ColorBy{"body"});
    takes(command::Follow{"1"}, command::Follow{""});
    viewer.send(Command(command::Pause{}));
    runner.settle();
    draw();
    CHECK(whole());
  }
}

TEST_CASE("where pictures cannot be drawn from a device's memory, states come back, and that is told once") {
  const auto context = any_context();
  const auto devices = std::make_shared<test::DriftDevices>();
  devices->draws = true;  // so it says
  WorkbenchOptions bench;
  bench.memory = 3000;
  bench.devices = devices;
  Runner runner(std::make_unique<Workbench>(bench, command::Load{kTwoBoxes, {"solver.device=gpu"}, false}));
  context->make_current();
  ViewerOptions options;
  options.steady = true;
  options.start.open = {};
  options.start.contacts = options.start.bonds = false;
  Viewer viewer(*context, runner, options);
  viewer.send(Command(command::Speed{0}));
  viewer.send(Command(command::Play{}));
  const auto told = [&] {
    const auto& messages = viewer.snapshot().messages;
    return std::count_if(messages.begin(), messages.end(), [](const Message& message) {
      return message.text.find("bodies come back from the GPU for each picture") == 0;
    });
  };
  const auto draw = [&] {
    runner.settle();
    viewer.draw(640, 360, 0.02);
  };
  REQUIRE(comes([&] {
    draw();
    return told() == 1;
  }));
  for (int k = 0; k < 50; ++k) {
    draw();
    CHECK(viewer.snapshot().a.state->size() == 3);
  }
  CHECK(told() == 1);
  CHECK(viewer.snapshot().playing);
}

}  // namespace pabd::test_device_picture
