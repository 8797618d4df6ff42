// SPDX-License-Identifier: MIT
// Cameras that frame: what they promise, seen through the matrices that pictures are drawn with.
#include <catch2/catch.hpp>
#include <cmath>

#include "render/visual/build_visual.h"
#include "render/visual/camera_control.h"
#include "render/visual/framing.h"
#include "sim/scene/random.h"
#include "tests/support/tiny_model.h"

namespace pabd::test_framing {

namespace {

struct Box2 {
  double x0 = 1e9, y0 = 1e9, x1 = -1e9, y1 = -1e9;
};

// In parts of the picture, from its top left corner. A ball is looked at in all directions.
Box2 outline(const Camera& camera, double aspect, const std::vector<Spot>& spots) {
  const Mat4f view = view_matrix(camera);
  const Mat4f clip = projection_matrix(camera, static_cast<float>(aspect), 0.01f, 1000.0f) * view;
  Box2 out;
  for (const Spot& spot : spots) {
    for (int k = 0; k < (spot.radius > 0 ? 2000 : 1); ++k) {
      const double y = 1 - (k + 0.5) / 1000, ring = std::sqrt(std::max(0.0, 1 - y * y)), a = 2.399963 * k;
      const Vec3 p = spot.centre + spot.radius * Vec3(ring * std::cos(a), y, ring * std::sin(a));
      const Vec4f c = clip * p.cast<float>().homogeneous();
      REQUIRE(c.w() > 0);
      const double px = 0.5 + 0.5 * c.x() / c.w(), py = 0.5 - 0.5 * c.y() / c.w();
      out = {std::min(out.x0, px), std::min(out.y0, py), std::max(out.x1, px), std::max(out.y1, py)};
    }
  }
  return out;
}

std::vector<Spot> cloud(std::uint64_t seed, int count) {
  Random random(seed);
  std::vector<Spot> spots;
  for (int i = 0; i < count; ++i) {
    const auto u = [&] { return 2 * random.uniform() - 1; };
    spots.push_back({Vec3(7 * u() + 3, 2 * u() - 1, 4 * u()), i % 3 == 0 ? 0.6 * random.uniform() : 0});
  }
  return spots;
}

constexpr PicturePart kParts[] = {{0, 0, 1, 1}, {0.05, 0.1, 0.6, 0.7}, {0.4, 0.5, 0.55, 0.3}};
constexpr double kAspects[] = {16.0 / 9, 9.0 / 16, 1, 21.0 / 9};

}  // namespace

TEST_CASE("what is fitted is inside of the free part, fills it in one direction and is in its middle") {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const std::vector<Spot> spots = cloud(seed, 25);
    for (const double aspect : kAspects) {
      for (const PicturePart& part : kParts) {
        for (const bool parallel : {false, true}) {
          for (const AxisView side : {AxisView::front, AxisView::right, AxisView::top, AxisView::iso}) {
            CameraPose like;
            like.fov = seed == 2 ? 75 : 35;
            like.orthographic = parallel;
            const Camera camera = fit_camera(spots, rounded(look_from(like, side)), aspect, part);
            const Box2 seen = outline(camera, aspect, spots);
            CAPTURE(seed, aspect, part.x, parallel, static_cast<int>(side), seen.x0, seen.x1, seen.y0,
                    seen.y1);
            const double w = (seen.x1 - seen.x0) / part.w, h = (seen.y1 - seen.y0) / part.h;
            // Balls are looked at in 2000 directions: a thousandth of their size may be missed.
            CHECK(std::max(w, h) == Approx(kFill).margin(2e-3));
            CHECK(0.5 * (seen.x0 + seen.x1) == Approx(part.x + 0.5 * part.w).margin(2e-3));
            CHECK(0.5 * (seen.y0 + seen.y1) == Approx(part.y + 0.5 * part.h).margin(2e-3));
          }
        }
      }
    }
  }
}

TEST_CASE("an orbit shows everything from every side, and from one of them fills the picture") {
  const std::vector<Spot> spots = cloud(4, 30);
  for (const double aspect : kAspects) {
    for (const bool parallel : {false, true}) {
      const PicturePart part = kParts[1];
      CameraPose like;
      like.orthographic = parallel;
      const CameraPose start = precise(fit_orbit(spots, rounded(like), aspect, part));
      double most = 0;
      for (int k = 0; k < 90; ++k) {
        Camera camera = rounded(orbit(start, k * kPi / 45, 0));
        camera.shift = {static_cast<float>(2 * (part.x + 0.5 * part.w) - 1),
                        static_cast<float>(1 - 2 * (part.y + 0.5 * part.h))};
        const Box2 seen = outline(camera, aspect, spots);
        CAPTURE(aspect, parallel, k);
        CHECK(seen.x0 > part.x);
        CHECK(seen.x1 < part.x + part.w);
        CHECK(seen.y0 > part.y);
        CHECK(seen.y1 < part.y + part.h);
        const double right =
            2 * std::abs(std::max(seen.x1 - part.x - 0.5 * part.w, part.x + 0.5 * part.w - seen.x0));
        most = std::max({most, right / part.w, (seen.y1 - seen.y0) / part.h});
      }
      CHECK(most < kFill + 5e-3);
      CHECK(most > 0.8);
    }
  }
}

TEST_CASE("the hull of a body holds its surface") {
  std::vector<Spot> box, capsule, cylinder, plane;
  add_spots(Box{{1, 2, 3}}, {Vec3(5, 0, 0), Mat3::Identity()}, box);
  CHECK(box.size() == 8);
  for (const Spot& spot : box) CHECK((spot.centre - Vec3(5, 0, 0)).cwiseAbs() == Vec3(1, 2, 3));
  add_spots(Capsule{0.5, 2}, {Vec3::Zero(), Mat3::Identity()}, capsule);
  REQUIRE(capsule.size() == 2);
  CHECK(std::abs(capsule[0].centre.y()) == Approx(1));
  CHECK(capsule[1].radius == 0.5);
  add_spots(Plane{Vec3::UnitY(), 0}, {Vec3::Zero(), Mat3::Identity()}, plane);
  CHECK(plane.empty());
}

TEST_CASE("a floor that something falls to is seen, one far below is not") {
  for (const double height : {2.0, 50.0}) {
    TinyModel tiny;
    tiny.add_fixed(Plane{{0, 1, 0}, 0}, Vec3::Zero());
    tiny.add(Sphere{1}, Vec3(-1, height, 0));
    tiny.add(Sphere{1}, Vec3(1, height, 0));
    double lowest = 1e9;
    for (const Spot& spot : spots_of(tiny.model, tiny.state)) lowest = std::min(lowest, spot.centre.y());
    CHECK(lowest == (height < 10 ? 0 : height));
  }
}

}  // namespace pabd::test_framing
