// SPDX-License-Identifier: MIT
// Moving the camera by hand does what the hand means: numbers, not pictures. Lengths in m, places in pixels.
#include "render/visual/camera_control.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "render/visual/camera_path.h"

namespace pabd::test_camera_control {

namespace {

constexpr Viewport kPort{680, 600};

// Poses of all kinds, the same in every run.
std::vector<CameraPose> poses() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-5, 5);
  std::vector<CameraPose> all = {
      {}, {{0, 9, 0}, {0, 1, 0}, {0, 0, -1}, 32}, {{2, 1, -7}, {2, 1, 0}, {0, 1, 0}, 60}};
  for (int k = 0; k < 20; ++k)
    all.push_back({{any(random), any(random), any(random)},
                   {any(random), any(random), any(random)},
                   {0, 1, 0},
                   20 + 8 * std::abs(any(random))});
  return all;
}

double pixels_between(const PixelPoint& a, double x, double y) { return std::hypot(a.x - x, a.y - y); }

CameraPose key_pose(const Vec3& target, double azimuth, double elevation, double distance) {
  CameraPose like;
  like.target = target;
  return at_angles(like, {azimuth, elevation}, distance);
}

}  // namespace

TEST_CASE("a ray through a pixel and back is that pixel") {
  for (const CameraPose& pose : poses()) {
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {340.0, 300.0}, {17.25, 590.5}, {679.0, 3.0}}) {
      const ViewRay ray = ray_through(pose, kPort, x, y);
      CHECK(ray.direction.norm() == Approx(1).epsilon(1e-14));
      for (const double reach : {0.1, 7.0, 300.0}) {
        const PixelPoint back = to_pixel(pose, kPort, ray.origin + reach * ray.direction);
        CHECK(pixels_between(back, x, y) < 1e-8);
        CHECK(back.depth > 0);
      }
    }
  }
}

TEST_CASE("pixels are those of the matrices that the picture is drawn with") {
  for (const CameraPose& pose : poses()) {
    const Camera camera = rounded(pose);
    const Mat4f clip = projection_matrix(camera, static_cast<float>(kPort.width / kPort.height), 0.1f, 100) *
                       view_matrix(camera);
    for (const Vec3f& p : {Vec3f(0, 0, 0), Vec3f(1, 2, -1), Vec3f(camera.target)}) {
      const Vec4f q = clip * p.homogeneous();
      if (q.w() < 0.5f) continue;
      const PixelPoint at = to_pixel(pose, kPort, p.cast<double>());
      // Single precision: a hundredth of a pixel.
      CHECK(at.x == Approx((0.5 + 0.5 * static_cast<double>(q.x() / q.w())) * kPort.width).margin(0.02));
      CHECK(at.y == Approx((0.5 - 0.5 * static_cast<double>(q.y() / q.w())) * kPort.height).margin(0.02));
    }
  }
}

TEST_CASE("a point in front, above and to the right appears there; one behind has no depth") {
  const CameraPose pose{{0, 0, 10}, {0, 0, 0}, {0, 1, 0}, 90};
  const PixelPoint p = to_pixel(pose, {200, 100}, {5, 2.5, 0});
  CHECK(p.x == Approx(125));  // half the height of the picture is 10 m there
  CHECK(p.y == Approx(37.5));
  CHECK(p.depth == Approx(10));
  CHECK(to_pixel(pose, {200, 100}, {0, 0, 11}).depth < 0);
}

TEST_CASE("panning takes along what is under the pointer") {
  for (CameraPose pose : poses()) {
    double x = 100, y = 420;
    const double depth = 0.7 * pose.distance();
    const ViewRay ray = ray_through(pose, kPort, x, y);
    const Vec3 grabbed = ray.origin + depth / -ray.direction.dot(axes_of(pose).back) * ray.direction;
    const double distance = pose.distance();
    for (int k = 0; k < 1000; ++k) {
      const double dx = 3 * std::sin(0.1 * k), dy = 2 * std::cos(0.13 * k);
      pose = pan(pose, kPort, dx, dy, depth);
      x += dx;
      y += dy;
    }
    CHECK(pixels_between(to_pixel(pose, kPort, grabbed), x, y) < 1e-6);
    CHECK(pose.distance() == Approx(distance).epsilon(1e-12));
  }
}

TEST_CASE("zooming leaves what is under the pointer where it is") {
  for (const CameraPose& pose : poses()) {
    const double x = 500, y = 111;
    for (const double depth : {0.0, 2.5}) {
      const ViewRay ray = ray_through(pose, kPort, x, y);
      const double reach = (depth > 0 ? depth : pose.distance()) / -ray.direction.dot(axes_of(pose).back);
      const Vec3 point = ray.origin + reach * ray.direction;
      for (const double factor : {1.1, 0.3, 40.0}) {
        const CameraPose near = zoom(pose, kPort, factor, x, y, depth);
        CHECK(pixels_between(to_pixel(near, kPort, point), x, y) < 1e-6);
        CHECK(near.distance() * factor == Approx(pose.distance()).epsilon(1e-12));
        CHECK((axes_of(near).back - axes_of(pose).back).norm() < 1e-9);
      }
    }
  }
}

TEST_CASE("zooming for ever neither reaches the target nor leaves the world; nonsense does nothing") {
  CameraPose in, out;
  for (int k = 0; k < 1000; ++k) {
    in = zoom(in, kPort, 1.2, 10, 10);
    out = zoom(out, kPort, 1 / 1.2, 10, 10);
  }
  CHECK(in.distance() > 0.9e-4);
  CHECK(out.distance() < 1.1e7);
  CHECK(zoom(in, kPort, 0, 10, 10).eye == in.eye);
  CHECK(zoom(in, kPort, -1, 10, 10).eye == in.eye);
}

TEST_CASE("orbiting keeps target and distance, turns by the angle asked for, and comes round") {
  for (const CameraPose& pose : poses()) {
    CameraPose turned = pose;
    for (int k = 0; k < 360; ++k) turned = orbit(turned, kPi / 180, 0);
    CHECK((turned.eye - pose.eye).norm() < 1e-9 * pose.distance());
    CHECK(turned.target == pose.target);
    const CameraPose up = orbit(orbit(pose, 0.3, 0), 0, 0.05);
    CHECK(up.distance() == Approx(pose.distance()).epsilon(1e-12));
    if (std::abs(angles_of(pose).elevation) > 1.4) continue;
    CHECK(angles_of(up).elevation - angles_of(pose).elevation == Approx(0.05));
    CHECK(std::remainder(angles_of(up).azimuth - angles_of(pose).azimuth - 0.3, 2 * kPi) ==
          Approx(0).margin(1e-12));
  }
  // To the right: an eye on +z goes towards +x.
  const CameraPose right = orbit({{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 45}, 0.5 * kPi, 0);
  CHECK((right.eye - Vec3(5, 0, 0)).norm() < 1e-12);
}

TEST_CASE("over the top the picture does not jump, and the way back is the way there") {
  const CameraPose start = key_pose({1, 2, 3}, 0.7, 0, 4);
  CameraPose pose = start;
  Mat3 before = Mat3::Zero();
  for (int k = 0; k < 4000; ++k) {
    pose = orbit(pose, 0, 5e-4);
    const CameraAxes axes = axes_of(pose);
    Mat3 now;
    now << axes.right, axes.up, axes.back;
    if (k > 0) CHECK((now - before).norm() < 2e-3);
    before = now;
  }
  CHECK(angles_of(pose).elevation == Approx(0.5 * kPi));
  CHECK((axes_of(pose).right - Vec3(std::cos(0.7), 0, -std::sin(0.7))).norm() < 1e-9);
  pose = orbit(pose, 0, -0.5 * kPi);
  CHECK((pose.eye - start.eye).norm() < 1e-9);
}

TEST_CASE("views along the axes") {
  const CameraPose pose{{3, 4, 5}, {1, 1, 1}, {0, 1, 0}, 40};
  const double d = pose.distance();
  const std::pair<AxisView, Vec3> expected[] = {{AxisView::front, {0, 0, 1}},
                                                {AxisView::back, {0, 0, -1}},
                                                {AxisView::right, {1, 0, 0}},
                                                {AxisView::left, {-1, 0, 0}},
                                                {AxisView::top, {0, 1, 0}},
                                                {AxisView::bottom, {0, -1, 0}},
                                                {AxisView::iso, Vec3(1, 1, 1).normalized()}};
  for (const auto& [side, direction] : expected) {
    const CameraPose seen = look_from(pose, side);
    CHECK((seen.eye - (pose.target + d * direction)).norm() < 1e-12);
    CHECK(seen.target == pose.target);
  }
  // Seen from above and below, x goes to the right.
  CHECK((axes_of(look_from(pose, AxisView::top)).right - Vec3::UnitX()).norm() < 1e-12);
  CHECK((axes_of(look_from(pose, AxisView::bottom)).right - Vec3::UnitX()).norm() < 1e-12);
}

TEST_CASE("a framed sphere fits into the picture and fills most of it") {
  for (const Viewport& port : {Viewport{680, 600}, Viewport{300, 900}}) {
    for (const CameraPose& pose : poses()) {
      const BoundingSphere sphere{{1, 2, 3}, 0.7};
      const CameraPose seen = frame_sphere(pose, port, sphere);
      CHECK((axes_of(seen).back - axes_of(pose).back).norm() < 1e-9);
      // The outline of a sphere of radius r at distance D lies asin(r/D) off the axis.
      const double outline = std::tan(std::asin(sphere.radius / seen.distance()));
      const double half = std::tan(seen.fov * kPi / 360) * std::min(1.0, port.width / port.height);
      CHECK(outline < half);
      CHECK(outline > 0.8 * half);
    }
  }
}

TEST_CASE("a path goes through its keys, stays at its ends, and its speed has no jumps") {
  const std::vector<CameraKey> keys = {{1, key_pose({0, 1, 0}, 0, 0.2, 8)},
                                       {2, key_pose({1, 1, 0}, 2, 0.6, 4)},
                                       {4.5, key_pose({1, 3, 1}, -2.5, 1.0, 9)},
                                       {5, key_pose({0, 1, 0}, -2, -0.3, 3)}};
  for (const CameraKey& key : keys) CHECK((camera_at(keys, key.time).eye - key.pose.eye).norm() < 1e-9);
  CHECK(camera_at(keys, 0).eye == keys.front().pose.eye);
  CHECK(camera_at(keys, 99).eye == keys.back().pose.eye);
  CHECK(camera_at({}, 1).eye == CameraPose{}.eye);
  const double dt = 1e-4;
  const auto velocity = [&](double t) -> Vec3 {
    return (camera_at(keys, t + dt).eye - camera_at(keys, t).eye) / dt;
  };
  for (double t = 1.001; t < 4.998; t += dt)
    REQUIRE((velocity(t) - velocity(t - dt)).norm() < 0.1);  // accelerations stay below 1000 m/s²
  // From azimuth 2 to −2.5 the short way is through π.
  CHECK(axes_of(camera_at(keys, 3.2)).back.z() < 0);
}

TEST_CASE("even motion stays even, equal keys stand still, nothing swings beyond its keys") {
  const std::vector<CameraKey> even = {{0, key_pose({0, 1, 0}, 0, 0.2, 5)},
                                       {1, key_pose({1, 1, 0}, 0.5, 0.2, 5)},
                                       {3, key_pose({3, 1, 0}, 1.5, 0.2, 5)}};
  for (double t = 0; t <= 3; t += 0.05) {
    const CameraPose pose = camera_at(even, t);
    CHECK((pose.target - Vec3(t, 1, 0)).norm() < 1e-12);
    CHECK(angles_of(pose).azimuth == Approx(0.5 * t).margin(1e-12));
    CHECK(pose.distance() == Approx(5));
  }
  const std::vector<CameraKey> hold = {{0, key_pose({0, 0, 0}, 0, 0, 5)},
                                       {1, key_pose({2, 0, 0}, 1, 0, 5)},
                                       {2, key_pose({2, 0, 0}, 1, 0, 5)},
                                       {3, key_pose({5, 0, 0}, 0, 0, 5)}};
  for (double t = 0; t <= 3; t += 0.01) {
    const CameraPose pose = camera_at(hold, t);
    if (t >= 1 && t <= 2) CHECK((pose.target - Vec3(2, 0, 0)).norm() < 1e-12);
    CHECK(angles_of(pose).azimuth < 1 + 1e-12);
    CHECK(pose.target.x() > -1e-12);
  }
}

TEST_CASE("of keys at the same time the last counts") {
  const std::vector<CameraKey> keys = {{0, key_pose({0, 0, 0}, 0, 0, 5)},
                                       {1, key_pose({9, 9, 9}, 0, 0, 5)},
                                       {1, key_pose({2, 0, 0}, 0, 0, 5)},
                                       {2, key_pose({4, 0, 0}, 0, 0, 5)}};
  CHECK((camera_at(keys, 1).target - Vec3(2, 0, 0)).norm() < 1e-12);
  CHECK((camera_at(keys, 0.5).target - Vec3(1, 0, 0)).norm() < 1e-12);
}

}  // namespace pabd::test_camera_control
