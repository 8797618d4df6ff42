// SPDX-License-Identifier: MIT
// A .glb read back by tinygltf: buffers and accessors fit, meshes are the bodies, keys are the poses of the run.
#include <tiny_gltf.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <set>

#include "app/frames/frame_source.h"
#include "render/visual/visual_scene.h"
#include "tests/export/export_helpers.h"
#include "tests/support/errors.h"
#include "tests/support/temp_folder.h"

namespace pabd::test_gltf {

using namespace testing;

namespace {

tinygltf::Model loaded(const std::string& path) {
  tinygltf::TinyGLTF loader;
  tinygltf::Model model;
  std::string error, warning;
  const bool good = loader.LoadBinaryFromFile(&model, &error, &warning, path);
  CAPTURE(error, warning);
  REQUIRE(good);
  CHECK(error.empty());
  CHECK(warning.empty());
  return model;
}

std::size_t components(const tinygltf::Accessor& accessor) {
  return static_cast<std::size_t>(
      tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
}

std::vector<float> floats(const tinygltf::Model& model, int number) {
  const tinygltf::Accessor& accessor = model.accessors.at(static_cast<std::size_t>(number));
  REQUIRE(accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT);
  const tinygltf::BufferView& view = model.bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
  std::vector<float> out(accessor.count * components(accessor));
  std::memcpy(out.data(), model.buffers[0].data.data() + view.byteOffset + accessor.byteOffset,
              out.size() * sizeof(float));
  return out;
}

// Indices of a primitive.
std::vector<std::uint32_t> indices_of(const tinygltf::Model& model, const tinygltf::Primitive& part) {
  const tinygltf::Accessor& accessor = model.accessors.at(static_cast<std::size_t>(part.indices));
  REQUIRE(accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
  const tinygltf::BufferView& view = model.bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
  std::vector<std::uint32_t> out(accessor.count);
  std::memcpy(out.data(), model.buffers[0].data.data() + view.byteOffset + accessor.byteOffset,
              out.size() * sizeof(std::uint32_t));
  return out;
}

std::size_t node_of(const tinygltf::Model& model, const std::string& name) {
  for (std::size_t i = 0; i < model.nodes.size(); ++i)
    if (model.nodes[i].name == name) return i;
  FAIL("there is no node " << name);
  return 0;
}

// The values of the channel of a body, empty without one.
std::vector<float> channel(const tinygltf::Model& model, const std::string& body, const std::string& path) {
  const std::size_t node = node_of(model, body);
  for (const tinygltf::AnimationChannel& c : model.animations.at(0).channels) {
    if (static_cast<std::size_t>(c.target_node) == node && c.target_path == path)
      return floats(model, model.animations[0].samplers.at(static_cast<std::size_t>(c.sampler)).output);
  }
  return {};
}

}  // namespace

TEST_CASE("every accessor of a .glb lies in its buffer, with the bounds that it says") {
  const TempFolder folder;
  const auto scene = varied_scene();
  const std::string out = (folder / "a.glb").string();
  export_frames(out, *scene, frames_of(scene, 16, 30), {.trails = {{"ball"}, {}}});
  const tinygltf::Model model = loaded(out);
  REQUIRE(model.buffers.size() == 1);
  CHECK(model.asset.version == "2.0");
  std::size_t covered = 0;
  for (const tinygltf::BufferView& view : model.bufferViews) {
    CHECK(view.byteOffset == covered);  // one after the other, none left out
    covered = view.byteOffset + view.byteLength;
  }
  CHECK(covered == model.buffers[0].data.size());
  int bounded = 0;
  for (std::size_t i = 0; i < model.accessors.size(); ++i) {
    CAPTURE(i);
    const tinygltf::Accessor& accessor = model.accessors[i];
    const tinygltf::BufferView& view = model.bufferViews.at(static_cast<std::size_t>(accessor.bufferView));
    const std::size_t width = components(accessor);
    CHECK(accessor.count > 0);
    CHECK((view.byteOffset + accessor.byteOffset) % 4 == 0);
    CHECK(accessor.byteOffset + accessor.count * width * 4 <= view.byteLength);
    if (accessor.minValues.empty()) continue;
    ++bounded;
    const std::vector<float> values = floats(model, static_cast<int>(i));
    for (std::size_t k = 0; k < width; ++k) {
      float lo = values[k], hi = values[k];
      for (std::size_t at = k; at < values.size(); at += width) {
        lo = std::min(lo, values[at]);
        hi = std::max(hi, values[at]);
      }
      CHECK(static_cast<float>(accessor.minValues.at(k)) == lo);
      CHECK(static_cast<float>(accessor.maxValues.at(k)) == hi);
    }
  }
  CHECK(bounded > 8);
  for (const tinygltf::Mesh& mesh : model.meshes) {
    for (const tinygltf::Primitive& part : mesh.primitives) {
      CAPTURE(mesh.name);
      REQUIRE(part.material >= 0);
      const auto& positions = model.accessors.at(static_cast<std::size_t>(part.attributes.at("POSITION")));
      CHECK(positions.minValues.size() == 3);
      if (part.mode == TINYGLTF_MODE_LINE_STRIP) continue;
      const std::vector<std::uint32_t> indices = indices_of(model, part);
      CHECK(indices.size() % 3 == 0);
      for (const std::uint32_t index : indices) REQUIRE(index < positions.count);
      const std::vector<float> normals = floats(model, part.attributes.at("NORMAL"));
      REQUIRE(normals.size() == 3 * positions.count);
      for (std::size_t k = 0; k < normals.size(); k += 3)
        REQUIRE(Vec3f(normals[k], normals[k + 1], normals[k + 2]).norm() == Approx(1).margin(1e-5));
    }
  }
}

TEST_CASE("keys of a .glb are the poses of the run to the last bit of float") {
  const TempFolder folder;
  const auto scene = varied_scene();
  const auto frames = frames_of(scene, 31, 30);
  const std::string out = (folder / "a.glb").string();
  export_frames(out, *scene, frames, {});
  const tinygltf::Model model = loaded(out);
  REQUIRE(model.animations.size() == 1);
  const std::vector<float> times = floats(model, model.animations[0].samplers.at(0).input);
  REQUIRE(times.size() == frames.size());
  for (std::size_t k = 0; k < times.size(); ++k) CHECK(times[k] == static_cast<float>(k) / 30.0f);
  for (const auto& sampler : model.animations[0].samplers) CHECK(sampler.interpolation == "LINEAR");

  int turned = 0;
  for (Index i = 0; i < scene->model.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    CAPTURE(scene->model.name[at]);
    const auto move = channel(model, scene->model.name[at], "translation");
    const auto turn = channel(model, scene->model.name[at], "rotation");
    if (scene->model.fixed[at]) {
      CHECK(move.empty());
      CHECK(turn.empty());
      continue;
    }
    REQUIRE(move.size() == 3 * frames.size());
    for (std::size_t k = 0; k < frames.size(); ++k)
      for (std::size_t x = 0; x < 3; ++x)
        CHECK(move[3 * k + x] == static_cast<float>(frames[k].a().state->c[at][static_cast<int>(x)]));
    if (turn.empty()) continue;
    ++turned;
    for (std::size_t k = 0; k < frames.size(); ++k) {
      const float* q = &turn[4 * k];
      CHECK(rotation_error(frames[k].a().state->R[at], q[3], q[0], q[1], q[2]) < 4e-7);
      if (k == 0) continue;
      const float* p = &turn[4 * k - 4];
      CHECK(p[0] * q[0] + p[1] * q[1] + p[2] * q[2] + p[3] * q[3] > 0);  // the short way round
    }
  }
  CHECK(turned >= 5);
  const auto& post = model.nodes[node_of(model, "post")];
  CHECK(post.translation == std::vector<double>{3, 1, 0});
}

TEST_CASE("a hull and a compound in a .glb have their corners and enclose their volume") {
  const TempFolder folder;
  const auto scene = varied_scene();
  const std::string out = (folder / "a.glb").string();
  export_frames(out, *scene, frames_of(scene, 2, 30), {});
  const tinygltf::Model model = loaded(out);
  for (const Polyhedron& solid : polyhedra()) {
    const auto mesh = static_cast<std::size_t>(model.nodes[node_of(model, solid.name)].mesh);
    std::vector<Vec3> corners;
    for (const tinygltf::Primitive& part : model.meshes.at(mesh).primitives) {
      const std::vector<float> places = floats(model, part.attributes.at("POSITION"));
      for (const std::uint32_t index : indices_of(model, part))
        corners.push_back(Vec3f(&places.at(3 * index)).cast<double>());
    }
    check_surface(solid, corners, 1e-6);
  }
}

TEST_CASE("bodies alike share their triangles, and each has its colour") {
  const TempFolder folder;
  const auto scene = varied_scene();
  const std::string out = (folder / "a.glb").string();
  export_frames(out, *scene, frames_of(scene, 2, 30), {});
  const tinygltf::Model model = loaded(out);
  const auto mesh = [&](const char* body) -> const tinygltf::Mesh& {
    return model.meshes.at(static_cast<std::size_t>(model.nodes[node_of(model, body)].mesh));
  };
  const auto material = [&](const char* body, std::size_t part = 0) -> const tinygltf::Material& {
    return model.materials.at(static_cast<std::size_t>(mesh(body).primitives.at(part).material));
  };
  CHECK(mesh("crate").primitives[0].attributes == mesh("crate \"2\" é").primitives[0].attributes);
  CHECK(mesh("crate").primitives[0].indices == mesh("crate \"2\" é").primitives[0].indices);
  CHECK(mesh("crate").primitives[0].attributes != mesh("arm").primitives[0].attributes);
  // #336699 is (0.2, 0.4, 0.6) in sRGB.
  const auto& color = material("crate \"2\" é").pbrMetallicRoughness.baseColorFactor;
  for (const auto& [k, srgb] : {std::pair{0u, 0.2}, {1u, 0.4}, {2u, 0.6}})
    CHECK(color.at(k) == Approx(std::pow((srgb + 0.055) / 1.055, 2.4)).epsilon(1e-4));
  CHECK(color.at(3) == 0.5);
  CHECK(material("crate \"2\" é").alphaMode == "BLEND");
  CHECK(material("crate").alphaMode == "OPAQUE");
  REQUIRE(mesh("ball").primitives.size() == 2);
  for (std::size_t k = 0; k < 3; ++k)
    CHECK(material("ball", 1).pbrMetallicRoughness.baseColorFactor[k] ==
          Approx(0.35 * material("ball").pbrMetallicRoughness.baseColorFactor[k]));
}

TEST_CASE("a trail of a .glb goes through every place of its point") {
  const TempFolder folder;
  const auto scene = varied_scene();
  const auto frames = frames_of(scene, 12, 30);
  const std::string out = (folder / "a.glb").string();
  export_frames(out, *scene, frames, {.trails = {{"ball", Vec3(0.4, 0, 0)}}});
  const tinygltf::Model model = loaded(out);
  const auto& node = model.nodes[node_of(model, "trail of ball@0.4,0,0")];
  const auto& part = model.meshes.at(static_cast<std::size_t>(node.mesh)).primitives.at(0);
  CHECK(part.mode == TINYGLTF_MODE_LINE_STRIP);
  const auto path = floats(model, part.attributes.at("POSITION"));
  REQUIRE(path.size() == 3 * frames.size());
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const State& state = *frames[k].a().state;
    const Vec3 at = state.c[4] + 0.4 * state.R[4].col(0);
    for (int x = 0; x < 3; ++x)
      CHECK(path[3 * k + static_cast<std::size_t>(x)] == Approx(at[x]).margin(1e-6));
  }
}

TEST_CASE("the same run gives the same bytes, and what would be too large is refused before it begins") {
  const TempFolder folder;
  const auto scene = varied_scene();
  const auto frames = frames_of(scene, 4, 30);
  for (const char* suffix : {".glb", ".usda", ".npz"}) {
    CAPTURE(suffix);
    const auto a = folder / (std::string("a") + suffix), b = folder / (std::string("b") + suffix);
    export_frames(a.string(), *scene, frames, {});
    export_frames(b.string(), *scene, frames_of(scene, 4, 30), {});
    const std::string x = read_bytes(a), y = read_bytes(b);
    CHECK(x.size() > 1000);
    CHECK((x == y));
    const Caught again = caught([&] { export_frames(a.string(), *scene, frames, {}); });
    CHECK(again.kind == exists);
    export_frames(a.string(), *scene, frames, {.force = true});
    const auto large = folder / (std::string("large") + suffix);
    const Caught refused =
        caught([&] { make_exporter(large.string(), *scene, frames.front().a(), {.frames = 10'000'000}); });
    CHECK(refused.kind == bad_input);
    CHECK(refused.says("--fps"));
    CHECK_FALSE(std::filesystem::exists(large));
  }
}

TEST_CASE("frames of an export show the steps that pictures show") {
  const auto scene = varied_scene();
  const auto frames = frames_of(scene, 13, 25);
  LiveSource pictures(runs_of(Run(scene, 1, kNoPast)), FrameRange{0, 14, 25});
  for (const Frame& frame : frames) {
    const auto picture = pictures.next([] { return false; });
    REQUIRE(picture);
    CHECK(frame.number == picture->number);
    CHECK(same_bits(*frame.a().state, *picture->a().state));
  }
}

TEST_CASE("the format is that of the suffix, and a name without one is refused") {
  CHECK(export_format("a.glb").suffix == std::string(".glb"));
  for (const char* name : {"a.gltf", ".glb", "a", "", "-", "a.obj"}) {
    const Caught refused = caught([&] { export_format(name); });
    CHECK(refused.kind == bad_input);
    CHECK(refused.says(".usda"));
  }
}

}  // namespace pabd::test_gltf
