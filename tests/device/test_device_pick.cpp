// SPDX-License-Identifier: MIT
// What a pixel shows of bodies whose poses lie on the GPU: the body, place and normal of the processor's ray cast.
#include "render/device/device_pick.h"

#include <catch2/catch.hpp>
#include <set>

#include "render/visual/build_visual.h"
#include "render/visual/camera_control.h"
#include "tests/device/device_pictures.h"
#include "tests/device/device_scenes.h"
#include "tests/support/tiny_model.h"

namespace pabd::test_device_pick {

using namespace testing;

namespace {

bool same(const std::optional<RayHit>& a, const std::optional<RayHit>& b) {
  if (!a || !b) return !a && !b;
  return a->body == b->body && a->t == b->t && a->point == b->point && a->normal == b->normal;
}

}  // namespace

TEST_CASE(
    "a pixel shows the same body, at the same place, from the GPU's poses as from a state that is read "
    "back") {
  const auto context = any_context();
  const Scene scene = mixed_heap(8, {3, 0, -2}, true);
  DeviceSolver solver(*context, scene.model, scene.initial);
  DevicePick pick(*context, scene.model, solver.pose_buffer());
  std::set<Index> seen;
  int pixels = 0, different = 0;
  std::size_t most = 0;
  for (int steps = 0; steps < 2; ++steps) {
    for (int k = 0; k < 25; ++k) solver.enqueue(scene.params);
    State state;
    solver.read_state(state);
    CameraPose camera = precise(frame_camera(scene.model, state, 16.0 / 9));
    const Viewport port{160, 90};
    camera.orthographic = steps == 1;
    for (double y = 0.5; y < port.height; y += 3) {
      for (double x = 0.5; x < port.width; x += 3) {
        const ViewRay view = ray_through(camera, port, x, y);
        const Ray ray{view.origin, 2.5 * view.direction};
        const auto expected = ray_cast(scene.model, state, ray);
        different += !same(pick(ray), expected);
        most = std::max(most, pick.bytes_read());
        ++pixels;
        if (expected) seen.insert(expected->body);
      }
    }
  }
  CHECK(pixels > 3000);
  CHECK(different == 0);
  CHECK(seen.size() > 30);  // bodies of every shape, and the floor
  CHECK(most < 20'000);
}

TEST_CASE("a ray along more bodies than were expected meets the first of them") {
  const auto context = any_context();
  const ComputeFunctions gl(*context);
  TinyModel tiny;
  for (int k = 0; k < 1000; ++k) tiny.add(Box{{0.4, 0.4, 0.4}}, {1.0 * ((k * 389) % 1000), 0, 0.1});
  tiny.add(Sphere{0.4}, {std::nan(""), 0, 0});  // left the numbers
  const PoseBuffer poses(gl, tiny.state);
  DevicePick pick(*context, tiny.model, poses.id());
  for (const auto& [from, way] : {std::pair(Vec3(-5, 0, 0), Vec3(1, 0, 0)),
                                  {Vec3(2000, 0.1, 0), Vec3(-2, 0, 0)},
                                  {Vec3(499.7, 0, 0), Vec3(1, 0, 0)},  // from inside
                                  {Vec3(2000, 0, 0), Vec3(1, 0, 0)},   // all are behind
                                  {Vec3(0, 0, 0), Vec3(0, 0, 0)}}) {   // no direction
    CAPTURE(from.x(), way.x());
    CHECK(same(pick({from, way}), ray_cast(tiny.model, tiny.state, {from, way})));
  }
  CHECK(pick({{-5, 0, 0}, {1, 0, 0}}).has_value());
  CHECK_FALSE(pick({{2000, 0, 0}, {1, 0, 0}}).has_value());
}

}  // namespace pabd::test_device_pick
