// SPDX-License-Identifier: MIT
// The comparison against real pictures: each small mistake in a frame must be seen. This guards the limits of
// the comparison itself, so it stays even when every picture is fine.

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <functional>

#include "render/output/compare_images.h"
#include "tests/pictures/picture_studio.h"

namespace pabd::test_mutations {

namespace {

constexpr int kWidth = 1280, kHeight = 720;

// A brick in the middle of the pyramid's front.
Instance& brick(VisualScene& scene) {
  auto& cubes = scene.instances[static_cast<int>(Primitive::cube)];
  return cubes.at(cubes.size() / 2);
}

VisualScene pyramid() {
  VisualScene scene = visual_of(StoredStep("pyramid"), false);
  scene.lines.push_back({{-4, 1, 3}, {-1, 2, 3}, {0.1f, 0.1f, 0.1f, 1}, 2, false});
  return scene;
}

// Metres that a pixel spans at the brick.
float pixel_size(const VisualScene& scene, const Vec3f& at) {
  const float distance = (at - scene.camera.eye).norm();
  return 2 * distance * std::tan(scene.camera.fov * float(EIGEN_PI) / 360) / kHeight;
}

struct Mutation {
  const char* name;
  std::function<void(VisualScene&)> apply;
  bool seen_across_classes;  // tier B lets pass what another driver could do: a pixel's shift, a shade
};

const std::vector<Mutation>& mutations() {
  static const std::vector<Mutation> all = {
      {"rotated by 1°",
       [](VisualScene& s) {
         brick(s).transform.block<3, 3>(0, 0) =
             Eigen::AngleAxisf(float(EIGEN_PI) / 180, Vec3f::UnitZ()) * brick(s).transform.block<3, 3>(0, 0);
       },
       false},
      {"albedo −2 %", [](VisualScene& s) { brick(s).color.head<3>() *= 0.98f; }, false},
      {"moved by a pixel",
       [](VisualScene& s) {
         const Vec3f at = brick(s).transform.block<3, 1>(0, 3);
         brick(s).transform(0, 3) += pixel_size(s, at);
       },
       false},
      {"cube missing",
       [](VisualScene& s) {
         auto& cubes = s.instances[static_cast<int>(Primitive::cube)];
         cubes.erase(cubes.begin() + static_cast<std::ptrdiff_t>(cubes.size() / 2));
       },
       true},
      {"line missing", [](VisualScene& s) { s.lines.clear(); }, true},
      {"shadow missing",
       [](VisualScene& s) {
         for (Instance& cube : s.instances[static_cast<int>(Primitive::cube)]) cube.shadow = false;
       },
       true},
  };
  return all;
}

}  // namespace

TEST_CASE("every mutation of the pyramid fails the comparison within a class") {
  Studio studio(kWidth, kHeight);
  const VisualScene original = pyramid();
  const Image expected = studio.frame(original);
  CHECK(compare_images(studio.frame(original), expected, CompareTier::same_class).equal);
  for (const Mutation& mutation : mutations()) {
    VisualScene scene = original;
    mutation.apply(scene);
    const Image actual = studio.frame(scene);
    INFO(mutation.name);
    CHECK_FALSE(compare_images(actual, expected, CompareTier::same_class).equal);
    CHECK(compare_images(actual, expected, CompareTier::cross_class).equal == !mutation.seen_across_classes);
  }
}

}  // namespace pabd::test_mutations
