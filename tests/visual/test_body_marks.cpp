// SPDX-License-Identifier: MIT
// Boxes, velocities and trails against closed forms; colours that scenes give.
#include <catch2/catch.hpp>
#include <cmath>

#include "render/visual/body_marks.h"
#include "render/visual/build_visual.h"
#include "render/visual/palette.h"
#include "tests/support/tiny_model.h"

namespace pabd::test_body_marks {

TEST_CASE("a box has twelve edges between its two corners") {
  TinyModel tiny;
  tiny.add(Sphere{0.5}, {1, 1, 1});
  tiny.add_fixed(Sphere{0.5}, {9, 9, 9});
  VisualScene scene;
  add_boxes(tiny.model, tiny.state, scene);
  REQUIRE(scene.lines.size() == 12);
  for (const Line& line : scene.lines) {
    CHECK((line.b - line.a).norm() == Approx(1));
    for (const Vec3f& p : {line.a, line.b}) CHECK(((p.array() - 1).abs() - 0.5f).abs().maxCoeff() < 1e-6f);
  }
}

TEST_CASE("a velocity arrow ends where its body would be; a slow body has none") {
  TinyModel tiny;
  tiny.add(Sphere{0.5}, {0, 1, 0});
  tiny.add(Sphere{0.5}, {2, 1, 0});
  tiny.state.v[0] = {3, -1, 0.5};
  tiny.state.v[1] = {1e-3, 0, 0};
  VisualScene scene;
  add_velocity_arrows(tiny.model, tiny.state, scene);
  REQUIRE(scene.lines.size() == 3);
  CHECK((scene.lines[0].a - Vec3f(0, 1, 0)).norm() < 1e-6f);
  CHECK((scene.lines[0].b - Vec3f(0.6f, 0.8f, 0.1f)).norm() < 1e-6f);
}

TEST_CASE("a trail fades towards its beginning") {
  std::vector<Vec3> path;
  for (int k = 0; k < 11; ++k) path.emplace_back(k, 0, 0);
  VisualScene scene;
  add_trail(path, trail_color(0), scene);
  REQUIRE(scene.lines.size() == 10);
  for (std::size_t k = 1; k < 10; ++k) CHECK(scene.lines[k].color.w() > scene.lines[k - 1].color.w());
  CHECK(scene.lines[9].color.w() == 1);
  CHECK(scene.lines[0].color.w() < 0.02f);
}

TEST_CASE("a body has the colour that its scene says, with contacts and bonds too; values come first") {
  TinyModel tiny;
  tiny.add(Sphere{0.5}, {0, 1, 0});
  tiny.add(Sphere{0.5}, {2, 1, 0});
  VisualOptions options;
  options.looks.resize(1);
  options.looks[0] = {Vec3(1, 0.5, 0), 0.5, true};
  for (const bool glyphs : {false, true}) {
    options.contacts = options.bonds = glyphs;
    VisualScene scene;
    build_visual(tiny.model, tiny.state, {}, options, scene);
    const auto& balls = scene.instances[static_cast<int>(Primitive::sphere)];
    REQUIRE(balls.size() == 2);
    CHECK(balls[0].color.x() == 1);
    CHECK(balls[0].color.y() == Approx(0.21404).epsilon(1e-3));  // 0.5 of sRGB
    CHECK(balls[0].color.w() == 0.5f);
    CHECK(balls[0].checker);
    CHECK_FALSE(balls[0].shadow);
    CHECK(balls[1].color == body_color(1, false));
    CHECK(balls[1].shadow);
  }
}

}  // namespace pabd::test_body_marks
