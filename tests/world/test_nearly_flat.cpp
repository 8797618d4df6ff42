// SPDX-License-Identifier: MIT
// What falls nearly flat on another: contacts that are found in each step anew are about those of the step before, so
// that no energy comes from finding them.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/hulls.h"
#include "tests/world/world.h"

namespace pabd::test_nearly_flat {

using namespace world;

namespace {

spec::Orientation tilted(double degrees, double turn) {
  const double rad = kPi / 180;
  const Eigen::Quaterniond q(Eigen::AngleAxisd(turn * rad, Vec3::UnitY()) *
                             Eigen::AngleAxisd(degrees * rad, Vec3(1, 0, 0.6).normalized()));
  return {q.w(), q.x(), q.y(), q.z()};
}

std::vector<Vec3> corners_of_cube() {
  std::vector<Vec3> corners;
  for (int k = 0; k < 8; ++k)
    corners.emplace_back(k & 1 ? 0.5 : -0.5, k & 2 ? 0.5 : -0.5, k & 4 ? 0.5 : -0.5);
  return corners;
}

}  // namespace

// Taken for edges in one step, with one point, and for faces in the next, with four, such cubes gained up to three
// quarters of their energy in a step.
TEST_CASE("a cube that falls nearly flat on another gains no energy in any step") {
  const bool hulls = GENERATE(false, true);
  const double tilt = GENERATE(0.5, 1.0, 2.0, 3.0), turn = GENERATE(0.0, 20.0, 45.0),
               d_hat = GENERATE(0.02, 0.05, 0.1), h = GENERATE(1.0 / 30, 1.0 / 60, 1.0 / 240);
  CAPTURE(hulls, tilt, turn, d_hat, h);
  Setting setting(h, 0.3, d_hat);
  setting.ground();
  setting.add(Box{Vec3::Constant(0.5)}, 1000, {0, 0.5 + d_hat, 0});
  const Vec3 above(0.15, 1.65 + d_hat, 0.08);
  const Shape cube = hulls ? Shape(testing::hull_of(corners_of_cube())) : Shape(Box{Vec3::Constant(0.5)});
  setting.add(cube, 1000, above, tilted(tilt, turn));
  Run run(setting);
  double last = run.begin, most = 0, gained = 0;
  run.go(2, [&] {
    const StepReport& made = run.report;
    const double energy = made.kinetic + made.potential + made.elastic;
    most = std::max(most, made.kinetic + made.elastic);
    gained = std::max(gained, energy - last);
    last = energy;
  });
  CHECK(gained < 1e-4 * most);
}

}  // namespace pabd::test_nearly_flat
