// SPDX-License-Identifier: MIT
// Hulls as meshes: one mesh for equal hulls, closed and facing outwards, at the pose of the body.
#include <catch2/catch.hpp>

#include "render/visual/build_visual.h"
#include "sim/body/compound.h"
#include "sim/body/convex_hull.h"
#include "tests/support/tiny_model.h"

namespace pabd::test_hull_meshes {

TEST_CASE("a hull is drawn as its own triangles") {
  const Hull hull{make_hull({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 3}, {2, 1, 3}}).hull};
  REQUIRE(hull.data);
  TinyModel tiny;
  const Mat3 R = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  tiny.add(hull, {1, 2, 3}, R);
  tiny.add(hull, {5, 0, 0});
  VisualScene scene;
  build_visual(tiny.model, tiny.state, {}, {}, scene);
  REQUIRE(scene.meshes.size() == 1);
  const MeshInstances& drawn = scene.meshes[0];
  REQUIRE(drawn.instances.size() == 2);
  const MeshData& mesh = *drawn.mesh;
  REQUIRE(mesh.corners.size() == mesh.normals.size());

  // Volume of the triangles in the world: that of the hull, so they are closed and face outwards.
  const Mat4f& m = drawn.instances[0].transform;
  double volume = 0;
  for (std::size_t k = 0; k < mesh.corners.size(); k += 3) {
    Vec3f p[3];
    for (std::size_t j = 0; j < 3; ++j) {
      CHECK(mesh.corners[k + j].norm() < 1 + 1e-5f);
      p[j] = (m * mesh.corners[k + j].homogeneous()).head<3>() - Vec3f(1, 2, 3);
    }
    volume += p[0].dot(p[1].cross(p[2])) / 6;
    const Vec3f area = (mesh.corners[k + 1] - mesh.corners[k]).cross(mesh.corners[k + 2] - mesh.corners[k]);
    CHECK(area.normalized().dot(mesh.normals[k]) > 0.999f);
  }
  CHECK(volume == Approx(hull.data->volume).epsilon(1e-5));

  // The mesh is made once, and goes with its last body.
  const auto* before = drawn.mesh.get();
  build_visual(tiny.model, tiny.state, {}, {}, scene);
  REQUIRE(scene.meshes.size() == 1);
  CHECK(scene.meshes[0].mesh.get() == before);
  CHECK(scene.meshes[0].instances.size() == 2);
  TinyModel other;
  other.add(Sphere{1}, Vec3::Zero());
  build_visual(other.model, other.state, {}, {}, scene);
  CHECK(scene.meshes.empty());
}

TEST_CASE("a compound is drawn part by part, parts of one hull from one mesh") {
  const auto bar = [](const Vec3& half) {
    std::vector<Vec3> points;
    for (int k = 0; k < 8; ++k) {
      points.push_back(half.cwiseProduct(Vec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1)) +
                       Vec3(2, 0, 0));
    }
    return Hull{make_hull(points).hull};
  };
  const Hull x = bar({1, 0.1, 0.1}), y = bar({0.1, 1, 0.1});
  TinyModel tiny;
  const Mat3 R = Eigen::AngleAxisd(kPi / 2, Vec3::UnitZ()).toRotationMatrix();
  tiny.add(make_compound({x, y}), {1, 2, 3}, R);
  tiny.add(make_compound({x, y}), {5, 2, 3});
  VisualScene scene;
  build_visual(tiny.model, tiny.state, {}, {}, scene);
  REQUIRE(scene.meshes.size() == 2);
  for (const MeshInstances& mesh : scene.meshes) {
    REQUIRE(mesh.instances.size() == 2);
    CHECK((mesh.instances[0].transform.block<3, 1>(0, 3) - Vec3f(1, 2, 3)).norm() < 1e-5f);
    CHECK(mesh.instances[0].color == scene.meshes[0].instances[0].color);
  }
  // The long bar along x points along y once the body is turned.
  float top = 0;
  for (const Vec3f& corner : scene.meshes[0].mesh->corners) {
    top = std::max(top, (scene.meshes[0].instances[0].transform * corner.homogeneous()).y());
  }
  CHECK(top == Approx(3));
}

}  // namespace pabd::test_hull_meshes
