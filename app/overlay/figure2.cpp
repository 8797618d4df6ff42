// SPDX-License-Identifier: MIT
// Figure 2 of the supplement. The machines are drawn part by part; their bond points come from real joints.
//
//   λ   offset of the carriage along the rail    m
//   θ   opening angle of the hinge               rad
#include "app/overlay/figure2.h"

#include <algorithm>
#include <cmath>

#include "render/visual/contact_glyphs.h"
#include "render/visual/joint_glyphs.h"
#include "render/visual/line_shapes.h"
#include "render/visual/palette.h"
#include "sim/math/so3.h"

namespace pabd {
namespace {

constexpr double kFov = 24;          // degrees
constexpr double kHalfWidth = 3.95;  // m that must be in sight to either side
constexpr double kPlace = 2.75;      // m between the machines
constexpr double kLambda = 0.42;     // m
constexpr double kTheta = 2.15;      // rad

Vec4f ink_i() { return srgb_color(0x7d9db3); }
Vec4f ink_j() { return srgb_color(0xc8775c); }
Vec4f ink_dark() { return srgb_color(0x1f2933); }

// One body: parts placed in its frame.
struct Body {
  VisualScene& scene;
  Pose pose;
  Vec4f color;

  Vec3 at(const Vec3& local) const { return pose.c + pose.R * local; }
  void put(Primitive primitive, const Mat4f& transform) const {
    scene.instances[static_cast<int>(primitive)].push_back({transform, color});
  }
  void box(const Vec3& local, const Vec3& half) const {
    Mat4f m = Mat4f::Identity();
    m.block<3, 3>(0, 0) = (pose.R * half.asDiagonal()).cast<float>();
    m.block<3, 1>(0, 3) = at(local).cast<float>();
    put(Primitive::cube, m);
  }
  // A solid of revolution about `axis` (unit, body frame).
  void round(Primitive primitive, const Vec3& local, const Vec3& axis, double radius, double height) const {
    put(primitive, place_along(at(local), pose.R * axis, radius, height));
  }
};

// An arrow head with its tip at `tip`.
void add_head(VisualScene& scene, const Vec3& tip, const Vec3& direction) {
  constexpr double kLength = 0.13, kRadius = 0.045;
  const Vec3 n = direction.normalized();
  scene.instances[static_cast<int>(Primitive::cone)].push_back(
      {place_along(tip - kLength * n, n, kRadius, kLength), ink_dark(), false, false});
}

// A bent double arrow about c: from one angle to the other in the plane of u and w.
void add_turn(VisualScene& scene, const Vec3& c, const Vec3& u, const Vec3& w, double radius, double from,
              double to) {
  const auto point = [&](double t) -> Vec3 { return c + radius * (std::cos(t) * u + std::sin(t) * w); };
  const auto tangent = [&](double t) -> Vec3 { return -std::sin(t) * u + std::cos(t) * w; };
  const double head = 0.1 / radius;  // the line ends inside the heads
  add_arc(scene, c, u, w, radius, from + head, to - head, {ink_dark(), 2.6, false});
  add_head(scene, point(from), -tangent(from + head));
  add_head(scene, point(to), tangent(to - head));
}

Joint joint_of(JointType type, const Pose& i, const Pose& j, const Vec3& anchor, const Vec3& axis,
               const Vec3& zero, double arm) {
  Joint joint;
  joint.type = type;
  joint.arm = arm;
  Mat3 F;
  F.col(0) = axis;
  F.col(1) = zero;
  F.col(2) = axis.cross(zero);
  joint.on_i = {i.R.transpose() * (anchor - i.c), i.R.transpose() * F};
  joint.on_j = {j.R.transpose() * (anchor - j.c), j.R.transpose() * F};
  return joint;
}

void add_text(VisualScene& scene, const Vec3& at, const char* text, float size = 19) {
  scene.labels.push_back({at.cast<float>(), text, size});
}

// The axis of a joint on body j, as an arrow from `from`; `aside`: where its name stands beside the head.
void add_normal(VisualScene& scene, const Vec3& from, const Vec3& n, const Vec3& aside) {
  constexpr double kLength = 0.42;
  add_line(scene, from, from + (kLength - 0.1) * n, {ink_dark(), 2.6, false});
  add_head(scene, from + kLength * n, n);
  add_text(scene, from + kLength * n + aside, "*{n}_{j}");
}

void add_name(VisualScene& scene, double x, const char* name, const char* freedom) {
  // Nearer to the eye than what they name, and in the same column of the picture.
  const Vec3f eye = scene.camera.eye, forward = (scene.camera.target - eye).normalized();
  const auto below = [&](double z) -> Vec3 {
    const auto depth = [&](double at) {
      return static_cast<double>((Vec3f(0, 0, static_cast<float>(at)) - eye).dot(forward));
    };
    return {x * depth(z) / depth(0), 0, z};
  };
  add_text(scene, below(1.0), name, 25);
  add_text(scene, below(1.42), freedom, 17);
}

void add_slider(VisualScene& scene, double x) {
  const double height = 0.62;
  const Pose rail{{x, height, 0}, Mat3::Identity()};
  const Pose carriage{{x + kLambda, height, 0}, Mat3::Identity()};
  const Joint joint = joint_of(JointType::slider, rail, rail, rail.c, Vec3::UnitX(), Vec3::UnitY(), 0.19);

  const Body i{scene, carriage, ink_i()}, j{scene, rail, ink_j()};
  i.box(Vec3::Zero(), {0.42, 0.25, 0.27});
  j.box(Vec3::Zero(), {1.15, 0.11, 0.11});
  for (const double side : {-1.0, 1.0}) j.box({1.03 * side, -0.5 * height, 0}, {0.12, 0.5 * height, 0.24});
  add_joint_glyphs(joint, carriage, rail, 0, {0.05, 0.55}, scene);

  const Vec3 above = carriage.c + Vec3(0, 0.45, 0);
  add_line(scene, above - Vec3(0.4, 0, 0), above + Vec3(0.4, 0, 0), {ink_dark(), 2.6, false});
  add_head(scene, above - Vec3(0.5, 0, 0), {-1, 0, 0});
  add_head(scene, above + Vec3(0.5, 0, 0), {1, 0, 0});
  add_text(scene, carriage.c + Vec3(0.55, 0.27, 0), "*{i}");
  add_text(scene, rail.c + Vec3(-0.78, 0.27, 0), "*{j}");
  add_text(scene, above + Vec3(0, 0.16, 0), "*{λ}");
  add_normal(scene, rail.c + Vec3(1.15, 0, 0), Vec3::UnitX(), Vec3(0.05, 0.16, 0));
  add_text(scene, carriage.c + Vec3(0.1, -0.42, 0.28), "*{y}_{i1}, *{y}_{j1}", 18);
  add_name(scene, x, "slider", "one translation");
}

void add_hinge(VisualScene& scene, double x) {
  const double height = 1.25, radius = 0.1, leaf = 0.95;
  const Vec3 up = Vec3::UnitY();
  const Vec3 anchor(x, 0.5 * height, 0);
  // At θ = 0 both leaves point along `zero`.
  const Mat3 turn_i = exp_so3({0, -0.5 * (kTheta + kPi), 0});
  const Pose left{anchor, turn_i};
  const Pose right{anchor, exp_so3({0, kTheta, 0}) * turn_i};
  const Vec3 zero = left.R * Vec3::UnitX();
  const Joint joint = joint_of(JointType::hinge, left, {anchor, turn_i}, anchor, up, zero, 0.44);

  const Body i{scene, left, ink_i()}, j{scene, right, ink_j()};
  const double knuckle = height / 10;  // half height of one of five
  for (const Body* body : {&i, &j}) {
    body->box({0.5 * leaf + 0.6 * radius, 0, 0}, {0.5 * leaf, 0.5 * height, 0.045});
  }
  for (int k = -2; k <= 2; ++k) {
    const Body& body = k % 2 == 0 ? i : j;
    body.round(Primitive::cylinder, {0, 2 * k * knuckle, 0}, up, radius, 0.96 * knuckle);
  }
  add_joint_glyphs(joint, left, right, 0, {0.05, 0.3}, scene);

  const Vec3 top(x, height + 0.16, 0);
  add_turn(scene, top, zero, up.cross(zero), 0.52, 0.12, kTheta - 0.12);
  add_text(scene, top + Vec3(0.3, 0.13, 0), "*{θ}");
  add_normal(scene, top, up, Vec3(0.14, 0, 0));
  add_text(scene, anchor + Vec3(0.3, 0.44, 0.1), "*{y}_{i1}, *{y}_{j1}", 18);
  add_text(scene, anchor + Vec3(0.3, -0.44, 0.1), "*{y}_{i2}, *{y}_{j2}", 18);
  add_text(scene, i.at({0.62 * leaf, 0.12, 0.1}), "*{i}");
  add_text(scene, j.at({0.62 * leaf, 0.12, 0.1}), "*{j}");
  add_name(scene, x, "hinge", "one rotation");
}

void add_spherical(VisualScene& scene, double x) {
  const double ball = 0.25, cup = 0.32;
  const Vec3 anchor(x, 0.72, 0);
  const Pose post{anchor, Mat3::Identity()};
  const Pose rod{anchor, exp_so3({0.3, 0, -0.45})};
  const Joint joint = joint_of(JointType::spherical, post, rod, anchor, Vec3::UnitY(), Vec3::UnitX(), 0.2);

  const Body i{scene, post, ink_i()}, j{scene, rod, ink_j()};
  i.round(Primitive::sphere, Vec3::Zero(), Vec3::UnitY(), ball, ball);
  i.round(Primitive::cylinder, {0, -0.39, 0}, Vec3::UnitY(), 0.09, 0.29);
  i.round(Primitive::cylinder, {0, -0.67, 0}, Vec3::UnitY(), 0.4, 0.05);
  j.round(Primitive::hemisphere, Vec3::Zero(), Vec3::UnitY(), cup, cup);
  j.round(Primitive::disc, Vec3::Zero(), Vec3::UnitY(), cup, 1);
  j.round(Primitive::cylinder, {0, 0.62, 0}, Vec3::UnitY(), 0.085, 0.36);
  add_joint_glyphs(joint, post, rod, 0, {0.05, 0.4}, scene);

  // One arrow around the rod, two along the ways in which it tilts.
  const Vec3 along = rod.R.col(1);
  add_turn(scene, j.at({0, 0.6, 0}), rod.R.col(0), -rod.R.col(2), 0.24, -3.6, 0.5);
  for (const Vec3& across : {Vec3(rod.R.col(0)), Vec3(rod.R.col(2))}) {
    add_turn(scene, anchor, along, across, 1.14, -0.38, 0.38);
  }
  add_text(scene, i.at({0.3, -0.5, 0}), "*{i}");
  add_text(scene, j.at({0.47, 0.1, 0}), "*{j}");
  add_text(scene, anchor + Vec3(-0.62, 0.04, 0), "*{y}_{i0}, *{y}_{j0}", 18);
  add_name(scene, x, "spherical", "three rotations");
}

}  // namespace

VisualScene figure2(double aspect) {
  VisualScene scene;
  const double slope = std::tan(0.5 * kFov * kPi / 180);
  const double distance = std::max(8.4, kHalfWidth / (slope * aspect));
  const Vec3 target(0, 0.58, 0.35);
  scene.camera.target = target.cast<float>();
  scene.camera.eye = (target + distance * Vec3(0, std::sin(0.36), std::cos(0.36))).cast<float>();
  scene.camera.fov = static_cast<float>(kFov);
  scene.grounds.push_back({});
  scene.centre = {0, 0.7f, 0};
  scene.radius = static_cast<float>(kHalfWidth);
  add_slider(scene, -kPlace + 0.1);
  add_hinge(scene, 0);
  add_spherical(scene, kPlace);
  return scene;
}

}  // namespace pabd
