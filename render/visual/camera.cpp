// SPDX-License-Identifier: MIT
// Camera matrices.
//
//   e, t, u    eye, target, up direction                        Camera::eye, target, up   m, m, -
//   z          −(t − e)/‖t − e‖, x = u × z, y = z × x           axes of the eye frame
//   V          [x y z]ᵀ (p − e)                                 view_matrix
//   f          1 / tan(fov/2)                                   projection_matrix: diag(f/aspect, f, …)
//   D          ‖t − e‖; an orthographic camera has f/D for f, and no division by depth
//   σ          shift: added to x and y after the division
#include <algorithm>
#include <cassert>
#include <cmath>

#include "render/visual/visual_scene.h"

namespace pabd {
namespace {

constexpr float kFloatDegree = 3.14159265358979f / 180.0f;

// A unit vector across `v`.
Vec3f any_across(const Vec3f& v) {
  const Vec3f axis = std::abs(v.z()) < 0.9f ? Vec3f(0, 0, 1) : Vec3f(1, 0, 0);
  return v.cross(axis).normalized();
}

}  // namespace

float half_height(const Camera& camera) {
  const float slope = std::tan(0.5f * camera.fov * kFloatDegree);
  return camera.orthographic ? slope * std::max((camera.eye - camera.target).norm(), 1e-12f) : slope;
}

float studio_radius(const VisualScene& scene) {
  constexpr float kSeen = 0.8f;  // of half the picture's height
  const Camera& camera = scene.camera;
  const float distance = camera.orthographic ? 1 : (camera.eye - camera.target).norm();
  return std::max({scene.radius, kSeen * half_height(camera) * distance, 1e-6f});
}

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
  assert(aspect > 0 && near_plane < far_plane && (near_plane > 0 || camera.orthographic));
  const float f = 1.0f / half_height(camera);
  Mat4f p = Mat4f::Zero();
  p(0, 0) = f / aspect;
  p(1, 1) = f;
  if (camera.orthographic) {
    p(0, 3) = camera.shift.x();
    p(1, 3) = camera.shift.y();
    p(2, 2) = 2 / (near_plane - far_plane);
    p(2, 3) = (near_plane + far_plane) / (near_plane - far_plane);
    p(3, 3) = 1;
    return p;
  }
  p(0, 2) = -camera.shift.x();
  p(1, 2) = -camera.shift.y();
  p(2, 2) = (near_plane + far_plane) / (near_plane - far_plane);
  p(2, 3) = 2 * near_plane * far_plane / (near_plane - far_plane);
  p(3, 2) = -1;
  return p;
}

}  // namespace pabd
