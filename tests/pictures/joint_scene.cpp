// SPDX-License-Identifier: MIT
#include "tests/pictures/joint_scene.h"

#include "sim/body/mass_properties.h"
#include "sim/joint/attach.h"
#include "sim/math/so3.h"

namespace pabd {

Index JointScene::add(const char* name, const Shape& shape, const Vec3& c, bool fixed) {
  const MassProperties mass = fixed ? MassProperties{0, Mat3::Zero()} : mass_properties(shape, 1000);
  model.name.emplace_back(name);
  model.shape.push_back(shape);
  model.mass.push_back(mass.mass);
  model.J.push_back(mass.J);
  model.fixed.push_back(fixed ? 1 : 0);
  state.c.push_back(c);
  state.R.push_back(Mat3::Identity());
  state.v.push_back(Vec3::Zero());
  state.omega.push_back(Vec3::Zero());
  return model.size() - 1;
}

Joint& JointScene::join(JointType type, Index i, Index j, const Vec3& anchor, const Vec3& axis, double arm) {
  Joint joint;
  joint.type = type;
  joint.i = i;
  joint.j = j;
  joint.arm = arm;
  attach(state, anchor, frame_about(axis), joint);
  model.joints.push_back(joint);
  return model.joints.back();
}

void JointScene::turn(Index body, const Vec3& p, const Vec3& axis, double angle) {
  const Mat3 R = exp_so3(angle * axis);
  state.c[body] = p + R * (state.c[body] - p);
  state.R[body] = R * state.R[body];
}

JointScene joint_scene() {
  JointScene s;
  const Vec3 x = Vec3::UnitX(), z = Vec3::UnitZ();
  s.add("ground", Plane{{0, 1, 0}, 0}, Vec3::Zero(), true);

  // Hinge with limits, at −35° of ±60°.
  const Index post = s.add("post", Box{{0.12, 0.9, 0.12}}, {-3.4, 0.9, 0}, true);
  const Index arm = s.add("arm", Box{{0.6, 0.1, 0.1}}, {-2.75, 1.6, 0.24});
  s.join(JointType::hinge, post, arm, {-3.4, 1.6, 0.12}, z, 0.4).limits = JointRange{-kPi / 3, kPi / 3};
  s.turn(arm, {-3.4, 1.6, 0.12}, z, -35 * kPi / 180);

  // Slider with stops, 0.3 m along it.
  const Index rail = s.add("rail", Box{{0.9, 0.08, 0.16}}, {-0.9, 0.5, 0}, true);
  const Index carriage = s.add("carriage", Box{{0.25, 0.16, 0.25}}, {-0.9, 0.74, 0});
  s.join(JointType::slider, rail, carriage, {-0.9, 0.74, 0}, x, 0.2).limits = JointRange{-0.65, 0.65};
  s.state.c[carriage].x() += 0.3;

  // A ball that is pulled apart by 12 cm.
  const Index upper = s.add("upper", Capsule{0.13, 0.5}, {0.9, 1.75, 0}, true);
  const Index lower = s.add("lower", Capsule{0.13, 0.5}, {0.9, 0.99, 0});
  s.join(JointType::spherical, upper, lower, {0.9, 1.37, 0}, x, 0.2);
  s.turn(lower, {0.9, 1.37, 0}, z, 0.5);
  s.state.c[lower] += Vec3(0.1, -0.07, 0);

  // Two boxes as one.
  const Index left = s.add("left", Box{{0.3, 0.25, 0.25}}, {1.9, 0.25, 0});
  const Index right = s.add("right", Box{{0.3, 0.25, 0.25}}, {2.5, 0.25, 0});
  s.join(JointType::fixed, left, right, {2.2, 0.25, 0}, x, 0.4);

  // A weight on a spring, and one on a rod.
  for (const bool soft : {true, false}) {
    const double at = soft ? 3.35 : 4.1;
    const Index weight = s.add("weight", Sphere{0.2}, {at, 0.7, 0});
    Joint& link = s.join(JointType::distance, kWorld, weight, {at, 2.1, 0}, x, 0.2);
    link.on_j.r = {0, 0.2, 0};
    link.length = 1;
    link.law.potential = soft ? BondPotential::soft : BondPotential::hard;
    if (!soft) s.state.c[weight] = {at + 0.28, 0.94, 0};
  }
  return s;
}

JointScene chain_scene(int links) {
  JointScene s;
  for (int k = 0; k < links; ++k) {
    s.add("link", Box{{0.5, 0.12, 0.12}}, {k + 0.5, 0, 0});
    s.join(JointType::spherical, k == 0 ? kWorld : k - 1, k, Vec3(k, 0, 0), Vec3::UnitZ(), 0.25);
  }
  return s;
}

}  // namespace pabd
