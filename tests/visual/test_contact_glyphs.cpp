// SPDX-License-Identifier: MIT
// Marks of contacts are seen from far: arrows keep a width in pixels, and what would lie on each other is one mark.
#include "render/visual/contact_glyphs.h"

#include <catch2/catch.hpp>

#include "render/visual/line_shapes.h"
#include "tests/support/tiny_model.h"

namespace pabd::test_contact_glyphs {

namespace {

constexpr double kScale = 0.02;  // m

// Two points of a box on another, `apart` from each other (m), seen from `distance` (m) at right angles to their normal.
VisualScene seen(double distance, double apart) {
  TinyModel tiny;
  tiny.add(Box{{0.5, 0.5, 0.5}}, {0, 0.5, 0});
  tiny.add(Box{{0.5, 0.5, 0.5}}, {0, 1.5, 0});
  StepReport report;
  for (const double x : {-0.5 * apart, 0.5 * apart}) {
    const Vec3 at(x, 1, 0);
    report.contact_reports.push_back(
        {0, 1, at, at, {0, 1, 0}, 0.002 + 0.001 * (x > 0), 9810.0, Vec3::Zero(), true, 0.5});
  }
  VisualOptions options;
  options.contacts = options.bonds = true;
  options.glyph_scale = kScale;
  VisualScene out;
  out.camera.eye = {0, 1, static_cast<float>(distance)};
  out.camera.target = {0, 1, 0};
  build_visual(tiny.model, tiny.state, report, options, out);
  return out;
}

// Diameter of the piece that is no rim, in pixels of a frame 720 px high.
double pixels(const VisualScene& scene, Primitive primitive) {
  const Mat4f& m = scene.instances[static_cast<int>(primitive)].at(1).transform;
  return 2 * static_cast<double>(m.col(0).norm()) / PixelMeter(scene.camera).at(Vec3(0, 1, 0));
}

std::size_t marks(const VisualScene& scene) {
  return scene.instances[static_cast<int>(Primitive::disc)].size() / 2;
}

}  // namespace

TEST_CASE("an arrow is at least 3 px and its head 9 px thick, but at most three times as thick as near by") {
  for (const double distance : {2.5, 4.0, 5.9}) {
    CAPTURE(distance);
    const VisualScene scene = seen(distance, 0.8);
    CHECK(pixels(scene, Primitive::cone) == Approx(9.05).epsilon(0.01));
    CHECK(pixels(scene, Primitive::cylinder) == Approx(3.3).epsilon(0.01));
  }
  const VisualScene near = seen(1, 0.8), far = seen(40, 0.8);
  const double px = PixelMeter(near.camera).at(Vec3(0, 1, 0));
  CHECK(pixels(near, Primitive::cone) == Approx(2 * 0.52 * kScale / px).epsilon(1e-5));
  CHECK(pixels(far, Primitive::cone) == Approx(3 * pixels(near, Primitive::cone) / 40).epsilon(0.2));
  CHECK(pixels(far, Primitive::disc) ==
        Approx(2 * kScale / (40 * px)).epsilon(1e-3));  // discs stay as they are
}

TEST_CASE("points of a pair that are closer than a mark on the screen are one, with the load of both") {
  const VisualScene near = seen(4, 0.3), far = seen(40, 0.3);
  CHECK(marks(near) == 2);
  REQUIRE(marks(far) == 1);
  const Instance& disc = far.instances[static_cast<int>(Primitive::disc)][1];
  CHECK((disc.transform.col(3).head<3>() - Vec3f(0, 1, 0)).norm() < 1e-6f);
  CHECK(disc.color == contact_color(0.2));  // of the deeper one
  const auto points = [](const VisualScene& scene) {
    return scene.instances[static_cast<int>(Primitive::sphere)].size();
  };
  CHECK(points(near) == 4);  // of bonds, one on each body
  CHECK(points(far) == 2);
  const auto length = [](const VisualScene& scene) {
    const Mat4f& m = scene.instances[static_cast<int>(Primitive::cone)].at(1).transform;
    return m(1, 3) + m(1, 1) - 1;
  };
  CHECK(length(far) > 1.2f * length(near));
}

}  // namespace pabd::test_contact_glyphs
