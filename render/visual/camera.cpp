// SPDX-License-Identifier: MIT
// Camera matrices, and the camera that frames a scene.
//
//   e, t, u    eye, target, up direction                        Camera::eye, target, up   m, m, -
//   z          −(t − e)/‖t − e‖, x = u × z, y = z × x           axes of the eye frame
//   V          [x y z]ᵀ (p − e)                                 view_matrix
//   f          1 / tan(fov/2)                                   projection_matrix: diag(f/aspect, f, …)
#include <algorithm>
#include <cassert>
#include <cmath>

#include "render/visual/bounds.h"
#include "render/visual/build_visual.h"
#include "render/visual/visual_scene.h"

namespace pabd {
namespace {

constexpr float kDegree = 3.14159265358979f / 180.0f;

// The framing camera: seen from the left front, a little from above, with a calm focal length.
constexpr double kAzimuth = -26.0;   // about y from +z towards +x, degrees
constexpr double kElevation = 17.0;  // above the horizon, degrees
constexpr double kFov = 32.0;        // vertical, degrees
constexpr double kMargin = 1.12;     // air around the bodies

// A unit vector across `v`.
Vec3f any_across(const Vec3f& v) {
  const Vec3f axis = std::abs(v.z()) < 0.9f ? Vec3f(0, 0, 1) : Vec3f(1, 0, 0);
  return v.cross(axis).normalized();
}

// Extents of the bodies on one image axis as seen at `distance`, as tangents of the view angle; a sphere of
// radius r at (x, depth) touches the angles atan(x/depth) ± asin(r/‖(x, depth)‖).
struct Span {
  double lo = 1e30;
  double hi = -1e30;
  void add(double x, double depth, double r) {
    const double mid = std::atan2(x, depth);
    const double half = std::asin(std::min(0.99, r / std::hypot(x, depth)));
    lo = std::min(lo, std::tan(mid - half));
    hi = std::max(hi, std::tan(mid + half));
  }
};

}  // namespace

Mat4f view_matrix(const Camera& camera) {
  Vec3f z = camera.eye - camera.target;
  z = z.norm() > 1e-12f ? z.normalized() : Vec3f(0, 0, 1);
  Vec3f x = camera.up.cross(z);
  x = x.norm() > 1e-6f * camera.up.norm() && x.norm() > 0 ? x.normalized() : any_across(z);
  const Vec3f y = z.cross(x);
  Mat4f view = Mat4f::Identity();
  view.block<1, 3>(0, 0) = x.transpose();
  view.block<1, 3>(1, 0) = y.transpose();
  view.block<1, 3>(2, 0) = z.transpose();
  view.block<3, 1>(0, 3) = -(view.block<3, 3>(0, 0) * camera.eye);
  return view;
}

Mat4f projection_matrix(const Camera& camera, float aspect, float near_plane, float far_plane) {
  assert(aspect > 0 && near_plane > 0 && near_plane < far_plane);
  const float f = 1.0f / std::tan(0.5f * camera.fov * kDegree);
  Mat4f p = Mat4f::Zero();
  p(0, 0) = f / aspect;
  p(1, 1) = f;
  p(2, 2) = (near_plane + far_plane) / (near_plane - far_plane);
  p(2, 3) = 2 * near_plane * far_plane / (near_plane - far_plane);
  p(3, 2) = -1;
  return p;
}

Camera frame_camera(const Model& model, const State& state, double aspect) {
  Camera camera;
  const auto around = bounding_sphere(model, state);
  if (!around) return camera;

  const double azimuth = kAzimuth * kPi / 180;
  const double elevation = kElevation * kPi / 180;
  const Vec3 back(std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                  std::cos(azimuth) * std::cos(elevation));
  const Vec3 right = Vec3(0, 1, 0).cross(back).normalized();
  const Vec3 up = back.cross(right);
  const double tan_v = std::tan(0.5 * kFov * kPi / 180);
  const double tan_h = tan_v * aspect;

  // The bounding sphere fits for sure; the bodies themselves often leave room. Alternate between centring the
  // picture and moving the camera; a few rounds settle it.
  Vec3 target = around->centre;
  double distance = kMargin * around->radius / std::sin(std::atan(std::min(tan_v, tan_h)));
  for (int round = 0; round < 8; ++round) {
    Span h, v;
    for (Index i = 0; i < model.size(); ++i) {
      if (model.fixed[i] || !has_finite_pose(state, i)) continue;
      const Vec3 p = state.c[i] - target;
      const double r = bounding_radius(model.shape[i]);
      const double depth = std::max(distance - p.dot(back), 1.01 * r);
      h.add(p.dot(right), depth, r);
      v.add(p.dot(up), depth, r);
    }
    if (h.lo > h.hi) break;  // nothing moves: keep the frame of the sphere
    target += distance * (0.5 * (h.lo + h.hi) * right + 0.5 * (v.lo + v.hi) * up);
    const double fill = std::max(0.5 * (h.hi - h.lo) / tan_h, 0.5 * (v.hi - v.lo) / tan_v);
    distance *= std::clamp(kMargin * fill, 0.5, 2.0);
  }

  camera.target = target.cast<float>();
  camera.eye = (target + distance * back).cast<float>();
  camera.up = Vec3f(0, 1, 0);
  camera.fov = static_cast<float>(kFov);
  return camera;
}

}  // namespace pabd
