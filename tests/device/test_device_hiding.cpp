// SPDX-License-Identifier: MIT
// What others hide is not drawn, and no picture tells.
#include <catch2/catch.hpp>
#include <random>

#include "render/device/compute_functions.h"
#include "render/device/device_bodies.h"
#include "render/gl/renderer.h"
#include "render/output/compare_images.h"
#include "render/visual/body_parts.h"
#include "sim/base/error.h"
#include "tests/device/device_pictures.h"
#include "tests/device/device_scenes.h"
#include "tests/device/drawn_commands.h"
#include "tests/support/tiny_model.h"

namespace pabd::test_device_hiding {

using namespace testing;

namespace {

constexpr int kWidth = 480, kHeight = 270;
constexpr std::uint32_t kAll = 73;  // bodies of wall_and_crowd() but for its floor

// What a picture of bodies is that may hide each other, beside one that has all of them: the first of others.
CompareResult beside_all(GlContext& context, Renderer& renderer, const Model& model, unsigned poses,
                         const VisualScene& scene, const RenderQuality& quality, DeviceBodies& bodies) {
  DeviceBodies all(context, body_parts(model), poses, {.late_bounds = false});
  return compare_images(picture(renderer, scene, quality, &bodies), picture(renderer, scene, quality, &all),
                        CompareTier::same_class);
}

// Instances of the last picture.
std::uint32_t drawn(const ComputeFunctions& gl, const DeviceBodies& bodies, DeviceList list) {
  std::uint32_t out = 0;
  for (const DeviceBatches* batches : {&bodies.batches(list), &bodies.revealed(list)}) {
    for (const DrawnCommand& c : drawn_commands(gl, *batches)) out += c.instances;
  }
  return out;
}

// A wall that goes down through the floor, and behind it 12 by 6 things.
TinyModel wall_and_crowd() {
  TinyModel tiny;
  tiny.add_fixed(Plane{{0, 1, 0}, 0}, Vec3::Zero());
  tiny.add(Box{{9, 7, 0.2}}, {0, 5, 0});
  for (int k = 0; k < 72; ++k) {
    const Vec3 at(1.1 * (k % 12) - 6, 0.5 + 1.1 * (k / 12), -1.5 - 0.2 * (k % 3));
    const Mat3 R = Eigen::AngleAxisd(k, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    if (k % 4 == 0) tiny.add(Box{{0.4, 0.3, 0.2}}, at, R);
    if (k % 4 == 1) tiny.add(Sphere{0.4}, at);
    if (k % 4 == 2) tiny.add(Box{{0.1, 0.4, 0.1}}, at, R);
    if (k % 4 == 3) tiny.add(Sphere{0.1}, at);
  }
  return tiny;
}

}  // namespace

TEST_CASE("what a wall hides is drawn no longer, and again once it can be seen") {
  const auto context = any_context();
  const ComputeFunctions gl(*context);
  TinyModel tiny = wall_and_crowd();
  PoseBuffer poses(gl, tiny.state);
  Renderer renderer(*context, kWidth, kHeight);
  DeviceBodies bodies(*context, body_parts(tiny.model), poses.id(), {.late_bounds = false});
  RenderQuality quality;
  quality.level = GENERATE(Quality::draft, Quality::good, Quality::best);
  Camera camera;
  camera.orthographic = GENERATE(false, true);
  camera.target = {0, 3, 0};
  camera.eye = {0.3f, 3.2f, 15};
  const auto look = [&](const char* what) {
    const Twin twin(tiny.model, tiny.state, {}, camera);
    const CompareResult result =
        beside_all(*context, renderer, tiny.model, poses.id(), twin.bare, quality, bodies);
    CAPTURE(what, static_cast<int>(quality.level), camera.orthographic, result.reason, result.max_difference,
            result.differing);
    CHECK(result.equal);
  };
  look("the first picture has all");
  CHECK(drawn(gl, bodies, DeviceList::bodies) == kAll);
  look("from the front");
  CHECK(drawn(gl, bodies, DeviceList::bodies) == 1);
  look("again");
  CHECK(drawn(gl, bodies, DeviceList::bodies) == 1);

  camera.eye = {0.3f, 3.2f, -15};
  look("from behind");
  CHECK(drawn(gl, bodies, DeviceList::bodies) == kAll);  // the wall is seen between them
  camera.eye = {0.3f, 3.2f, 15};
  look("from the front again");
  look("and once more");
  CHECK(drawn(gl, bodies, DeviceList::bodies) == 1);
  tiny.state.c[1].x() += 9;
  poses.set(tiny.state);
  look("the wall jumped aside");
  const std::uint32_t half = drawn(gl, bodies, DeviceList::bodies);
  CHECK(half > 30);
  CHECK(half < kAll - 20);
  tiny.state.c[1].x() = 20.5;
  poses.set(tiny.state);
  look("the wall is gone");
  CHECK(drawn(gl, bodies, DeviceList::bodies) >= kAll - 1);
}

TEST_CASE("what lies in the shadow of a roof casts none of its own") {
  const auto context = any_context();
  const ComputeFunctions gl(*context);
  TinyModel tiny = wall_and_crowd();
  tiny.model.shape[1] = Box{{30, 0.2, 30}};
  tiny.state.c[1] = {0, 12, 0};
  PoseBuffer poses(gl, tiny.state);
  Renderer renderer(*context, kWidth, kHeight);
  DeviceBodies bodies(*context, body_parts(tiny.model), poses.id(), {.late_bounds = false});
  Camera camera;
  camera.target = {0, 3, 0};
  camera.eye = {3, 4, -15};
  for (int k = 0; k < 3; ++k) {
    const Twin twin(tiny.model, tiny.state, {}, camera);
    const CompareResult result =
        beside_all(*context, renderer, tiny.model, poses.id(), twin.bare, {}, bodies);
    CAPTURE(k, result.reason, result.max_difference, result.differing);
    CHECK(result.equal);
    CHECK(drawn(gl, bodies, DeviceList::casters) == (k == 0 ? kAll : 1u));
    CHECK(drawn(gl, bodies, DeviceList::near_casters) == (k == 0 ? kAll : 1u));
  }
}

TEST_CASE("pictures of bodies and cameras that jump about lack nothing") {
  const auto context = any_context();
  const ComputeFunctions gl(*context);
  const Scene scene = mixed_heap(6);
  State state = scene.initial;
  PoseBuffer poses(gl, state);
  Renderer renderer(*context, kWidth, kHeight);
  DeviceBodies bodies(*context, body_parts(scene.model), poses.id(), {.late_bounds = false});
  const Camera camera = frame_camera(scene.model, state, double{kWidth} / kHeight);
  std::mt19937 random(GENERATE(1u, 2u, 3u));
  const auto number = [&] { return static_cast<float>(random() >> 8) / 8388608.0f - 1; };  // −1 … 1
  for (int k = 0; k < 8; ++k) {
    CAPTURE(k);
    for (Vec3& c : state.c) {
      if (random() % 4 == 0) c += 0.5 * Vec3(number(), std::abs(number()), number());
    }
    poses.set(state);
    Camera now = camera;
    const float way = (camera.eye - camera.target).norm();
    if (k % 3 != 2) now.eye = now.target + way * Vec3f(number(), 1 + number(), number());
    now.orthographic = k % 4 == 3;
    const Twin twin(scene.model, state, {}, now);
    const CompareResult result =
        beside_all(*context, renderer, scene.model, poses.id(), twin.bare, {}, bodies);
    CAPTURE(result.reason, result.max_difference, result.differing);
    CHECK(result.equal);
  }
}

}  // namespace pabd::test_device_hiding
