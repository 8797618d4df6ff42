// SPDX-License-Identifier: MIT
// An OBJ a frame: bodies are where the run has them, faces name vertices and materials that there are.
#include <catch2/catch.hpp>
#include <map>
#include <set>
#include <sstream>

#include "app/frames/frame_source.h"
#include "tests/export/export_helpers.h"
#include "tests/support/errors.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_obj {

using namespace testing;

namespace {

struct Obj {
  std::map<std::string, std::vector<Vec3>> objects;    // vertices
  std::map<std::string, std::vector<Vec3>> triangles;  // corners, three each
  std::set<std::string> materials;
  std::vector<Vec3> vertices;
  std::size_t faces = 0;
};

Obj parsed(const std::string& text) {
  Obj out;
  std::string object, word;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream in(line);
    in >> word;
    if (word == "o") {
      in >> object;
      CHECK(out.objects.count(object) == 0);
    } else if (word == "v") {
      Vec3 v;
      in >> v.x() >> v.y() >> v.z();
      REQUIRE(in);
      out.objects[object].push_back(v);
      out.vertices.push_back(v);
    } else if (word == "usemtl") {
      in >> word;
      out.materials.insert(word);
    } else if (word == "f") {
      ++out.faces;
      for (int k = 0; k < 3; ++k) {
        std::size_t a = 0, b = 0;
        char slash = 0;
        in >> a >> slash >> slash >> b;
        REQUIRE(in);
        REQUIRE((a >= 1 && a <= out.vertices.size() && a == b));
        out.triangles[object].push_back(out.vertices[a - 1]);
      }
    }
  }
  return out;
}

}  // namespace

TEST_CASE("each .obj has the bodies of its frame where they are") {
  const TempFolder folder;
  const auto scene = varied_scene();
  const auto frames = frames_of(scene, 3, 10);
  const std::string out = export_path((folder / "frames" / "body_%03d.obj").string());
  export_frames(out, *scene, frames, {.fps = 10, .segments = 16});
  const std::string library = read_bytes(folder / "frames" / "body.mtl");
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const std::string text = read_bytes(folder / "frames" / ("body_00" + std::to_string(k) + ".obj"));
    CHECK(text.find("mtllib body.mtl\n") != std::string::npos);
    const Obj obj = parsed(text);
    CHECK(obj.objects.size() == scene->model.name.size());
    CHECK(obj.faces > 100);
    for (const std::string& name : obj.materials)
      CHECK(library.find("newmtl " + name + "\n") != std::string::npos);
    const State& state = *frames[k].a.state;
    // Corners of the crate are those of the run's box.
    for (const Vec3& corner : obj.objects.at("crate")) {
      const Vec3 own = state.R[2].transpose() * (corner - state.c[2]);
      CHECK((own.cwiseAbs() - Vec3(0.5, 0.5, 0.5)).norm() < 1e-6);
    }
    for (const Vec3& place : obj.objects.at("ball"))
      CHECK((place - state.c[4]).norm() == Approx(0.4).epsilon(5e-2));
    CHECK(obj.objects.at("crate_\"2\"_é").size() == 24);
    for (const Polyhedron& solid : polyhedra()) {
      std::vector<Vec3> own;
      for (const Vec3& corner : obj.triangles.at(solid.name))
        own.push_back(state.R[solid.body].transpose() * (corner - state.c[solid.body]));
      check_surface(solid, own, 3e-6);  // float, some ten metres from the origin
    }
  }
}

TEST_CASE("frames of an export show the steps that pictures show") {
  const auto scene = varied_scene();
  const auto frames = frames_of(scene, 13, 25);
  LiveSource pictures(Run(scene, 1, kNoPast), {}, FrameRange{0, 14, 25});
  for (const Frame& frame : frames) {
    const auto picture = pictures.next([] { return false; });
    REQUIRE(picture);
    CHECK(frame.number == picture->number);
    CHECK(same_bits(*frame.a.state, *picture->a.state));
  }
}

TEST_CASE("names of numbered files are understood or refused") {
  CHECK(export_path("a/b_%04d.obj") == "a/b_{frame:04}.obj");
  CHECK(export_path("b%d.obj") == "b{frame}.obj");
  CHECK(export_path("frames/") == "frames/frame_{frame:04}.obj");
  CHECK(export_path("100%.glb") == "100%.glb");
  CHECK(caught([] { export_path("a_%4d.obj"); }).kind == bad_input);
  CHECK(caught([] { export_path("a_%s.obj"); }).kind == bad_input);
  CHECK(export_format("a.glb") == ExportFormat::gltf);
  for (const char* name : {"a.gltf", ".glb", "a", "", "-"}) {
    const Caught refused = caught([&] { export_format(name); });
    CHECK(refused.kind == bad_input);
    CHECK(refused.says(".usda"));
  }
}

}  // namespace pabd::test_obj
