// SPDX-License-Identifier: MIT
// Cameras of scenes that nobody has seen before: at every time and in frames of every shape all movable bodies that
// matter are in the picture, and large enough to be seen.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "app/frames/scene_framing.h"
#include "sim/base/error.h"
#include "sim/scene/random.h"
#include "tests/frames/seen_bodies.h"

namespace pabd::test_outlook {

using namespace seen_bodies;

namespace {

constexpr double kSeconds = 3;
constexpr double kAspects[] = {16.0 / 9, 9.0 / 16, 1, 21.0 / 9};

std::string three(const Vec3& v) { return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z()); }

std::shared_ptr<const Scene> scene_of(const std::string& bodies) {
  return std::make_shared<const Scene>(
      parse_scene(R"({ "format": "pabd-scene", "version": 1, "bodies": [)" + bodies + "] }", "test", {}));
}

constexpr const char* kPlane = R"({ "shape": { "type": "plane" } })";

std::string ball(double radius, const Vec3& at, const Vec3& v) {
  return fmt::format(
      R"(, {{ "shape": {{ "type": "sphere", "radius": {} }}, "position": {}, "velocity": {} }})", radius,
      three(at), three(v));
}

// One to twenty bodies of 0.05 to 1 m, apart from each other, with speeds of up to 20 m/s, over a plane; in every third
// scene also a fixed block, some of them much larger than the rest.
std::shared_ptr<const Scene> random_scene(std::uint64_t seed) {
  Random random(seed);
  const double size = 0.05 * std::pow(20.0, random.uniform());
  const int count = 1 + static_cast<int>(20 * random.uniform() * random.uniform());
  const double speed = 20 * std::pow(random.uniform(), 3);
  std::string bodies = kPlane;
  for (int i = 0; i < count; ++i) {
    const Vec3 at(3 * size * (i % 4), size * (1.5 + 8 * random.uniform()), 3 * size * (i / 4));
    Vec3 v;  // in order, whatever the compiler
    for (double& x : v) x = speed * random.symmetric();
    const double a = size * (0.4 + 0.6 * random.uniform());
    const char* const shapes[] = {R"("sphere", "radius": {0})", R"("box", "size": [{0}, {1}, {0}])",
                                  R"("capsule", "radius": {1}, "length": {0})",
                                  R"("cylinder", "radius": {1}, "height": {0})"};
    const std::string shape =
        fmt::format(fmt::runtime(shapes[static_cast<std::size_t>(4 * random.uniform())]), 0.5 * a, 0.4 * a);
    bodies += fmt::format(R"(, {{ "shape": {{ "type": {} }}, "position": {}, "velocity": {} }})", shape,
                          three(at), three(v));
  }
  if (seed % 3 == 0) {
    const double block = size * (1 + 30 * random.uniform() * random.uniform());
    bodies += fmt::format(
        R"(, {{ "shape": {{ "type": "box", "size": [{0}, {0}, {0}] }}, "fixed": true, "position": [0, {1}, {2}] }})",
        block, 0.5 * block, -3 * size - block);
  }
  return scene_of(bodies);
}

struct Seen {
  int outside = 0, movable = 0;
  double width = 0, height = 0;  // of all that is inside, of the frame
  double body = 0;               // median of the larger sides of bodies inside, of the frame's shorter side
};

Seen look(const Camera& camera, double aspect, const Start& start, const State& state) {
  const Mat4f clip =
      projection_matrix(camera, static_cast<float>(aspect), 0.01f, 1000.0f) * view_matrix(camera);
  Seen out;
  Extent all;
  std::vector<double> sizes;
  for (std::size_t i = 0; i < start.surface.size(); ++i) {
    if (start.scene->model.fixed[i]) continue;
    Extent body;
    for (const Vec3& p : start.surface[i]) body.add(clip, state.c[i] + state.R[i] * p);
    ++out.movable;
    if (!(body.nearest > 0 && body.x0 > 0 && body.x1 < 1 && body.y0 > 0 && body.y1 < 1)) {
      ++out.outside;
      continue;
    }
    all.x0 = std::min(all.x0, body.x0), all.x1 = std::max(all.x1, body.x1);
    all.y0 = std::min(all.y0, body.y0), all.y1 = std::max(all.y1, body.y1);
    sizes.push_back(std::max(aspect * (body.x1 - body.x0), body.y1 - body.y0) / std::min(1.0, aspect));
  }
  if (sizes.empty()) return out;
  out.width = all.x1 - all.x0;
  out.height = all.y1 - all.y0;
  std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2), sizes.end());
  out.body = sizes[sizes.size() / 2];
  return out;
}

}  // namespace

TEST_CASE("in a hundred random scenes all that matters is seen at every time, in frames of every shape") {
  int eased = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const Start start = open_scene(random_scene(seed));
    const Outlook outlook = look_ahead(start.scene, start.view, kSeconds);
    EasedCamera cameras[std::size(kAspects)];
    for (std::size_t k = 0; k < std::size(kAspects); ++k)
      cameras[k] = frame_view(CameraOption{}, side_of(*start.scene), outlook, kAspects[k], PicturePart{});
    eased += cameras[0].is_still() ? 0 : 1;
    Session run(start.scene);
    while (run.state().time < kSeconds - 0.01) {
      for (std::size_t k = 0; k < std::size(kAspects); ++k) {
        const Seen seen = look(cameras[k].at(run.state().time), kAspects[k], start, run.state());
        CAPTURE(seed, kAspects[k], run.state().time, seen.movable, seen.width, seen.height, seen.body);
        // One of ten may be far away, of five at least.
        REQUIRE(seen.outside <= (seen.movable < 5 ? 0 : (seen.movable + 9) / 10));
        REQUIRE((std::max(seen.width, seen.height) > 0.3 || seen.body > 0.01));  // seven pixels of 720
      }
      for (int step = 0; step < 6; ++step) run.step();
    }
  }
  CHECK(eased > 10);
  CHECK(eased < 60);
}

TEST_CASE("a camera that eases never jumps") {
  const Start start = open_scene(scene_of(kPlane + ball(0.1, {0, 0.2, 0}, {20, 5, 0})));
  const EasedCamera camera = frame_view(CameraOption{}, side_of(*start.scene),
                                        look_ahead(start.scene, start.view, 4), 16.0 / 9, PicturePart{});
  REQUIRE_FALSE(camera.is_still());
  const double h = 1.0 / 60;
  double fastest = 0, sharpest = 0;  // m: way in a frame, and how much it changes to the next one
  for (int k = 1; k < 240; ++k) {
    const Vec3 a = camera.at((k - 1) * h).eye.cast<double>(), b = camera.at(k * h).eye.cast<double>(),
               c = camera.at((k + 1) * h).eye.cast<double>();
    fastest = std::max(fastest, (c - b).norm());
    sharpest = std::max(sharpest, (c - 2 * b + a).norm());
  }
  CHECK(fastest < 1.5 * 20.7 * h);  // of the ball
  CHECK(sharpest < 0.3 * fastest);
  CHECK(camera.at(-1) == camera.at(0));
  CHECK(camera.at(99) == camera.at(50));
}

TEST_CASE("who is far away matters unless others are many, or all are") {
  for (const int near : {1, 3, 4, 9, 30}) {
    std::string bodies = kPlane;
    for (int k = 0; k < near; ++k) bodies += ball(0.2, {0.5 * (k % 5), 0.21, 0.5 * (k / 5)}, Vec3::Zero());
    const Start start = open_scene(scene_of(bodies + ball(0.2, {0.5, 2, 0}, {0, 0, -60})));
    const Outlook outlook = look_ahead(start.scene, start.view, 3);
    double far = 0;
    for (const Spot& spot : outlook.moments.back().spots) far = std::max(far, -spot.centre.z());
    CAPTURE(near, far);
    CHECK((far > 50) == (near < 4));
  }
}

TEST_CASE("what falls for ever has left, unless all of it does") {
  const std::string table =
      R"({ "shape": { "type": "box", "size": [2, 0.1, 2] }, "fixed": true, "position": [0, 1, 0] })";
  const Start some = open_scene(
      scene_of(table + ball(0.1, {0, 1.15, 0}, Vec3::Zero()) + ball(0.1, {1.5, 1.15, 0}, Vec3::Zero())));
  CHECK(look_ahead(some.scene, some.view, 4).moments.back().spots.size() == 1);
  const Start all = open_scene(
      scene_of(ball(0.1, {0, 1.15, 0}, Vec3::Zero()).substr(2) + ball(0.1, {1.5, 1.15, 0}, Vec3::Zero())));
  CHECK(look_ahead(all.scene, all.view, 4).moments.back().spots.size() == 2);
}

TEST_CASE("a camera fits the bodies that it is asked for, and turns once in the time of a video") {
  const Start start = open_scene(scene_of(
      std::string(kPlane) +
      R"(, { "name": "leg left", "shape": { "type": "sphere", "radius": 0.1 }, "position": [4, 0.11, 0] },
           { "name": "leg right", "shape": { "type": "sphere", "radius": 0.1 }, "position": [5, 0.11, 0] },
           { "name": "rest", "shape": { "type": "box", "size": [1, 1, 1] }, "position": [0, 0.51, 0] })"));
  const Model& model = start.scene->model;
  CHECK(bodies_to_fit(parse_camera("fit:leg*,iso"), model) == std::vector<Index>{1, 2});
  CHECK(bodies_to_fit(parse_camera("fit:rest,fit:1"), model) == std::vector<Index>{1, 3});
  for (const char* wrong : {"fit:arm*", "fit:0", "fit:9", "fit:leg"})
    CHECK_THROWS_AS(bodies_to_fit(parse_camera(wrong), model), Error);
  const Outlook legs = look_ahead(start.scene, start.view, 1, {1, 2});
  const Camera camera = frame_view(CameraOption{}, side_of(*start.scene), legs, 1.5, PicturePart{}).at(0.5);
  CHECK(camera.target.x() == Approx(4.5).margin(0.1));
  CHECK((camera.eye - camera.target).norm() < 5);
  CHECK(parse_camera("orbit").whole_turn);
  CHECK(parse_camera("orbit:-8s").orbit == Approx(-45));
  for (const char* wrong : {"fit:", "orbit:0s", "orbit:s", "orbit,orbit:8s"})
    CHECK_THROWS_AS(parse_camera(wrong), Error);
}

}  // namespace pabd::test_outlook
