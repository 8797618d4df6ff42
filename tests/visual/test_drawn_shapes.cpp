// SPDX-License-Identifier: MIT
// Drawing and outline of every shape that is given by its sizes, against rays: what is drawn lies on its
// surface, and the outline is where rays from the eye begin to miss it.
#include <catch2/catch.hpp>
#include <random>

#include "render/visual/build_visual.h"
#include "render/visual/outline.h"
#include "sim/body/shape_kind.h"
#include "sim/collision/ray_cast.h"
#include "tests/support/draws.h"
#include "tests/support/tiny_model.h"

namespace pabd::test_drawn_shapes {

namespace {

std::vector<Shape> sized_shapes() {
  std::vector<Shape> out;
  for (const ShapeKind* kind : shape_kinds())
    if (kind->make) out.push_back(kind->make({0.4, 0.9, 0.7}));
  return out;
}

const Pose kPose{{0.3, 0.2, -0.1}, Eigen::AngleAxisd(0.8, Vec3(1, 2, 0.5).normalized()).toRotationMatrix()};

Vec3 random_direction(std::mt19937& generator) {
  std::normal_distribution<double> normal;
  return testing::draw_vector([&] { return normal(generator); }).normalized();
}

// Points of the surface of a primitive.
std::vector<Vec3f> points_of(Primitive primitive) {
  std::vector<Vec3f> out;
  for (int k = 0; k < 16; ++k) {
    const float a = static_cast<float>(2 * kPi * k / 16), x = std::cos(a), z = std::sin(a);
    switch (primitive) {
      case Primitive::cube:
        out.insert(out.end(), {{1, x, z}, {x, -1, z}, {x, z, 1}});
        break;
      case Primitive::sphere:
        out.insert(out.end(), {{x, 0, z}, {0, x, z}});
        break;
      case Primitive::hemisphere:
        out.insert(out.end(), {{0.6f * x, 0.8f, 0.6f * z}, {0, 1, 0}});
        break;
      case Primitive::cylinder:
        out.insert(out.end(), {{x, 1, z}, {x, 0.3f, z}, {x, -1, z}});
        break;
      case Primitive::cone:
        out.insert(out.end(), {{x, 0, z}, {0.5f * x, 0.5f, 0.5f * z}, {0, 1, 0}});
        break;
      case Primitive::disc:
      case Primitive::mesh:
        break;
    }
  }
  return out;
}

}  // namespace

TEST_CASE("what is drawn of a shape lies on its surface: a ray from outside meets it there") {
  for (const Shape& shape : sized_shapes()) {
    INFO(kind_of(shape).name);
    TinyModel tiny;
    tiny.add(shape, kPose.c, kPose.R);
    VisualScene scene;
    build_visual(tiny.model, tiny.state, {}, {}, scene);
    int count = 0;
    for (int kind = 0; kind < kPrimitiveCount; ++kind) {
      for (const Instance& instance : scene.instances[kind]) {
        CHECK(instance.transform.block<3, 3>(0, 0).determinant() > 0);  // not mirrored
        for (const Vec3f& p : points_of(static_cast<Primitive>(kind))) {
          const Vec3 x = (instance.transform * p.homogeneous()).head<3>().cast<double>();
          const Vec3 out = (x - kPose.c).normalized();
          const auto hit = ray_cast(shape, kPose.c, kPose.R, {x + 5 * out, -out});
          REQUIRE(hit);
          CHECK(hit->t == Approx(5).margin(1e-5));
          ++count;
        }
      }
    }
    CHECK(count >= 32);
  }
}

TEST_CASE("the outline of a shape is where rays from the eye begin to miss it, and it is whole") {
  std::mt19937 generator(4);
  for (const Shape& shape : sized_shapes()) {
    for (int view = 0; view < 40; ++view) {
      INFO(kind_of(shape).name << ", view " << view);
      // Some eyes on the axis and in the planes of the flat ends.
      Vec3 direction = random_direction(generator);
      if (view < 2) direction = (view == 0 ? 1 : -1) * kPose.R.col(1);
      const Vec3 eye = kPose.c + 4 * direction;
      VisualScene scene;
      scene.camera.eye = eye.cast<float>();
      scene.camera.target = kPose.c.cast<float>();
      add_outline(shape, kPose, scene);
      const Vec3 from = scene.camera.eye.cast<double>();
      REQUIRE_FALSE(scene.lines.empty());
      const auto hits = [&](const Vec3& x) {
        return ray_cast(shape, kPose.c, kPose.R, {from, x - from}).has_value();
      };
      const Vec3 v = (from - kPose.c).normalized();
      // In the plane through the centre across the line of sight, as the eye sees it.
      const auto seen = [&](const Vec3& x) -> Vec3 {
        const Vec3 ray = x - from;
        return from + ray * ((kPose.c - from).dot(v) / ray.dot(v)) - kPose.c;
      };
      for (const Line& line : scene.lines) {
        const Vec3 middle = seen(0.5 * (line.a + line.b).cast<double>());
        CHECK(hits(kPose.c + 0.98 * middle));
        CHECK_FALSE(hits(kPose.c + 1.02 * middle));
      }
      const Vec3 a = v.unitOrthogonal(), b = v.cross(a);
      for (int k = 0; k < 48; ++k) {
        const Vec3 outward = std::cos(2 * kPi * k / 48) * a + std::sin(2 * kPi * k / 48) * b;
        double in = 0, out = 3;
        for (int i = 0; i < 40; ++i) {
          const double middle = 0.5 * (in + out);
          (hits(kPose.c + middle * outward) ? in : out) = middle;
        }
        const Vec3 edge = in * outward;
        double nearest = 1e9;
        for (const Line& line : scene.lines) {
          const Vec3 p = seen(line.a.cast<double>()), q = seen(line.b.cast<double>()), e = q - p;
          const double t = std::clamp(e.dot(edge - p) / std::max(e.squaredNorm(), 1e-18), 0.0, 1.0);
          nearest = std::min(nearest, (p + t * e - edge).norm());
        }
        CHECK(nearest < 0.01);
      }
    }
  }
}

}  // namespace pabd::test_drawn_shapes
