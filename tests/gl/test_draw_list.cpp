// SPDX-License-Identifier: MIT
// Sorting of instances into batches.
#include "render/gl/draw_list.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/gl/render_fixture.h"

namespace pabd::test_draw_list {

namespace {

std::vector<float> depths_of(const DrawList& list, const BatchRange& range) {
  std::vector<float> z;
  for (std::size_t b = range.begin; b < range.end; ++b) {
    for (std::uint32_t i = 0; i < list.batches[b].count; ++i) {
      z.push_back(list.instances[list.batches[b].first + i].rows[2][3]);
    }
  }
  return z;
}

}  // namespace

TEST_CASE("opaque bodies come near ones first, transparent ones far ones first") {
  VisualScene scene;
  scene.camera = front_camera(20);
  for (const float z : {1.0f, -3.0f, 4.0f, 0.0f}) {
    scene.instances[0].push_back(flat_instance({0, 0, z}, {1, 1, 1}, {1, 1, 1, 1}));
    scene.instances[0].push_back(flat_instance({0, 0, z}, {1, 1, 1}, {1, 1, 1, 0.5f}));
  }
  DrawList list;
  list.build(scene, 720, 0.01f);
  CHECK(depths_of(list, list.bodies) == std::vector<float>{4, 1, 0, -3});
  CHECK(depths_of(list, list.transparent) == std::vector<float>{-3, 0, 1, 4});
  CHECK(list.bodies.end - list.bodies.begin == 1);  // one batch for one mesh
  CHECK(depths_of(list, list.casters).empty());     // none of these casts a shadow
}

TEST_CASE("transparent batches end where the mesh changes, so that the order of depth survives") {
  VisualScene scene;
  scene.camera = front_camera(20);
  for (const float z : {0.0f, 2.0f}) {
    scene.instances[0].push_back(flat_instance({0, 0, z}, {1, 1, 1}, {1, 1, 1, 0.5f}));
    scene.instances[1].push_back(flat_instance({0, 0, z + 1}, {1, 1, 1}, {1, 1, 1, 0.5f}));
  }
  DrawList list;
  list.build(scene, 720, 0.01f);
  CHECK(depths_of(list, list.transparent) == std::vector<float>{0, 1, 2, 3});
  CHECK(list.transparent.end - list.transparent.begin == 4);
}

TEST_CASE("what cannot be drawn is left out; nothing is drawn twice") {
  VisualScene scene;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  scene.instances[0].push_back(flat_instance({nan, 0, 0}, {1, 1, 1}, {1, 1, 1, 1}));
  scene.instances[0].push_back(flat_instance({0, 0, 0}, {1, 1, 1}, {1, 1, 1, 0}));
  scene.instances[0].push_back(flat_instance({0, 0, 0}, {1, 1, 1}, {1, 1, 1, 1}));
  Instance glyph = flat_instance({0, 0, 0}, {1, 1, 1}, {1, 1, 1, 1});
  glyph.xray = true;
  scene.instances[5].push_back(glyph);
  DrawList list;
  list.build(scene, 720, 0.01f);
  CHECK(depths_of(list, list.bodies).size() == 1);
  CHECK(depths_of(list, list.glyphs).size() == 1);
  CHECK(list.instances.size() == 2);
}

TEST_CASE("each mesh has a batch of its own") {
  VisualScene scene;
  scene.camera = front_camera(20);
  scene.instances[0].push_back(flat_instance({0, 0, 0}, {1, 1, 1}, {1, 1, 1, 1}));
  for (int k = 0; k < 7; ++k) {  // more meshes than levels of detail
    scene.meshes.push_back({std::make_shared<MeshData>(), nullptr, {}});
    for (const float z : {1.0f, 2.0f})
      scene.meshes.back().instances.push_back(flat_instance({0, 0, z}, {1, 1, 1}, {1, 1, 1, 1}));
  }
  DrawList list;
  list.build(scene, 720, 0.01f);
  REQUIRE(list.meshes.size() == 7);
  REQUIRE(list.bodies.end - list.bodies.begin == 8);
  for (std::size_t k = 1; k < 8; ++k) {
    const Batch& batch = list.batches[list.bodies.begin + k];
    CHECK(batch.primitive == Primitive::mesh);
    CHECK(batch.level == static_cast<int>(k) - 1);
    CHECK(batch.count == 2);
    CHECK(list.meshes[k - 1] == scene.meshes[k - 1].mesh);
  }
  CHECK(list.instances.size() == 15);
}

}  // namespace pabd::test_draw_list
