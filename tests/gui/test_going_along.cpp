// SPDX-License-Identifier: MIT
// The camera that goes along by itself: what flies stays in the picture and large enough, what stands does not move it.
#include <catch2/catch.hpp>
#include <cmath>

#include "app/gui/camera_motion.h"
#include "app/gui/scene_view.h"
#include "app/gui/view_actions.h"
#include "app/workbench/workbench.h"
#include "tests/support/files.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_going_along {

namespace {

constexpr double kRadius = 0.15;  // m
constexpr const char* kThrown = R"({"format": "pabd-scene", "version": 1, "name": "thrown", "bodies": [
    {"name": "floor", "shape": {"type": "plane"}},
    {"name": "ball", "shape": {"type": "sphere", "radius": 0.15}, "position": [0, 1, 0], "velocity": [15, 6, 0]}]})";
constexpr const char* kHeap = R"({"format": "pabd-scene", "version": 1, "name": "heap", "bodies": [
    {"name": "floor", "shape": {"type": "plane"}},
    {"name": "a", "shape": {"type": "box", "size": [1, 0.5, 1]}, "position": [0, 0.25, 0]},
    {"name": "b", "shape": {"type": "box", "size": [1, 0.5, 1]}, "position": [0, 0.76, 0]},
    {"name": "c", "shape": {"type": "box", "size": [1, 0.5, 1]}, "position": [0.1, 1.27, 0]}]})";

struct Window {
  TempFolder folder;
  Workbench bench;
  UiState ui;
  CameraMotion motion;
  Viewport port{1280, 720};

  explicit Window(const char* scene)
      : bench({}, command::Load{
                      (write_bytes(folder / "s.json", scene), (folder / "s.json").string()), {}, false}) {
    frame_ahead(bench.snapshot().scene, port, ui);
    show();
  }
  void show() { motion.move(bench.snapshot(), port, ui); }
  void play() {
    bench.advance();
    show();
  }
  void act(const ViewCommand& command) { apply_view_command(command, bench.snapshot(), port, ui); }
  const Vec3& ball() { return (state_ = bench.snapshot().a.state)->c[1]; }
  double pixels_of_ball() {
    const Vec3 up = kRadius * axes_of(ui.camera).up;
    return std::abs(to_pixel(ui.camera, port, ball() + up).y - to_pixel(ui.camera, port, ball() - up).y);
  }
  bool sees_ball() {
    for (const Vec3& side : {axes_of(ui.camera).up, axes_of(ui.camera).right}) {
      for (const double r : {-kRadius, kRadius}) {
        const PixelPoint at = to_pixel(ui.camera, port, ball() + r * side);
        if (!(at.depth > 0 && at.x >= 0 && at.x <= port.width && at.y >= 0 && at.y <= port.height))
          return false;
      }
    }
    return true;
  }

 private:
  std::shared_ptr<const State> state_;
};

}  // namespace

TEST_CASE("a ball that is thrown at 15 m/s stays in the picture, and at least 12 pixels of 720 high") {
  Window w(kThrown);
  Vec3 eye = w.ui.camera.eye;
  double fastest = 0;  // change of the eye's way from frame to frame; m
  Vec3 way = Vec3::Zero();
  double h = 0;
  for (int k = 0; k < 500; ++k) {
    w.play();
    h = w.bench.run().params().h;
    CAPTURE(k, w.ball().transpose());
    CHECK(w.sees_ball());
    CHECK(w.pixels_of_ball() >= 12);
    const Vec3 now = w.ui.camera.eye - eye;
    fastest = std::max(fastest, (now - way).norm());
    way = now;
    eye = w.ui.camera.eye;
  }
  CHECK(w.ball().x() > 20);
  CHECK(w.ui.camera.target.x() > 10);
  // Smoothly, also where the ball hits the floor: from frame to frame its speed changes by a seventh of the ball's at most.
  CHECK(fastest < 15 * h / 7);
}

TEST_CASE("without it the ball leaves the picture, or is too small") {
  Window w(kThrown);
  w.act(command::Along{false});
  bool good = true;
  for (int k = 0; k < 500; ++k) {
    w.play();
    good = good && w.sees_ball() && w.pixels_of_ball() >= 12;
  }
  CHECK_FALSE(good);
}

TEST_CASE("a heap that stands does not move the camera at all") {
  Window w(kHeap);
  const CameraPose before = w.ui.camera;
  for (int k = 0; k < 300; ++k) {
    w.play();
    CHECK((w.ui.camera.eye - before.eye).norm() == 0);
    CHECK((w.ui.camera.target - before.target).norm() == 0);
  }
}

TEST_CASE("a drag stops the camera, and what frames the bodies lets it go along again") {
  Window w(kThrown);
  for (int k = 0; k < 60; ++k) w.play();
  w.ui.camera = orbit(w.ui.camera, 0.1, 0);
  const Vec3 eye = w.ui.camera.eye;
  for (int k = 0; k < 60; ++k) w.play();
  CHECK(w.ui.camera.eye == eye);
  w.act(command::FrameSelection{});
  for (int k = 0; k < 120; ++k) {
    w.play();
    CHECK(w.sees_ball());
  }
  CHECK(w.ui.camera.eye != eye);
}

}  // namespace pabd::test_going_along
