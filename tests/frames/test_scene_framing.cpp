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
#include "render/visual/bounds.h"
#include "sim/base/error.h"
#include "sim/body/shape_kind.h"
#include "tests/support/places.h"

namespace pabd::test_scene_framing {

namespace {

constexpr struct { int width, height; } kFrames[] = {{1280, 720}, {720, 1280}, {900, 900}, {1680, 720}};
constexpr const char* kCameras[] = {"", "front", "side", "top", "iso", "orbit:45", "ortho", "iso,ortho"};

struct Extent {
  double x0 = 1e9, y0 = 1e9, x1 = -1e9, y1 = -1e9;
  float nearest = 1e9f;  // to the eye; negative: behind it
  bool is_empty() const { return x0 > x1; }
  void add(const Mat4f& clip, const Vec3& p) {
    const Vec4f c = clip * p.cast<float>().homogeneous();
    nearest = std::min(nearest, c.w());
    const double x = 0.5 + 0.5 * c.x() / c.w(), y = 0.5 - 0.5 * c.y() / c.w();
    x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
  }
};

// The surface of a body by points of its own frame: an independent way to say where it is. Support points in many
// directions where a shape has them, corners of parts else.
std::vector<Vec3> surface_of(const Shape& shape) {
  std::vector<Vec3> out;
  std::vector<SurfacePart> parts;
  kind_of(shape).surface(shape, parts);
  for (const SurfacePart& part : parts) {
    if (part.form == SurfaceForm::polyhedron) {
      for (const Vec3& vertex : part.hull->data->vertices) out.push_back(part.at + vertex);
      continue;
    }
    const int around = part.form == SurfaceForm::box ? 1 : 16;
    for (int i = 0; i < 8; ++i) {
      for (int k = 0; k < around; ++k) {
        const double a = 2 * kPi * k / 16, b = kPi * (i / 7.0 - 0.5);
        Vec3 p;
        if (part.form == SurfaceForm::box) {
          p = Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
        } else if (part.form == SurfaceForm::ball || part.form == SurfaceForm::half_ball) {
          p = Vec3(std::cos(b) * std::cos(a), std::sin(b), std::cos(b) * std::sin(a));
        } else {
          p = Vec3(std::cos(a), part.form == SurfaceForm::cone ? 0 : i % 2 == 0 ? 1 : -1, std::sin(a));
        }
        out.push_back(part.at + part.size.cwiseProduct(p));
      }
    }
  }
  return out;
}

struct Start {
  std::shared_ptr<const Scene> scene;
  FrameView view;
  std::vector<std::vector<Vec3>> surface;  // of the bodies that are in the picture; of others nothing
};

Start open_scene(std::shared_ptr<const Scene> scene) {
  Start out;
  out.scene = std::move(scene);
  out.view = Session(out.scene).view();
  const Model& model = out.scene->model;
  const std::vector<std::uint8_t> seen = bodies_in_picture(model, out.scene->initial);
  out.surface.resize(seen.size());
  for (std::size_t i = 0; i < seen.size(); ++i)
    if (seen[i]) out.surface[i] = surface_of(model.shape[i]);
  return out;
}
Start open(const std::filesystem::path& file) {
  return open_scene(std::make_shared<const Scene>(load_scene(file)));
}

Extent extent_of(const Camera& camera, double aspect, const Start& start, const State& state) {
  const Mat4f clip =
      projection_matrix(camera, static_cast<float>(aspect), 0.01f, 1000.0f) * view_matrix(camera);
  Extent out;
  for (std::size_t i = 0; i < start.surface.size(); ++i)
    for (const Vec3& p : start.surface[i]) out.add(clip, state.c[i] + state.R[i] * p);
  REQUIRE(out.nearest > 0);
  return out;
}

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
        const PicturePart part = free_part(layout, 0, frame.width, frame.height);
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
    const std::vector<Spot> spots = spots_ahead(start.scene, start.view, 2);
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
            fit_camera(spots_ahead(start.scene, start.view, 5), side_of(*start.scene), aspect);
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
  const Camera camera = fit_camera(spots_ahead(start.scene, start.view, 3), side_of(*start.scene), 1.5);
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
