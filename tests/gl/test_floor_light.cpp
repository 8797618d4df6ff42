// SPDX-License-Identifier: MIT
// The floor where bodies stand on it.
#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "tests/gl/render_fixture.h"

namespace pabd::test_floor_light {

namespace {

constexpr int kSide = 400;

// A floor under an eye `height` above its origin that looks straight down, and light from the right and the front.
VisualScene floor_below(float height) {
  VisualScene scene;
  scene.grounds.push_back({{0, 1, 0}, 0});
  scene.centre = {0, 0, 0};
  scene.radius = 2;
  scene.light_direction = {-1, -2, -0.5f};
  scene.camera.eye = {0, height, 0};
  scene.camera.target = {0, 0, 0};
  scene.camera.up = {0, 0, -1};
  return scene;
}

Instance grey(const Vec3f& at, const Vec3f& half) {
  Mat4f m = Mat4f::Identity();
  m.diagonal().head<3>() = half;
  m.block<3, 1>(0, 3) = at;
  return {m, {0.5f, 0.5f, 0.5f, 1}};
}

// Linear light of the floor point (x, z) in that picture.
double light_at(const Image& image, double height, double x, double z) {
  const double metre = 0.5 * kSide / (std::tan(22.5 * 3.14159265358979 / 180) * height);
  return to_linear(
      pixel(image, static_cast<int>(0.5 * kSide + x * metre), static_cast<int>(0.5 * kSide + z * metre)).g);
}

}  // namespace

TEST_CASE("no light comes through under the foot of a wall that stands on the floor") {
  const Quality level = GENERATE(Quality::draft, Quality::good, Quality::best);
  RenderFixture f(kSide, kSide);
  VisualScene scene = floor_below(4);
  // Its shadow falls to the left of its face at x = 0.75, up to which the eye sees the floor.
  scene.instances[0].push_back(grey({0.8f, 0.501f, 0}, {0.05f, 0.5f, 3}));
  const Image image = render(f.renderer, scene, nullptr, level);
  const auto brightest = [&](double from, double to) {
    double most = 0;
    for (double z = -0.5; z < 0.5; z += 0.01)
      for (double x = from; x < to; x += 0.005) most = std::max(most, light_at(image, 4, x, z));
    return most;
  };
  const double shade = brightest(0.45, 0.6);
  CHECK(shade < 0.7 * brightest(-0.5, -0.3));
  CHECK(brightest(0.6, 0.735) <= shade);
}

TEST_CASE(
    "the edge of a shadow is straight to a fifth of a pixel, whatever its angle to the texels of the map") {
  RenderFixture f(kSide, kSide);
  VisualScene scene = floor_below(4);
  scene.light_direction = VisualScene{}.light_direction;  // to whose texels the edges of the wall are at 15°
  scene.instances[0].push_back(grey({0.8f, 0.501f, 0}, {0.05f, 0.5f, 3}));
  const Image image = render(f.renderer, scene);
  const auto light = [&](int x, int y) { return to_linear(pixel(image, x, y).g); };
  // Where the light is half way between shade and sun, in rows between lines of the floor.
  std::vector<double> places;
  for (int y = 212; y < 284; ++y) {
    const double half = 0.5 * (light(230, y) + light(145, y));
    int x = 150;
    while (x < 230 && light(x + 1, y) >= half) ++x;
    places.push_back(x + (light(x, y) - half) / (light(x, y) - light(x + 1, y)));
  }
  double mean = 0, off = 0;
  for (const double place : places) mean += place / static_cast<double>(places.size());
  for (const double place : places)
    off += (place - mean) * (place - mean) / static_cast<double>(places.size());
  CHECK(mean == Approx(200 - 0.1 * 120.7).margin(1));  // the wall's upper edge along the light
  CHECK(std::sqrt(off) < 0.18);
}

TEST_CASE("the floor darkens at the foot of a thin post, wherever it stands, and not under one that floats") {
  RenderFixture f(kSide, kSide);
  // The darkest place in the sun 1 cm from its rim, between the lines of the floor; over the open floor.
  const auto at_rim = [&](float x, float foot) {
    constexpr float z = 0.45f;
    VisualScene scene = floor_below(2);
    for (const Eigen::Vector2f& at : {Eigen::Vector2f(x, z), {-1, -1}, {1, 1}}) {
      scene.instances[static_cast<int>(Primitive::cylinder)].push_back(
          grey({at.x(), foot + 0.5f, at.y()}, {0.02f, 0.5f, 0.02f}));
    }
    const Image image = render(f.renderer, scene);
    double least = 1;
    for (double angle = -0.5; angle < 0.5; angle += 0.1)
      least = std::min(least, light_at(image, 2, x + 0.03 * std::cos(angle), z + 0.03 * std::sin(angle)));
    return least / light_at(image, 2, 0.35, -0.45);
  };
  for (float x = -0.57f; x < -0.54f; x += 0.003f) {
    CAPTURE(x);
    CHECK(at_rim(x, 0) < 0.96);
    CHECK(at_rim(x, 0.3f) > 0.99);
  }
}

}  // namespace pabd::test_floor_light
