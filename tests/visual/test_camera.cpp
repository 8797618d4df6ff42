// SPDX-License-Identifier: MIT
// Camera matrices against closed forms; the framing camera against what it promises.
#include <catch2/catch.hpp>
#include <cmath>

#include "render/visual/build_visual.h"
#include "tests/support/tiny_model.h"

namespace pabd::test_camera {

namespace {

Vec3f to_ndc(const Camera& camera, float aspect, const Vec3f& p) {
  const Vec4f eye = view_matrix(camera) * Vec4f(p.x(), p.y(), p.z(), 1);
  const Vec4f clip = projection_matrix(camera, aspect, 0.1f, 1000.0f) * eye;
  return clip.head<3>() / clip.w();
}

}  // namespace

TEST_CASE("view matrix of a camera on the z axis is a translation") {
  Camera camera;
  camera.eye = {1, 2, 10};
  camera.target = {1, 2, 0};
  Mat4f expected = Mat4f::Identity();
  expected.block<3, 1>(0, 3) = Vec3f(-1, -2, -10);
  CHECK((view_matrix(camera) - expected).norm() < 1e-6f);
}

TEST_CASE("view matrix is a rigid motion that puts the target on the axis, for degenerate cameras too") {
  Camera camera;
  const Vec3f eyes[] = {
      {6, 4, 8}, {0, 9, 0}, {0, 1, 0}, {-3, -2, 1}};  // usual, along up, in the target, from below
  for (const Vec3f& eye : eyes) {
    camera.eye = eye;
    const Mat4f view = view_matrix(camera);
    const Eigen::Matrix3f r = view.block<3, 3>(0, 0);
    CHECK((r * r.transpose() - Eigen::Matrix3f::Identity()).norm() < 1e-5f);
    CHECK(r.determinant() == Approx(1).margin(1e-5));
    const Vec3f seen = (view * camera.target.homogeneous()).head<3>();
    const float distance = (camera.target - eye).norm();
    CHECK((seen - Vec3f(0, 0, -distance)).norm() < 1e-5f);
  }
}

TEST_CASE("projection matches the closed form") {
  Camera camera;
  camera.fov = 60;
  const float n = 0.5f, f = 20.0f, aspect = 2.0f;
  const Mat4f p = projection_matrix(camera, aspect, n, f);
  const float cot = std::sqrt(3.0f);
  CHECK(p(0, 0) == Approx(cot / aspect));
  CHECK(p(1, 1) == Approx(cot));
  const Vec4f near_point = p * Vec4f(0, 0, -n, 1);
  const Vec4f far_point = p * Vec4f(0, 0, -f, 1);
  CHECK(near_point.z() / near_point.w() == Approx(-1).margin(1e-5));
  CHECK(far_point.z() / far_point.w() == Approx(1).margin(1e-5));
  // A point half way up the half-angle's tangent lands half way up the frame.
  const Vec4f half = p * Vec4f(0, 0.5f / cot * 4, -4, 1);
  CHECK(half.y() / half.w() == Approx(0.5));
}

TEST_CASE("frame_camera centres one sphere and leaves the promised margin") {
  TinyModel tiny;
  tiny.add(Sphere{0.7}, {3, 5, -2});
  const float aspect = 16.0f / 9.0f;
  const Camera camera = frame_camera(tiny.model, tiny.state, aspect);
  CHECK((camera.target - Vec3f(3, 5, -2)).norm() < 0.02f);
  // Vertical half angle of the sphere: asin(r / distance), margin 1.12 in the tangent (2 % tolerance:
  // rounds).
  const float distance = (camera.eye - camera.target).norm();
  const float fill = std::tan(std::asin(0.7f / distance)) / std::tan(0.5f * camera.fov * 3.14159265f / 180);
  CHECK(fill == Approx(1 / 1.12).epsilon(0.02));
}

TEST_CASE("frame_camera keeps every body inside, tight on one axis, for wide and tall frames") {
  TinyModel tiny;
  for (int i = 0; i < 20; ++i) tiny.add(Box{{0.5, 0.25, 0.25}}, {1.1 * i, 0.5, 0.1 * i});
  for (const float aspect : {16.0f / 9.0f, 0.6f}) {
    const Camera camera = frame_camera(tiny.model, tiny.state, aspect);
    float widest = 0;
    for (const Vec3& c : tiny.state.c) {
      const Vec3f ndc = to_ndc(camera, aspect, c.cast<float>());
      widest = std::max({widest, std::abs(ndc.x()), std::abs(ndc.y())});
    }
    CHECK(widest < 0.93f);
    CHECK(widest > 0.75f);
  }
}

TEST_CASE("frame_camera survives scenes with nothing in them and bodies at infinity") {
  TinyModel tiny;
  tiny.add_fixed(Plane{{0, 1, 0}, 0}, Vec3::Zero());
  CHECK(frame_camera(tiny.model, tiny.state, 1.5).eye.allFinite());
  tiny.add(Sphere{1}, Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  tiny.add(Sphere{1}, Vec3(0, 1, 0));
  const Camera camera = frame_camera(tiny.model, tiny.state, 1.5);
  CHECK(camera.eye.allFinite());
  CHECK((camera.target - Vec3f(0, 1, 0)).norm() < 0.05f);
}

}  // namespace pabd::test_camera
