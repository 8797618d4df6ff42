// SPDX-License-Identifier: MIT
// Meshes of the primitives: closed, facing outwards, on the true surface, with the right volume.
#include "render/visual/primitive_mesh.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>

namespace pabd::test_primitive_mesh {

namespace {

Vec3f position(const Mesh& mesh, std::size_t corner) {
  return Vec3f(mesh.vertices[mesh.indices[corner]].position);
}
Vec3f normal(const Mesh& mesh, std::size_t corner) {
  return Vec3f(mesh.vertices[mesh.indices[corner]].normal);
}

}  // namespace

TEST_CASE("triangles are counter-clockwise from outside and none is empty") {
  for (int kind = 0; kind < kPrimitiveCount; ++kind) {
    for (int level = 0; level < kLevels; ++level) {
      const Mesh mesh = make_mesh(static_cast<Primitive>(kind), level);
      REQUIRE(mesh.indices.size() % 3 == 0);
      bool outward = true;
      for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        const Vec3f area =
            (position(mesh, t + 1) - position(mesh, t)).cross(position(mesh, t + 2) - position(mesh, t));
        outward = outward && area.dot(normal(mesh, t)) > 0 && std::abs(normal(mesh, t).norm() - 1) < 1e-5f;
      }
      INFO("primitive " << kind << ", level " << level);
      CHECK(outward);
    }
  }
}

TEST_CASE("volumes are exactly those of the inscribed polyhedra") {
  // A regular n-gon has n/2π sin(2π/n) of its circle's area; so has a polyhedron of revolution of its solid,
  // which is a pile of frustums h π (a² + ab + b²)/3. Tolerance: single precision, and the cone's blunt tip
  // of 1e-4.
  const double pi = 3.14159265358979;
  for (int level = 0; level < kLevels; ++level) {
    const int n = kSegments[level];
    const double part = n / (2 * pi) * std::sin(2 * pi / n);
    double ball = 0;
    for (int j = 0; j < n / 2; ++j) {
      const double a = std::sin(2 * pi * j / n), b = std::sin(2 * pi * (j + 1) / n);
      const double h = std::cos(2 * pi * j / n) - std::cos(2 * pi * (j + 1) / n);
      ball += h * pi * (a * a + a * b + b * b) / 3;
    }
    struct Case {
      Primitive primitive;
      double volume;
    };
    for (const auto& [primitive, expected] :
         {Case{Primitive::cube, 8}, Case{Primitive::sphere, part * ball},
          Case{Primitive::cylinder, part * 2 * pi}, Case{Primitive::cone, part * pi / 3}}) {
      const Mesh mesh = make_mesh(primitive, level);
      double volume = 0;
      for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
        volume += position(mesh, t).dot(position(mesh, t + 1).cross(position(mesh, t + 2))) / 6.0;
      }
      INFO("primitive " << static_cast<int>(primitive) << ", level " << level);
      CHECK(volume == Approx(expected).epsilon(2e-4));
    }
  }
}

TEST_CASE("closed surfaces: the area vectors sum to zero; a hemisphere is open by its disc") {
  for (const Primitive primitive :
       {Primitive::cube, Primitive::sphere, Primitive::cylinder, Primitive::hemisphere, Primitive::disc}) {
    const Mesh mesh = make_mesh(primitive, 2);
    Vec3f sum = Vec3f::Zero();
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
      sum +=
          0.5f * (position(mesh, t + 1) - position(mesh, t)).cross(position(mesh, t + 2) - position(mesh, t));
    }
    const float n = static_cast<float>(kSegments[2]);
    const float disc = 0.5f * n * std::sin(2 * 3.14159265f / n);
    const Vec3f expected(0, primitive == Primitive::hemisphere ? disc : 0.0f, 0);
    INFO("primitive " << static_cast<int>(primitive));
    CHECK((sum - expected).norm() < 1e-4f);
  }
}

TEST_CASE("levels of detail keep outlines within a third of a pixel up to a quarter of a frame") {
  for (const float radius : {1.0f, 5.0f, 20.0f, 60.0f, 180.0f, 360.0f}) {
    const int level = level_for_radius(radius);
    const double error = radius * (1 - std::cos(3.14159265358979 / kSegments[level]));
    CHECK(error <= 0.3501);
    if (level > 0) {
      CHECK(radius * (1 - std::cos(3.14159265358979 / kSegments[level - 1])) >
            0.35);  // and is not finer than that needs
    }
  }
  CHECK(level_for_radius(1e9f) == kLevels - 1);
}

}  // namespace pabd::test_primitive_mesh
