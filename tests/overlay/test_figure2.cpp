// SPDX-License-Identifier: MIT
// Figure 2 shows the bond points of its three joints, and fits any frame.
#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "app/overlay/figure2.h"

namespace pabd::test_figure2 {

TEST_CASE("the three lower pairs have their names and 4 + 2 + 1 bonds") {
  const VisualScene scene = figure2(1600.0 / 700);
  // Each bond: rim and disc of y_j, dot of y_i; and the one flat face of the cup.
  const auto& discs = scene.instances[static_cast<int>(Primitive::disc)];
  CHECK(discs.size() == 3 * (4 + 2 + 1) + 1);
  int names = 0;
  for (const Label& label : scene.labels) {
    for (const char* name : {"slider", "hinge", "spherical", "*{λ}", "*{θ}"}) names += label.text == name;
  }
  CHECK(names == 5);
}

TEST_CASE("labels stay inside wide and tall frames") {
  for (const double aspect : {0.6, 1.0, 16.0 / 9, 3.0}) {
    const VisualScene scene = figure2(aspect);
    const Mat4f clip =
        projection_matrix(scene.camera, static_cast<float>(aspect), 0.1f, 100) * view_matrix(scene.camera);
    for (const Label& label : scene.labels) {
      const Vec4f p = clip * label.position.homogeneous();
      INFO(aspect << " " << label.text);
      CHECK(std::abs(p.x() / p.w()) < 0.95f);
      CHECK(std::abs(p.y() / p.w()) < 0.95f);
    }
  }
}

}  // namespace pabd::test_figure2
