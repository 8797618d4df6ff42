// SPDX-License-Identifier: MIT
// Two plates that lean on each other, edge on edge: an A-frame stands at the friction that statics says.
//
// Thickness T, height H, tilt θ. Both carry their weight on the inner bottom edge; at the top they push each
// other with N, level by symmetry. Moments about the bottom edge: N H cos θ = m g (H sin θ − T cos θ)/2, and
// the ground holds N by friction:
//
//   μ_min = N/(m g) = tan θ/2 − T/(2H)

#include <catch2/catch.hpp>
#include <cmath>

#include "sim/math/so3.h"
#include "tests/support/hulls.h"
#include "tests/support/scenario.h"

namespace pabd::test_plates {

using testing::World;

namespace {

struct Plates {
  double thickness, height, width, degrees;

  double tilt() const { return degrees * kPi / 180; }
  double least_friction() const { return 0.5 * std::tan(tilt()) - 0.5 * thickness / height; }
  Shape shape(bool as_hull) const {
    const Vec3 half(0.5 * thickness, 0.5 * height, 0.5 * width);
    if (!as_hull) return Box{half};
    std::vector<Vec3> corners;
    for (int k = 0; k < 8; ++k)
      corners.push_back(half.cwiseProduct(Vec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1)));
    return testing::hull_of(corners);
  }
};

// The frame, its plates turned by `disturbed` out of line.
World frame(const Plates& p, bool as_hull, double mu, double h, SolverMethod method, double disturbed) {
  World world;
  world.params.h = h;
  world.params.solver.method = method;
  const double d_hat = 0.1 * p.thickness;
  world.params.contact.d_hat = d_hat;
  world.params.contact.mu_static = world.params.contact.mu_dynamic = mu;
  world.add_ground();
  const Shape shape = p.shape(as_hull);
  for (const int side : {-1, 1}) {
    const Mat3 R = exp_so3({0, 0, side * p.tilt()});
    const Vec3 top = R * Vec3(-0.5 * side * p.thickness, 0.5 * p.height, 0);
    const Vec3 bottom = R * Vec3(-0.5 * side * p.thickness, -0.5 * p.height, 0);
    const Vec3 c(0.45 * side * d_hat - top.x(), 0.9 * d_hat - bottom.y(), 0);
    world.add(shape, 6, c, exp_so3({side * disturbed, disturbed, 0}) * R);
  }
  return world;
}

const Plates kPlates[] = {{0.02, 1.0, 0.6, 15}, {0.03, 0.7, 0.4, 30}, {0.01, 0.5, 0.8, 22}};

}  // namespace

TEST_CASE("an A-frame of plates stands with 5 % more friction than statics says and falls with 5 % less") {
  for (const Plates& p : kPlates) {
    for (const bool as_hull : {false, true}) {
      for (const SolverMethod method : {SolverMethod::automatic, SolverMethod::descent}) {
        INFO(p.degrees << "°, hull " << as_hull << ", " << to_string(method));
        World stands = frame(p, as_hull, 1.05 * p.least_friction(), 1.0 / 240, method, 0);
        const double height = stands.state.c[1].y();
        testing::run(stands, 360);
        CHECK(stands.state.c[1].y() == Approx(height).epsilon(0.01));
        CHECK(stands.state.v[1].norm() + stands.state.omega[1].norm() < 1e-6);
        CHECK((stands.state.R[1].col(2) - stands.state.R[2].col(2)).norm() < 1e-9);  // no twist

        World falls = frame(p, as_hull, 0.95 * p.least_friction(), 1.0 / 240, method, 0);
        testing::run(falls, 360);
        CHECK(falls.state.c[1].y() < 0.8 * height);
      }
    }
  }
}

TEST_CASE("plates a little out of line come to rest, and their twist does not grow") {
  for (const Plates& p : kPlates) {
    for (const bool as_hull : {false, true}) {
      for (const double h : {1.0 / 60, 1.0 / 240}) {
        INFO(p.degrees << "°, hull " << as_hull << ", h " << h);
        World world = frame(p, as_hull, 1.15 * p.least_friction(), h, SolverMethod::automatic, 3e-4);
        const auto twist = [&] { return (world.state.R[1].col(2) - world.state.R[2].col(2)).norm(); };
        const double height = world.state.c[1].y(), before = twist();
        testing::run(world, static_cast<int>(2 / h));
        CHECK(world.state.c[1].y() == Approx(height).epsilon(0.01));
        CHECK(world.state.v[1].norm() + world.state.omega[1].norm() < 1e-6);
        CHECK(twist() < 1.5 * before);
      }
    }
  }
}

}  // namespace pabd::test_plates
