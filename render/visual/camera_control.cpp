// SPDX-License-Identifier: MIT
// Moving a camera by hand.
//
//   e, t       eye, target                                     m
//   x, y, z    axes of the picture: right, up, back            unit
//   α, ε       azimuth, elevation: z = (sin α cos ε, sin ε, cos α cos ε), x = (cos α, 0, −sin α)
//   s          half the height of the picture at depth 1: tan(fov/2)
//   m          metres that a pixel spans at depth D: 2 s D / height
#include "render/visual/camera_control.h"

#include <algorithm>
#include <cmath>

namespace pabd {
namespace {

constexpr double kLeastDistance = 1e-4, kLargestDistance = 1e7;  // m
constexpr double kFrameMargin = 1.12;                            // air around what is framed
constexpr double kSteep = 89.9 * kPi / 180;  // from here on the vertical no longer says what is up

Vec3 any_across(const Vec3& v) {
  return v.cross(std::abs(v.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX()).normalized();
}

double slope_of(const CameraPose& pose) {
  return std::tan(0.5 * std::clamp(pose.fov, 0.1, 170.0) * kPi / 180);
}

double pixel_size(const CameraPose& pose, const Viewport& port, double depth) {
  return 2 * slope_of(pose) * (depth > 0 && !pose.orthographic ? depth : pose.distance()) / port.height;
}

}  // namespace

CameraPose precise(const Camera& camera) {
  return {camera.eye.cast<double>(), camera.target.cast<double>(), camera.up.cast<double>(),
          static_cast<double>(camera.fov), camera.orthographic};
}

Camera rounded(const CameraPose& pose) {
  Camera camera;
  camera.eye = pose.eye.cast<float>();
  camera.target = pose.target.cast<float>();
  camera.up = pose.up.cast<float>();
  camera.fov = static_cast<float>(pose.fov);
  camera.orthographic = pose.orthographic;
  return camera;
}

CameraAxes axes_of(const CameraPose& pose) {
  Vec3 back = pose.eye - pose.target;
  back = back.norm() > 1e-12 ? back.normalized() : Vec3(0, 0, 1);
  Vec3 right = pose.up.cross(back);
  right = right.norm() > 1e-6 * pose.up.norm() && right.norm() > 0 ? right.normalized() : any_across(back);
  return {right, back.cross(right), back};
}

ViewRay ray_through(const CameraPose& pose, const Viewport& port, double x, double y) {
  const CameraAxes axes = axes_of(pose);
  if (pose.orthographic) {
    const double pixel = pixel_size(pose, port, 0);
    return {
        pose.eye + pixel * (x - 0.5 * port.width) * axes.right + pixel * (0.5 * port.height - y) * axes.up,
        -axes.back};
  }
  const double pixel = 2 * slope_of(pose) / port.height;
  const Vec3 along =
      pixel * (x - 0.5 * port.width) * axes.right + pixel * (0.5 * port.height - y) * axes.up - axes.back;
  return {pose.eye, along.normalized()};
}

PixelPoint to_pixel(const CameraPose& pose, const Viewport& port, const Vec3& p) {
  const CameraAxes axes = axes_of(pose);
  const Vec3 q = p - pose.eye;
  const double depth = -q.dot(axes.back);
  const double pixel =
      pose.orthographic ? pixel_size(pose, port, 0) : 2 * slope_of(pose) * depth / port.height;
  return {0.5 * port.width + q.dot(axes.right) / pixel, 0.5 * port.height - q.dot(axes.up) / pixel, depth};
}

CameraAngles angles_of(const CameraPose& pose) {
  const CameraAxes axes = axes_of(pose);
  // The right axis knows the azimuth even where the eye is straight above.
  const double level = std::hypot(axes.back.x(), axes.back.z());
  const double elevation = std::atan2(axes.back.y(), level);
  return {std::abs(elevation) > kSteep ? std::atan2(-axes.right.z(), axes.right.x())
                                       : std::atan2(axes.back.x(), axes.back.z()),
          elevation};
}

CameraPose at_angles(const CameraPose& like, const CameraAngles& angles, double distance) {
  const double sa = std::sin(angles.azimuth), ca = std::cos(angles.azimuth);
  const double se = std::sin(angles.elevation), ce = std::cos(angles.elevation);
  CameraPose pose = like;
  pose.eye = like.target + distance * Vec3(sa * ce, se, ca * ce);
  pose.up = std::abs(angles.elevation) > kSteep ? Vec3(-se * sa, ce, -se * ca) : Vec3(0, 1, 0);
  return pose;
}

CameraPose orbit(const CameraPose& pose, double azimuth, double elevation) {
  CameraAngles angles = angles_of(pose);
  angles.azimuth += azimuth;
  angles.elevation = std::clamp(angles.elevation + elevation, -0.5 * kPi, 0.5 * kPi);
  return at_angles(pose, angles, pose.distance());
}

CameraPose pan(const CameraPose& pose, const Viewport& port, double dx, double dy, double depth) {
  const CameraAxes axes = axes_of(pose);
  const double pixel = pixel_size(pose, port, depth);
  const Vec3 shift = pixel * (dy * axes.up - dx * axes.right);
  CameraPose moved = pose;
  moved.eye += shift;
  moved.target += shift;
  return moved;
}

CameraPose zoom(const CameraPose& pose, const Viewport& port, double factor, double x, double y,
                double depth) {
  const double distance = pose.distance();
  if (!(factor > 0) || !(distance > 0)) return pose;
  const double share = std::clamp(distance / factor, kLeastDistance, kLargestDistance) / distance;
  const CameraAxes axes = axes_of(pose);
  const ViewRay ray = ray_through(pose, port, x, y);
  const double reach = (depth > 0 ? depth : distance) / -ray.direction.dot(axes.back);
  // Everything shrinks towards the point under the pointer, which therefore stays where it is seen.
  const Vec3 point = ray.origin + reach * ray.direction;
  CameraPose moved = pose;
  moved.eye = point + share * (pose.eye - point);
  moved.target = point + share * (pose.target - point);
  return moved;
}

CameraPose frame_sphere(const CameraPose& pose, const Viewport& port, const BoundingSphere& sphere) {
  const double s = slope_of(pose);
  const double narrow = std::min(s, s * port.width / port.height);
  CameraPose moved = pose;
  moved.target = sphere.centre;
  moved.eye = sphere.centre + kFrameMargin * sphere.radius /
                                  (pose.orthographic ? narrow : std::sin(std::atan(narrow))) *
                                  axes_of(pose).back;
  return moved;
}

CameraPose look_from(const CameraPose& pose, AxisView side) {
  constexpr double kQuarter = 0.5 * kPi;
  const auto angles = [&]() -> CameraAngles {
    switch (side) {
      case AxisView::front:
        return {0, 0};
      case AxisView::back:
        return {kPi, 0};
      case AxisView::right:
        return {kQuarter, 0};
      case AxisView::left:
        return {-kQuarter, 0};
      case AxisView::top:
        return {0, kQuarter};
      case AxisView::bottom:
        return {0, -kQuarter};
      case AxisView::iso:
        break;
    }
    return {0.5 * kQuarter, std::asin(1 / std::sqrt(3.0))};
  }();
  return at_angles(pose, angles, pose.distance());
}

}  // namespace pabd
