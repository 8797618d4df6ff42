// SPDX-License-Identifier: MIT
// Instances and glyphs of a tiny model: how many, where, how large.
#include "render/visual/build_visual.h"

#include <catch2/catch.hpp>

#include "tests/support/tiny_model.h"

namespace pabd::test_build_visual {

namespace {

const std::vector<Instance>& list(const VisualScene& scene, Primitive primitive) {
  return scene.instances[static_cast<int>(primitive)];
}

Vec3f apply(const Instance& instance, const Vec3f& p) {
  return (instance.transform * p.homogeneous()).head<3>();
}

}  // namespace

TEST_CASE("each shape becomes its primitives at its pose") {
  TinyModel tiny;
  const Mat3 quarter = Eigen::AngleAxisd(kPi / 2, Vec3::UnitZ()).toRotationMatrix();
  tiny.add_fixed(Plane{{0, 1, 0}, -0.25}, Vec3::Zero());
  tiny.add(Box{{1, 2, 3}}, {10, 0, 0}, quarter);
  tiny.add(Sphere{0.5}, {0, 3, 0});
  tiny.add(Capsule{0.2, 1.0}, {0, 0, 5}, quarter);
  VisualScene scene;
  build_visual(tiny.model, tiny.state, {}, {}, scene);

  REQUIRE(scene.grounds.size() == 1);
  CHECK(scene.grounds[0].offset == -0.25f);
  REQUIRE(list(scene, Primitive::cube).size() == 1);
  REQUIRE(list(scene, Primitive::sphere).size() == 1);
  REQUIRE(list(scene, Primitive::cylinder).size() == 1);
  REQUIRE(list(scene, Primitive::hemisphere).size() == 2);
  CHECK(list(scene, Primitive::cone).empty());
  CHECK(list(scene, Primitive::disc).empty());
  CHECK(scene.lines.empty());

  // The box's +x face centre turns to +y.
  CHECK((apply(list(scene, Primitive::cube)[0], {1, 0, 0}) - Vec3f(10, 1, 0)).norm() < 1e-5f);
  CHECK((apply(list(scene, Primitive::sphere)[0], {0, 1, 0}) - Vec3f(0, 3.5, 0)).norm() < 1e-5f);
  // The capsule's axis y turns to −x: its tips are at x = ∓(0.5 + 0.2), and the two caps meet the tube's
  // rims.
  const auto& caps = list(scene, Primitive::hemisphere);
  CHECK((apply(caps[0], {0, 1, 0}) - Vec3f(-0.7f, 0, 5)).norm() < 1e-5f);
  CHECK((apply(caps[1], {0, 1, 0}) - Vec3f(0.7f, 0, 5)).norm() < 1e-5f);
  CHECK((apply(caps[0], {0, 0, 0}) - apply(list(scene, Primitive::cylinder)[0], {0, 1, 0})).norm() < 1e-5f);
  for (const Instance& cap : caps) {
    CHECK(cap.transform.block<3, 3>(0, 0).determinant() > 0);  // not mirrored: faces keep their winding
  }
}

TEST_CASE("the bounding sphere holds what moves; planes and huge scenery do not count") {
  TinyModel tiny;
  tiny.add_fixed(Plane{{0, 1, 0}, 0}, Vec3::Zero());
  tiny.add_fixed(Box{{100, 1, 100}}, {0, -1, 0});
  tiny.add(Sphere{1}, {-3, 1, 0});
  tiny.add(Sphere{1}, {3, 1, 0});
  VisualScene scene;
  build_visual(tiny.model, tiny.state, {}, {}, scene);
  CHECK((scene.centre - Vec3f(0, 1, 0)).norm() < 1e-6f);
  CHECK(scene.radius == Approx(4));
  tiny.add_fixed(Box{{1, 1, 1}}, {0, 6, 0});
  build_visual(tiny.model, tiny.state, {}, {}, scene);
  CHECK(scene.radius > 4.5f);
}

TEST_CASE(
    "contacts become disc, shaft and head along the normal, each before a dark rim; longer for larger "
    "forces") {
  TinyModel tiny;
  tiny.add(Box{{0.5, 0.5, 0.5}}, {0, 0.5, 0});
  tiny.add(Box{{0.5, 0.5, 0.5}}, {0, 1.51, 0});
  StepReport report;
  const Vec3 n(0, 1, 0);
  report.contact_reports.push_back({0, 1, {0, 1, 0}, {0, 1.01, 0}, n, 0.01, 0.0, Vec3::Zero(), true, 0});
  report.contact_reports.push_back(
      {0, 1, {0.4, 1, 0}, {0.4, 1.005, 0}, n, 0.005, 9810.0, Vec3::Zero(), true, 0});
  VisualOptions options;
  options.contacts = true;
  options.d_hat = 0.01;
  options.glyph_scale = 0.1;
  VisualScene scene;
  build_visual(tiny.model, tiny.state, report, options, scene);

  // Without force there is no arrow.
  REQUIRE(list(scene, Primitive::disc).size() == 4);
  REQUIRE(list(scene, Primitive::cylinder).size() == 2);
  REQUIRE(list(scene, Primitive::cone).size() == 2);
  CHECK(list(scene, Primitive::sphere).empty());
  const Instance &rim = list(scene, Primitive::disc)[2], &disc = list(scene, Primitive::disc)[3];
  // On the body above, which it pushes.
  CHECK((apply(disc, Vec3f::Zero()) - Vec3f(0.4f, 1.005f, 0)).norm() < 1e-6f);
  CHECK((apply(disc, {1, 0, 0}) - apply(disc, Vec3f::Zero())).norm() == Approx(0.1));
  CHECK(std::abs((apply(disc, {1, 0, 0}) - apply(disc, Vec3f::Zero())).y()) <
        1e-6f);  // lies in the contact plane
  CHECK((disc.color - contact_color(0.5)).norm() == 0);
  CHECK_FALSE(disc.shaded);
  CHECK_FALSE(disc.shadow);
  CHECK((apply(rim, {1, 0, 0}) - apply(rim, Vec3f::Zero())).norm() > 0.11f);
  CHECK(rim.color.head<3>().maxCoeff() < 0.03f);
  const Vec3f eye = scene.camera.eye;
  CHECK((apply(rim, Vec3f::Zero()) - eye).norm() > (apply(disc, Vec3f::Zero()) - eye).norm());
  // 4.5 s log10(1 + 9 f/W): 0.45 m for one weight (1 m³ of 1000 kg/m³).
  CHECK(apply(list(scene, Primitive::cone)[1], {0, 1, 0}).y() == Approx(1.455));
  // The shaft ends where the head begins.
  CHECK((apply(list(scene, Primitive::cylinder)[1], {0, 1, 0}) -
         apply(list(scene, Primitive::cone)[1], {0, 0, 0}))
            .norm() < 1e-6f);
}

TEST_CASE("an arrow is the force on the movable body, or else on the upper one, whoever owns the normal") {
  TinyModel tiny;
  tiny.add_fixed(Box{{0.5, 0.5, 0.5}}, {0, 2.5, 0});
  tiny.add(Box{{0.5, 0.5, 0.5}}, {0, 1.5, 0});
  tiny.add(Box{{0.5, 0.5, 0.5}}, {0, 0.5, 0});
  VisualOptions options;
  options.contacts = true;
  options.glyph_scale = 0.1;
  const auto direction = [&](Index a, Index b, const Vec3& n) -> Vec3f {
    StepReport report;
    report.contact_reports.push_back({a, b, {0, 1, 0}, {0, 1, 0}, n, 0.005, 9810.0, Vec3::Zero(), true, 0});
    VisualScene scene;
    build_visual(tiny.model, tiny.state, report, options, scene);
    const Instance& head = list(scene, Primitive::cone).at(1);
    return (apply(head, {0, 1, 0}) - apply(head, {0, 0, 0})).normalized();
  };
  // The fixed one is above: the arrow is on the movable one, and points down.
  CHECK((direction(0, 1, {0, -1, 0}) - Vec3f(0, -1, 0)).norm() < 1e-5f);
  CHECK((direction(1, 0, {0, 1, 0}) - Vec3f(0, -1, 0)).norm() < 1e-5f);
  // Both movable: up.
  CHECK((direction(1, 2, {0, -1, 0}) - Vec3f(0, 1, 0)).norm() < 1e-5f);
  CHECK((direction(2, 1, {0, 1, 0}) - Vec3f(0, 1, 0)).norm() < 1e-5f);
  CHECK((direction(2, 1, {-1, 0, 0}) - direction(1, 2, {1, 0, 0})).norm() < 1e-5f);
}

TEST_CASE("many contacts of two bodies are one glyph with their load and the colour of the deepest") {
  TinyModel tiny;
  tiny.add(Box{{0.5, 0.5, 0.5}}, {0, 0.5, 0});
  StepReport report;
  for (int pair = 0; pair < 100; ++pair) {
    tiny.add(Box{{0.5, 0.5, 0.5}}, {0, 1.5, 0});
    for (int k = 0; k < 4; ++k) {
      const double x = k % 2 == 0 ? -0.5 : 0.5, z = k < 2 ? -0.5 : 0.5;
      report.contact_reports.push_back({0,
                                        pair + 1,
                                        {x, 1, z},
                                        {x, 1, z},
                                        Vec3(0, 1, 0),
                                        k == 2 ? 0.002 : 0.008,
                                        9810.0 / 4,
                                        Vec3::Zero(),
                                        true,
                                        0});
    }
  }
  VisualOptions options;
  options.contacts = true;
  options.glyph_scale = 0.1;
  options.d_hat = 0.01;
  VisualScene scene;
  build_visual(tiny.model, tiny.state, report, options, scene);
  REQUIRE(list(scene, Primitive::disc).size() == 200);
  const Instance& disc = list(scene, Primitive::disc)[1];
  CHECK((apply(disc, Vec3f::Zero()) - Vec3f(0, 1, 0)).norm() < 1e-5f);
  CHECK(disc.color == contact_color(0.2));
  CHECK(apply(list(scene, Primitive::cone)[1], {0, 1, 0}).y() == Approx(1.45));
}

TEST_CASE("bonds become two points in two colours and a line; nothing is added without reports or options") {
  TinyModel tiny;
  tiny.add(Box{{0.5, 0.5, 0.5}}, {0, 0.5, 0});
  StepReport report;
  report.contact_reports.push_back(
      {0, 0, {0, 1, 0}, {0, 1.2, 0}, {0, 1, 0}, 0.2, 1.0, Vec3::Zero(), true, 0});
  VisualOptions options;
  VisualScene scene;
  build_visual(tiny.model, tiny.state, report, options, scene);
  CHECK(list(scene, Primitive::sphere).empty());
  options.bonds = true;
  build_visual(tiny.model, tiny.state, report, options, scene);
  const auto& points = list(scene, Primitive::sphere);
  REQUIRE(points.size() == 2);
  CHECK((apply(points[0], Vec3f::Zero()) - Vec3f(0, 1, 0)).norm() < 1e-6f);
  CHECK((apply(points[1], Vec3f::Zero()) - Vec3f(0, 1.2f, 0)).norm() < 1e-6f);
  CHECK((points[0].color - points[1].color).norm() > 0.5f);
  REQUIRE(scene.lines.size() == 1);
  CHECK(scene.lines[0].on_top);
  build_visual(tiny.model, tiny.state, {}, options, scene);
  CHECK(list(scene, Primitive::sphere).empty());
}

TEST_CASE("a body that left the numbers is not drawn") {
  TinyModel tiny;
  tiny.add(Sphere{1}, Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  tiny.add(Sphere{1}, Vec3(0, 1, 0));
  VisualScene scene;
  build_visual(tiny.model, tiny.state, {}, {}, scene);
  CHECK(list(scene, Primitive::sphere).size() == 1);
  CHECK(scene.centre.allFinite());
}

}  // namespace pabd::test_build_visual
