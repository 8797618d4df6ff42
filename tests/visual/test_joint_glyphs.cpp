// SPDX-License-Identifier: MIT
// Glyphs of joints: what is where, in numbers. The camera looks along −z from (0, 0, 10) with 720 px over
// 2 · 10 · tan(22.5°) m, so that a pixel at z = 0 spans 0.01151 m.
#include "render/visual/joint_glyphs.h"

#include <catch2/catch.hpp>

#include "render/visual/build_visual.h"
#include "render/visual/palette.h"
#include "sim/math/so3.h"
#include "tests/support/tiny_model.h"

namespace pabd::test_joint_glyphs {

namespace {

const double kPixel = 2 * 10 * std::tan(kPi / 8) / 720;

// A joint of the world with body 0 at the origin, axis z; both frames are the world's.
Joint axis_joint(JointType type, double arm) {
  Joint joint;
  joint.type = type;
  joint.j = 0;
  joint.arm = arm;
  Mat3 F;
  F << 0, 1, 0, 0, 0, 1, 1, 0, 0;  // n = z, e = x, b = y
  joint.on_i = joint.on_j = {Vec3::Zero(), F};
  return joint;
}

VisualScene front() {
  VisualScene scene;
  scene.camera.eye = {0, 0, 10};
  scene.camera.target = {0, 0, 0};
  return scene;
}

VisualScene draw(const Joint& joint, const Pose& j, const GlyphSize& size = {0.02, 0, false}) {
  VisualScene scene = front();
  add_joint_glyphs(joint, {Vec3::Zero(), Mat3::Identity()}, j, 0, size, scene);
  return scene;
}

const std::vector<Instance>& discs(const VisualScene& scene) {
  return scene.instances[static_cast<int>(Primitive::disc)];
}

Vec3f centre(const Instance& instance) { return instance.transform.block<3, 1>(0, 3); }
float radius(const Instance& instance) { return instance.transform.block<3, 1>(0, 0).norm(); }

// Distance of a point from the ray of the eye through p: where it appears in the frame.
float off_ray(const Vec3f& point, const Vec3f& p) {
  const Vec3f eye(0, 0, 10);
  return (point - eye).cross((p - eye).normalized()).norm();
}

bool has_line(const VisualScene& scene, const Vec3f& a, const Vec3f& b) {
  return std::any_of(scene.lines.begin(), scene.lines.end(), [&](const Line& line) {
    return (line.a - a).norm() < 1e-5f && (line.b - b).norm() < 1e-5f;
  });
}

const Pose kStart{Vec3::Zero(), Mat3::Identity()};

}  // namespace

TEST_CASE("a met ball is a bullseye, an open one two dots and a line") {
  const Joint ball = axis_joint(JointType::spherical, 0.3);
  const VisualScene met = draw(ball, kStart);
  REQUIRE(discs(met).size() == 3);  // rim and disc of y_j, dot of y_i
  for (const Instance& disc : discs(met)) CHECK(off_ray(centre(disc), {0, 0, 0}) < 1e-6f);
  CHECK(discs(met)[0].color == joint_color(JointType::spherical));
  CHECK(discs(met)[1].color == bond_point_j_color());
  CHECK(discs(met)[2].color == bond_point_i_color());
  // The dot of y_i is nearest to the eye, and smaller than the disc.
  CHECK(centre(discs(met)[2]).z() > centre(discs(met)[1]).z());
  CHECK(centre(discs(met)[1]).z() > centre(discs(met)[0]).z());
  CHECK(radius(discs(met)[2]) < radius(discs(met)[1]));
  CHECK(met.lines.empty());

  const VisualScene open = draw(ball, {Vec3(0.5, 0.25, 0), Mat3::Identity()});
  REQUIRE(discs(open).size() == 3);
  CHECK(off_ray(centre(discs(open)[1]), {0.5f, 0.25f, 0}) < 1e-6f);
  CHECK(off_ray(centre(discs(open)[2]), {0, 0, 0}) < 1e-6f);
  REQUIRE(open.lines.size() == 1);
  CHECK(has_line(open, {0, 0, 0}, {0.5f, 0.25f, 0}));
}

TEST_CASE("dots keep between 1.6 and 5 pixels, and a pull does not change how they look") {
  const Joint ball = axis_joint(JointType::spherical, 0.3);
  const auto dot = [&](double size, double pull) {
    const VisualScene scene = draw(ball, kStart, {size, pull, false});
    const Instance& disc = discs(scene).back();
    return static_cast<double>(radius(disc)) * 10 / (10 - static_cast<double>(centre(disc).z())) / kPixel;
  };
  CHECK(dot(3 * kPixel, 0) == Approx(3).epsilon(1e-4));
  CHECK(dot(1e-6, 0) == Approx(1.6).epsilon(1e-4));
  CHECK(dot(1, 0) == Approx(5).epsilon(1e-4));
  CHECK(dot(3 * kPixel, 2.5) == Approx(3).epsilon(1e-4));
  CHECK(centre(discs(draw(ball, kStart, {0.02, 2.5, false}))[0]).z() == Approx(2.5));
}

TEST_CASE("a hinge shows its axis, its angle and its limits") {
  Joint hinge = axis_joint(JointType::hinge, 0.5);
  hinge.limits = JointRange{-1, 1.2};
  const double phi = 0.6;
  const VisualScene scene = draw(hinge, {Vec3::Zero(), exp_so3({0, 0, phi})});
  CHECK(discs(scene).size() == 6);  // two bonds, at ± arm on the axis
  CHECK(has_line(scene, {0, 0, -0.75f}, {0, 0, 0.75f}));
  // The hand, 1.18 dials long: the dial is 0.8 arm.
  const double hand = 1.18 * 0.8 * 0.5;
  CHECK(has_line(scene, {0, 0, 0},
                 {static_cast<float>(hand * std::cos(phi)), static_cast<float>(hand * std::sin(phi)), 0}));
  // The arc runs from one limit to the other, on the dial.
  double length = 0;
  for (const Line& line : scene.lines) {
    if (line.width == 4) length += static_cast<double>((line.b - line.a).norm());
  }
  CHECK(length == Approx(0.4 * 2.2).epsilon(0.002));  // of chords
  CHECK(scene.instances[static_cast<int>(Primitive::sphere)].empty());
  // Too small to read: neither dial nor axis, one pair of points.
  Joint small = hinge;
  small.arm = 3 * kPixel;
  const VisualScene far = draw(small, kStart);
  CHECK(discs(far).size() == 3);
  CHECK(far.lines.empty());
}

TEST_CASE("a free hinge has a dial where that is large enough to be read, else its axis alone") {
  CHECK(draw(axis_joint(JointType::hinge, 35 * kPixel), kStart).lines.size() > 1);
  const VisualScene small = draw(axis_joint(JointType::hinge, 32 * kPixel), kStart);
  CHECK(small.lines.size() == 1);
  CHECK(has_line(small, {0, 0, static_cast<float>(-48 * kPixel)}, {0, 0, static_cast<float>(48 * kPixel)}));
}

TEST_CASE("a hinge held at a limit has four bonds") {
  Joint hinge = axis_joint(JointType::hinge, 0.5);
  hinge.limits = JointRange{-0.5, 0.5};
  const VisualScene scene = draw(hinge, {Vec3::Zero(), exp_so3({0, 0, 0.8})});
  REQUIRE(discs(scene).size() == 12);
  // y_j beside the axis on e turned by 0.8; y_i at the bound, 0.5: their gap is a chord of 0.3 rad.
  CHECK(off_ray(centre(discs(scene)[7]), {0.5f * std::cos(0.8f), 0.5f * std::sin(0.8f), 0}) < 1e-5f);
  CHECK(off_ray(centre(discs(scene)[8]), {0.5f * std::cos(0.5f), 0.5f * std::sin(0.5f), 0}) < 1e-5f);
  CHECK(has_line(scene, {0.5f * std::cos(0.5f), 0.5f * std::sin(0.5f), 0},
                 {0.5f * std::cos(0.8f), 0.5f * std::sin(0.8f), 0}));
}

TEST_CASE("a slider shows its range, its stops and its offset") {
  Joint slider = axis_joint(JointType::slider, 0.5);
  slider.on_i.F = slider.on_j.F = Mat3::Identity();  // along x
  slider.twist = Twist::free;
  slider.limits = JointRange{-1, 2};
  const VisualScene scene = draw(slider, {Vec3(0.7, 0, 0), Mat3::Identity()});
  CHECK(has_line(scene, {-1, 0, 0}, {2, 0, 0}));
  CHECK(has_line(scene, {0, 0, 0}, {0.7f, 0, 0}));
  // S(15): the points of j are moved back to those of i, so both pairs are met at i's.
  REQUIRE(discs(scene).size() == 6);
  CHECK(off_ray(centre(discs(scene)[1]), {0.5f, 0, 0}) < 1e-6f);
  CHECK(off_ray(centre(discs(scene)[4]), {-0.5f, 0, 0}) < 1e-6f);
}

TEST_CASE("a soft distance joint is a coil between its points, a hard one a rod") {
  Joint spring = axis_joint(JointType::distance, 0.5);
  spring.length = 1;
  const Pose j{Vec3(0, -1.5, 0), Mat3::Identity()};
  const VisualScene coil = draw(spring, j);
  REQUIRE(coil.lines.size() > 10);
  CHECK((coil.lines.front().a - Vec3f(0, 0, 0)).norm() < 1e-6f);
  CHECK((coil.lines.back().b - Vec3f(0, -1.5f, 0)).norm() < 1e-6f);
  double widest = 0;
  for (std::size_t k = 0; k + 1 < coil.lines.size(); ++k) {
    CHECK((coil.lines[k].b - coil.lines[k + 1].a).norm() < 1e-6f);
    widest = std::max(widest, static_cast<double>(std::hypot(coil.lines[k].b.x(), coil.lines[k].b.z())));
  }
  CHECK(widest == Approx(0.08).epsilon(1e-4));  // of the rest length
  spring.law.potential = BondPotential::hard;
  const VisualScene rod = draw(spring, j);
  REQUIRE(rod.lines.size() == 1);
  CHECK(has_line(rod, {0, 0, 0}, {0, -1.5f, 0}));
}

TEST_CASE("a fixed joint has seven bonds, four if it is one-sided") {
  Joint fixed = axis_joint(JointType::fixed, 0.5);
  CHECK(discs(draw(fixed, kStart)).size() == 21);
  fixed.symmetric = false;
  CHECK(discs(draw(fixed, kStart)).size() == 12);
  // Small ones are one point, until a bond is open by more than three pixels.
  fixed.arm = 30 * kPixel;
  CHECK(discs(draw(fixed, kStart)).size() == 3);
  CHECK(discs(draw(fixed, {Vec3(2 * kPixel, 0, 0), Mat3::Identity()})).size() == 3);
  CHECK(discs(draw(fixed, {Vec3(4 * kPixel, 0, 0), Mat3::Identity()})).size() == 12);
}

TEST_CASE("joints come with the bonds option; thousands as a dot each; lost bodies are skipped") {
  TinyModel tiny;
  tiny.add(Box{{0.2, 0.2, 0.2}}, Vec3::Zero());
  tiny.model.joints.push_back(axis_joint(JointType::hinge, 0.5));
  VisualScene scene = front();
  VisualOptions options;
  build_visual(tiny.model, tiny.state, {}, options, scene);
  CHECK(discs(scene).empty());
  options.bonds = true;
  build_visual(tiny.model, tiny.state, {}, options, scene);
  CHECK(discs(scene).size() == 6);
  CHECK(joint_types(tiny.model) == 1u << static_cast<unsigned>(JointType::hinge));

  const std::vector<Joint> many(2001, axis_joint(JointType::spherical, 0.5));
  tiny.model.joints = many;
  build_visual(tiny.model, tiny.state, {}, options, scene);
  CHECK(discs(scene).size() == 2001);
  CHECK(scene.lines.empty());

  tiny.state.c[0].x() = std::numeric_limits<double>::quiet_NaN();
  build_visual(tiny.model, tiny.state, {}, options, scene);
  CHECK(discs(scene).empty());
}

}  // namespace pabd::test_joint_glyphs
