// SPDX-License-Identifier: MIT
// Meshes of bodies are closed, face outwards, lie where the shape is, and have its volume; a checker keeps all of it
// and is half dark.
#include "app/export/body_mesh.h"

#include <catch2/catch.hpp>

#include "render/visual/primitive_mesh.h"
#include "sim/body/shape_kind.h"
#include "tests/export/export_helpers.h"
#include "tests/support/tiny_model.h"

namespace pabd::test_body_mesh {

using namespace testing;

namespace {

Measures measure(const BodyMesh& mesh, const std::vector<std::uint32_t>& indices) {
  std::vector<Vec3> corners;
  for (const std::uint32_t index : indices) corners.push_back(mesh.positions.at(index).cast<double>());
  // Normals point to the side from which the corners go round anticlockwise.
  for (std::size_t k = 0; k < indices.size(); ++k) {
    const Vec3* of = &corners[k - k % 3];
    CHECK((of[1] - of[0]).cross(of[2] - of[0]).dot(mesh.normals.at(indices[k]).cast<double>()) > 0);
  }
  return testing::measure(corners);
}

MeshedBodies meshed(const Shape& shape, bool checker, int segments) {
  TinyModel tiny;
  tiny.add(shape, Vec3::Zero());
  BodyLook look;
  look.checker = checker;
  return mesh_bodies(tiny.model, {look}, segments);
}

}  // namespace

TEST_CASE("a mesh has the volume and the centre of its shape") {
  const std::vector<std::pair<Shape, double>> shapes = {
      {Box{{0.3, 0.5, 0.7}}, 1e-6},
      {Sphere{0.8}, 4e-3},
      {Capsule{0.3, 0.9}, 4e-3},
      {make_shape("cylinder", {0.4, 1.2}), 4e-3},
      {make_shape("cone", {0.5, 0.9}), 4e-3},
  };
  for (const auto& [shape, tolerance] : shapes) {
    for (const bool checker : {false, true}) {
      CAPTURE(kind_of(shape).name, checker);
      const MeshedBodies bodies = meshed(shape, checker, 96);
      REQUIRE(bodies.meshes.size() == 1);
      const BodyMesh& mesh = bodies.meshes[0];
      Measures all = measure(mesh, mesh.light);
      const Measures dark = measure(mesh, mesh.dark);
      const double light_area = all.area;
      all.volume += dark.volume;
      all.first_moment += dark.first_moment;
      const double volume = kind_of(shape).volume(shape);
      CHECK(all.volume == Approx(volume).epsilon(tolerance));
      CHECK(all.first_moment.norm() / volume < 2e-3 * bounding_radius(shape));
      CHECK(mesh.dark.empty() == !checker);
      // Eighths on both sides of each coordinate plane; a cone's flat side is on one side of its base.
      if (checker && kind_of(shape).name != "cone") CHECK(dark.area == Approx(light_area).epsilon(1e-4));
    }
  }
}

TEST_CASE("finer meshes are nearer to the round shape, and none reaches out of it") {
  double error = 1;
  for (const int segments : kSegments) {
    const BodyMesh mesh = meshed(Sphere{2}, false, segments).meshes.at(0);
    const double volume = measure(mesh, mesh.light).volume, exact = 4.0 / 3 * kPi * 8;
    CHECK(volume < exact);
    CHECK(1 - volume / exact < 0.5 * error);
    error = 1 - volume / exact;
    for (const Vec3f& p : mesh.positions) CHECK(p.norm() < 2.00001f);
  }
}

TEST_CASE("bodies alike have one mesh, and equal colours are one material") {
  TinyModel tiny;
  tiny.add_fixed(Plane{{0, 1, 0}, 0}, Vec3::Zero());
  for (int k = 0; k < 3; ++k) tiny.add(Box{{1, 1, 1}}, Vec3(0, 3.0 * k, 0));
  tiny.add(Box{{1, 1, 2}}, Vec3(9, 0, 0));
  std::vector<BodyLook> looks(5);
  for (const std::size_t k : {1u, 2u}) looks[k].color = Vec3(1, 0, 0);
  looks[3].color = Vec3(1, 0, 0);
  looks[3].opacity = 0.25;
  const MeshedBodies out = mesh_bodies(tiny.model, looks, 48);
  REQUIRE(out.bodies.size() == 5);
  CHECK(out.meshes.size() == 2);
  CHECK(out.bodies[0].mesh == kNoMesh);
  CHECK(out.bodies[1].mesh == out.bodies[3].mesh);
  CHECK(out.bodies[1].mesh != out.bodies[4].mesh);
  CHECK(out.bodies[1].material == out.bodies[2].material);
  CHECK(out.bodies[1].material != out.bodies[3].material);
  CHECK((out.materials[static_cast<std::size_t>(out.bodies[3].material)] == Vec4f(1, 0, 0, 0.25f)));
}

TEST_CASE("a plane is a square in it, beneath the middle, seen from above") {
  for (const Vec3& along : {Vec3(0, 1, 0), Vec3(1, 2, -0.5), Vec3(-1, 0, 0), Vec3(0, 0, 1)}) {
    const Plane plane{along.normalized(), -0.7};
    const Vec3 around(3, 4, 5);
    const BodyMesh mesh = plane_mesh(plane, around, 6);
    REQUIRE(mesh.positions.size() == 4);
    Vec3 middle = Vec3::Zero();
    for (const Vec3f& p : mesh.positions) {
      CHECK(plane.normal.dot(p.cast<double>()) == Approx(-0.7).margin(1e-5));
      middle += 0.25 * p.cast<double>();
    }
    CHECK((middle - around).cross(plane.normal).norm() < 1e-5);
    CHECK(measure(mesh, mesh.light).area == Approx(144));
  }
}

}  // namespace pabd::test_body_mesh
