// SPDX-License-Identifier: MIT
// Every shipped scene, from every named camera, in frames of every shape, with and without panels: all bodies are
// inside of what is free. They are looked at through the matrices that pictures are drawn with, and where a run of its
// own takes them. No GL.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "app/frames/frame_painter.h"
#include "app/frames/scene_framing.h"
#include "app/session/session.h"
#include "sim/base/error.h"
#include "tests/frames/seen_bodies.h"
#include "tests/support/places.h"

namespace pabd::test_scene_framing {

using namespace seen_bodies;

namespace {

constexpr struct { int width, height; } kFrames[] = {{1280, 720}, {720, 1280}, {900, 900}, {1680, 720}};
constexpr const char* kCameras[] = {"", "front", "side", "top", "iso", "orbit:45", "ortho", "iso,ortho"};

std::vector<std::filesystem::path> scenes() {
  std::vector<std::filesystem::path> out;
  for (const auto& entry : std::filesystem::directory_iterator(places::scenes())) {
    if (entry.path().extension() == ".json") out.push_back(entry.path());
  }
  REQUIRE(out.size() > 20);
  return out;
}

}  // namespace

TEST_CASE("all shipped scenes are whole in every frame, fill it and are in the middle") {
  for (const auto& file : scenes()) {
    const Start start = open(file);
    const Scene& scene = *start.scene;
    const std::vector<Spot> spots = spots_of(scene.model, scene.initial);
    for (const auto& frame : kFrames) {
      const double aspect = static_cast<double>(frame.width) / frame.height;
      for (const char* overlay : {"none", "plots,contacts", "params,series"}) {
        OverlayData data;
        data.view = &start.view;
        const PanelLayout layout =
            layout_panels(parse_overlay(overlay).panels, data, frame.width, frame.height);
        const PicturePart part = free_part(layout, std::nullopt, frame.width, frame.height);
        for (const char* name : kCameras) {
          CAPTURE(file.stem().string(), frame.width, frame.height, overlay, name);
          const CameraOption option = parse_camera(name);
          const Camera base = frame_view(option, side_of(scene), spots, aspect, part);
          const bool orbits = option.view == CameraOption::View::orbit;
          for (int k = 0; k < (orbits ? 16 : 1); ++k) {
            const Extent seen = extent_of(apply_camera(option, base, 0.5 * k), aspect, start, scene.initial);
            const double margin = 0.03;
            CHECK(seen.x0 > part.x + margin * part.w);
            CHECK(seen.x1 < part.x + (1 - margin) * part.w);
            CHECK(seen.y0 > part.y + margin * part.h);
            CHECK(seen.y1 < part.y + (1 - margin) * part.h);
            if (orbits) continue;
            // A floor below what falls is in the picture as well: then bodies alone fill less, and are above the
            // middle.
            const bool on_floor = spots.size() == body_spots(scene.model, scene.initial).size();
            if (!on_floor) continue;
            CHECK(std::max((seen.x1 - seen.x0) / part.w, (seen.y1 - seen.y0) / part.h) > kFill - 0.02);
            CHECK(0.5 * (seen.x0 + seen.x1) == Approx(part.x + 0.5 * part.w).margin(0.01 * part.w));
            CHECK(0.5 * (seen.y0 + seen.y1) == Approx(part.y + 0.5 * part.h).margin(0.01 * part.h));
          }
        }
      }
    }
  }
}

TEST_CASE("bodies stay in the picture while they move, where looking ahead is cheap") {
  for (const char* name : {"four_bar", "slider_crank", "double_pendulum", "pendulum", "ferris_wheel", "spin",
                           "bridge", "newtons_cradle", "chain_heavy_end", "shapes", "ragdoll"}) {
    const Start start = open(std::filesystem::path(places::scenes()) / (std::string(name) + ".json"));
    const double aspect = 16.0 / 9;
    const std::vector<Spot> spots = look_ahead(start.scene, start.view, 2).all();
    const Camera camera = fit_camera(spots, side_of(*start.scene), aspect);
    Session run(start.scene);
    // Steps of another length lead elsewhere in the end: by a hundredth of the picture.
    while (run.state().time < 1.5) {
      for (int k = 0; k < 16; ++k) run.step();
      const Extent seen = extent_of(camera, aspect, start, run.state());
      CAPTURE(name, run.state().time);
      CHECK(seen.x0 > 0.01);
      CHECK(seen.x1 < 0.99);
      CHECK(seen.y0 > 0.01);
      CHECK(seen.y1 < 0.99);
    }
  }
}

namespace {

Start begin(const std::string& bodies) {
  return open_scene(std::make_shared<const Scene>(
      parse_scene(R"({ "format": "pabd-scene", "version": 1, "bodies": [{ "shape": { "type": "plane" } }, )" +
                      bodies + "] }",
                  "test", {})));
}

std::string ball(double radius, const Vec3& at, const Vec3& v = Vec3::Zero()) {
  return fmt::format(
      R"({{ "shape": {{ "type": "sphere", "radius": {} }}, "position": [{}, {}, {}], "velocity": [{}, {}, {}] }})",
      radius, at.x(), at.y(), at.z(), v.x(), v.y(), v.z());
}

}  // namespace

// The simplest scene of one's own.
TEST_CASE(
    "a ball that falls on the ground is in the picture at every time, from any height, also where it rolls "
    "on") {
  for (const double radius : {0.1, 0.5}) {
    for (const double height : {0.3, 1.5, 5.0, 20.0}) {
      for (const double speed : {0.0, 2.0}) {
        CAPTURE(radius, height, speed);
        const Start start = begin(ball(radius, {0, height + radius, 0}, {speed, 0, 0}));
        const double aspect = 16.0 / 9;
        const Camera camera =
            fit_camera(look_ahead(start.scene, start.view, 5).all(), side_of(*start.scene), aspect);
        Session run(start.scene);
        while (run.state().time < 4.9) {
          const Extent seen = extent_of(camera, aspect, start, run.state());
          CAPTURE(run.state().time);
          if (speed == 0 || run.state().time < 1.5) {
            CHECK((seen.x0 > 0.01 && seen.x1 < 0.99 && seen.y0 > 0.01 && seen.y1 < 0.99));
          }
          for (int k = 0; k < 10; ++k) run.step();
        }
      }
    }
  }
}

TEST_CASE("a body that flies off makes the others no smaller") {
  std::string heap;
  for (int k = 0; k < 9; ++k) heap += ball(0.2, {0.5 * (k % 3), 0.21 + 0.5 * (k / 3), 0}) + ", ";
  const Start start = begin(heap + ball(0.2, {0.5, 2, 0}, {0, 0, -60}));
  const Camera camera = fit_camera(look_ahead(start.scene, start.view, 3).all(), side_of(*start.scene), 1.5);
  const Extent seen = extent_of(camera, 1.5, start, start.scene->initial);
  CHECK(std::max(seen.x1 - seen.x0, seen.y1 - seen.y0) > 0.3);
}

TEST_CASE("a camera that follows goes as far as its body, and starts near it") {
  const Start start = open(std::filesystem::path(places::scenes()) / "pendulum.json");
  const Model& model = start.scene->model;
  CHECK_THROWS_AS(followed_body(parse_camera("follow:nobody"), model), Error);
  CHECK_THROWS_AS(followed_body(parse_camera("follow:999"), model), Error);
  CHECK_THROWS_AS(parse_camera("follow:"), Error);
  CHECK_FALSE(followed_body(parse_camera("iso"), model));
  const CameraOption option = parse_camera("iso,follow:" + model.name.back());
  const auto body = followed_body(option, model);
  REQUIRE(body);
  const Vec3 c = start.scene->initial.c[static_cast<std::size_t>(*body)];
  const std::vector<Spot> spots = spots_of(model, start.scene->initial);
  const Camera all = frame_view(option, side_of(*start.scene), spots, 1.5, {});
  const Camera near =
      come_near(option, all, {c, bounding_radius(model.shape[static_cast<std::size_t>(*body)])}, 1.5, {});
  CHECK((near.target.cast<double>() - c).norm() < 1e-4);
  CHECK((near.eye - near.target).norm() < 1.0001f * (all.eye - all.target).norm());
  const Vec3 way(0.5, -0.25, 2);
  const Camera later = apply_camera(option, near, 3, way);
  CHECK((later.target - near.target - way.cast<float>()).norm() < 1e-5f);
  CHECK((later.eye - near.eye - way.cast<float>()).norm() < 1e-5f);
}

TEST_CASE("words of a camera go together, and come back") {
  const CameraOption option = parse_camera("orbit:-20,ortho,fov=30,up=0,0,1,follow:left hand");
  CHECK(option.view == CameraOption::View::orbit);
  CHECK(option.orbit == -20);
  CHECK(option.orthographic);
  CHECK(*option.fov == 30);
  CHECK(*option.up == Vec3f(0, 0, 1));
  CHECK(option.follow == "left hand");
  Camera camera;
  camera.orthographic = true;
  CHECK(apply_camera(parse_camera(camera_words(camera)), Camera{}, 0).orthographic);
  for (const char* wrong : {"front,side", "ortho=1", "front,7", "orbit:x", "=3", "ortho,1"}) {
    CAPTURE(wrong);
    CHECK_THROWS_AS(parse_camera(wrong), Error);
  }
}

}  // namespace pabd::test_scene_framing
