// SPDX-License-Identifier: MIT
// Bodies drawn from the GPU's own poses: the picture is that of the processor, and what is out of sight is not drawn.
#include "render/device/device_bodies.h"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <numeric>

#include "render/device/compute_functions.h"
#include "render/device/device_layout.h"
#include "render/gl/gl_objects.h"
#include "render/gl/renderer.h"
#include "render/output/compare_images.h"
#include "render/output/png.h"
#include "render/visual/body_parts.h"
#include "render/visual/primitive_mesh.h"
#include "sim/base/error.h"
#include "tests/device/device_pictures.h"
#include "tests/device/device_scenes.h"
#include "tests/device/drawn_commands.h"
#include "tests/support/tiny_model.h"

namespace pabd::test_device_bodies {

using namespace testing;

namespace {

// Instances of each class that the last picture drew.
std::vector<std::uint32_t> drawn(const ComputeFunctions& gl, const DeviceBatches& batches) {
  std::vector<std::uint32_t> out;
  for (const DrawnCommand& c : drawn_commands(gl, batches)) out.push_back(c.instances);
  return out;
}

std::uint32_t sum(const std::vector<std::uint32_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), 0u);
}

constexpr int kWidth = 640, kHeight = 360;

}  // namespace

TEST_CASE("the picture of a heap is the same from the solver's poses on the GPU") {
  const auto context = any_context();
  Scene scene = mixed_heap(8, {3, 0, -2});
  DeviceSolver solver(*context, scene.model, scene.initial);
  for (int k = 0; k < 40; ++k) solver.enqueue(scene.params);
  State state;
  solver.read_state(state);
  Renderer renderer(*context, kWidth, kHeight);
  VisualOptions options;
  options.looks.resize(7);
  options.looks[2].checker = true;
  options.looks[5].color = Vec3(0.9, 0.1, 0.2);
  DeviceBodies bodies(*context, body_parts(scene.model, options), solver.pose_buffer(),
                      {.late_bounds = false});

  Camera camera = frame_camera(scene.model, state, double{kWidth} / kHeight);
  RenderQuality quality;
  const bool partly = GENERATE(false, true);
  if (partly) {  // a part of it is left, right, above, below and behind
    camera.eye = (camera.target + 0.16f * (camera.eye - camera.target)).eval();
    quality.level = GENERATE(Quality::draft, Quality::good, Quality::best);
  } else {
    camera.orthographic = GENERATE(false, true);
  }
  const Twin twin(scene.model, state, options, camera);
  const Image expected = picture(renderer, twin.all, quality, nullptr);
  const Image actual = picture(renderer, twin.bare, quality, &bodies);
  if (const char* folder = std::getenv("PABD_KEEP_IMAGES")) {
    write_png(std::string(folder) + "/device_bodies_cpu.png", expected);
    write_png(std::string(folder) + "/device_bodies_gpu.png", actual);
  }
  const CompareResult result = compare_images(actual, expected, CompareTier::same_class);
  CAPTURE(partly, static_cast<int>(quality.level), camera.orthographic, result.reason, result.max_difference,
          result.differing);
  CHECK(same_but_edges(*context, result));
  const ComputeFunctions gl(*context);
  const auto all = static_cast<std::uint32_t>(body_parts(scene.model).drawn);
  const std::uint32_t seen = sum(drawn(gl, bodies.batches(DeviceList::bodies)));
  CHECK(sum(drawn(gl, bodies.batches(DeviceList::casters))) == all);
  if (partly) {
    CHECK(seen > 0);
    CHECK(seen < all / 2);
  } else {
    CHECK(seen == all);
  }
  // And without it the picture is another one: the two are not equal because neither has bodies.
  const Image bare = picture(renderer, twin.bare, quality, nullptr);
  CHECK_FALSE(compare_images(bare, expected, CompareTier::cross_class).equal);
}

TEST_CASE("bodies in a scene and those on the GPU are in one picture, with each other's shadows") {
  const auto context = any_context();
  const Scene scene = mixed_heap(4);
  State state = scene.initial;
  VisualOptions translucent;
  translucent.looks.resize(6);
  translucent.looks[3].opacity = translucent.looks[4].opacity = 0.5;
  const ComputeFunctions gl(*context);
  const PoseBuffer poses(gl, state);
  Renderer renderer(*context, kWidth, kHeight);
  DeviceBodies bodies(*context, body_parts(scene.model, translucent), poses.id(), {.late_bounds = false});
  Twin twin(scene.model, state, translucent, frame_camera(scene.model, state, double{kWidth} / kHeight));
  // Those that are not opaque stay the processor's, and a hull of its own with them.
  for (int kind = 0; kind < kPrimitiveCount; ++kind) {
    for (const Instance& instance : twin.all.instances[kind])
      if (instance.color.w() < 1) twin.bare.instances[kind].push_back(instance);
  }
  for (const MeshInstances& mesh : twin.all.meshes) {
    MeshInstances left{mesh.mesh, mesh.source, {}};
    for (const Instance& instance : mesh.instances)
      if (instance.color.w() < 1) left.instances.push_back(instance);
    if (!left.instances.empty()) twin.bare.meshes.push_back(left);
  }
  REQUIRE(twin.bare.meshes.size() == 1);
  const Image expected = picture(renderer, twin.all, {}, nullptr);
  const CompareResult result =
      compare_images(picture(renderer, twin.bare, {}, &bodies), expected, CompareTier::same_class);
  CAPTURE(result.reason, result.max_difference, result.differing);
  CHECK(same_but_edges(*context, result));
}

TEST_CASE("the GPU draws what is in sight, at the levels of detail that its size asks for") {
  const auto context = any_context();
  const ComputeFunctions gl(*context);
  TinyModel tiny;
  tiny.add_fixed(Plane{{0, 1, 0}, -1}, Vec3::Zero());
  for (int k = -50; k <= 50; ++k) {
    tiny.add(Sphere{0.4}, {10.0 * k, 0, 0});
    tiny.add(Box{{0.4, 0.4, 0.4}}, {10.0 * k, 8, 0});
  }
  tiny.add(Sphere{0.4}, {0, 0, 90});
  tiny.add(Sphere{0.4}, {0, 0, 110});           // behind the eye
  tiny.add(Sphere{0.4}, {std::nan(""), 0, 0});  // left the numbers
  const PoseBuffer poses(gl, tiny.state);
  Renderer renderer(*context, 1280, 720);
  DeviceBodies bodies(*context, body_parts(tiny.model), poses.id());
  VisualScene scene;
  add_grounds(tiny.model, scene);
  scene.radius = 600;
  scene.camera.eye = {0, 0, 100};
  scene.camera.target = {0, 0, 0};
  renderer.draw(scene, nullptr, {}, &bodies);

  // 45° of height: 100 m away 41.4 m up and down and 73.6 m to both sides are in sight, 10 m away 7.4 m.
  const DeviceBatches& seen = bodies.batches(DeviceList::bodies);
  const auto counts = drawn(gl, seen);
  std::uint32_t spheres[kLevels] = {}, cubes = 0;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (seen.classes[k].primitive == Primitive::cube) cubes += counts[k];
    if (seen.classes[k].primitive == Primitive::sphere) spheres[seen.classes[k].level] += counts[k];
  }
  CHECK(cubes == 15);
  CHECK(spheres[level_for_radius(869.0f * 0.4f / 99.6f)] == 15);
  CHECK(spheres[level_for_radius(869.0f * 0.4f / 9.6f)] == 1);
  CHECK(sum(counts) == 31);
  CHECK(sum(drawn(gl, bodies.batches(DeviceList::casters))) == 204);
  CHECK(sum(drawn(gl, bodies.batches(DeviceList::floor_casters))) ==
        103);  // no higher than three half heights
}

TEST_CASE("of a box three sides are drawn, and the picture is that of all six") {
  const auto context = any_context();
  const ComputeFunctions gl(*context);
  TinyModel tiny;
  tiny.add_fixed(Plane{{0, 1, 0}, 0}, Vec3::Zero());
  for (int k = 0; k < 40; ++k) {
    const Vec3 half(0.2 + 0.05 * (k % 5), 0.3, 0.1 + 0.1 * (k % 3)), axis(std::sin(k), std::cos(3 * k), 1);
    const Mat3 R = Eigen::AngleAxisd(0.7 * k, axis.normalized()).toRotationMatrix();
    tiny.add(Box{half}, {1.1 * (k % 8), 0.5 + 0.9 * (k / 8), 1.3 * (k % 3)},
             k % 4 == 0 ? Mat3::Identity() : R);
  }
  const PoseBuffer poses(gl, tiny.state);
  Renderer renderer(*context, kWidth, kHeight);
  DeviceBodies bodies(*context, body_parts(tiny.model), poses.id(), {.late_bounds = false});
  Camera camera = frame_camera(tiny.model, tiny.state, double{kWidth} / kHeight);
  const Vec3f way = camera.eye - camera.target;
  const int look = GENERATE(0, 1, 2, 3, 4, 5);
  if (look == 1) camera.eye = camera.target + Vec3f(-way.x(), way.y(), -way.z());
  if (look == 2) camera.eye = camera.target + Vec3f(0, way.norm(), 0.01f);
  if (look == 3) camera.orthographic = true;
  if (look == 4)
    camera.eye = tiny.state.c[20].cast<float>();           // in a box, whose sides are not seen from inside
  if (look == 5) camera.eye = camera.target + 0.2f * way;  // among them
  RenderQuality quality;
  quality.level = look == 0 ? Quality::best : Quality::good;
  const Twin twin(tiny.model, tiny.state, {}, camera);
  const Image expected = picture(renderer, twin.all, quality, nullptr);
  const CompareResult result =
      compare_images(picture(renderer, twin.bare, quality, &bodies), expected, CompareTier::same_class);
  CAPTURE(look, result.reason, result.max_difference, result.differing);
  CHECK(same_but_edges(*context, result));
  for (const DeviceList list : {DeviceList::bodies, DeviceList::casters, DeviceList::near_casters}) {
    const DeviceBatches& batches = bodies.batches(list);
    std::uint32_t indices = 0;
    for (const DrawnCommand& c : drawn_commands(gl, batches)) indices += c.indices * c.instances;
    CHECK(indices == 18 * sum(drawn(gl, batches)));
    CHECK(indices > 0);
  }
}

TEST_CASE("maps of light fit bodies late, but those of another scene at once") {
  const auto context = any_context();
  const ComputeFunctions gl(*context);
  TinyModel tiny;
  tiny.add_fixed(Plane{{0, 1, 0}, 0}, Vec3::Zero());
  tiny.add(Box{{0.5, 0.5, 0.5}}, {2, 0.5, 1});
  tiny.add(Sphere{0.25}, {-3, 0.25, 1});
  const PoseBuffer poses(gl, tiny.state);
  DeviceBodies bodies(*context, body_parts(tiny.model), poses.id());
  VisualScene scene;
  scene.light_direction = {0, -1, 0};
  scene.grounds.push_back({});
  const CasterBounds first = bodies.bounds(scene);
  CHECK(first.count == 2);
  const float box = std::sqrt(0.75f), ball = std::sqrt(3.0f) * 0.25f;
  CHECK(first.reach_sum == Approx(box + ball).epsilon(1e-4));
  CHECK(first.floor_lowest.x() == Approx(-3 - ball));
  CHECK(first.floor_highest.x() == Approx(2 + box));
  CHECK(first.floor_highest.y() == Approx(1 + box));
  CHECK(first.lowest.z() == Approx(-0.5f - box));  // the light travels down
  scene.light_direction = {1, 0, 0};
  const CasterBounds turned = bodies.bounds(scene);
  CHECK(turned.lowest.z() == Approx(-3 - ball));
  CHECK(turned.highest.z() == Approx(2 + box));
  scene.radius = 0.1f;  // all is scenery
  CHECK(bodies.bounds(scene).count == 0);
}

TEST_CASE("more bodies than a buffer takes are refused with a remedy") {
  const auto context = any_context();
  const ComputeFunctions gl(*context);
  const PoseBuffer poses(gl, TinyModel{}.state);
  BodyParts parts;
  parts.drawn = static_cast<std::size_t>(compute_limits(gl).largest_buffer) / 68 + 1;
  CHECK_THROWS_WITH(DeviceBodies(*context, parts, poses.id()),
                    Catch::Contains("MiB") && Catch::Contains("--device cpu"));
}

}  // namespace pabd::test_device_bodies
