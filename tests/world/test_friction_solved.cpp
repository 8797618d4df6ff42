// SPDX-License-Identifier: MIT
// What slides and tips at once: friction tips a body, which moves the load from one corner to another, and with it the
// friction. A solver whose friction follows the load an iteration late does not converge there in 20 iterations.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/world/world.h"

namespace pabd::test_friction_solved {

using namespace world;

// A ladder against a rough wall, a textbook question: Meriam and Kraige, Statics, chapter 6.
TEST_CASE("a ladder slips below tan θ = (1 − μ_f μ_w) / 2 μ_f and holds above, each step solved") {
  const double mu = GENERATE(0.25, 0.4, 0.6), h = GENERATE(1.0 / 30, 1.0 / 60, 1.0 / 240),
               length = GENERATE(0.3, 3.0);
  const double least = std::atan((1 - mu * mu) / (2 * mu)) / kDegree;
  for (const double beyond : {-1.5, 1.5}) {
    const double theta = (least + beyond) * kDegree;
    CAPTURE(mu, h, length, least, beyond);
    const double thick = 0.005 * length, d_hat = 0.002 * length;
    Setting setting(h, mu, d_hat);
    setting.ground();
    setting.add(Box{Vec3(0.1, 2, 1) * length}, 0, Vec3(-0.1, 1, 0) * length);
    const Vec3 at(0.5 * length * std::cos(theta) + thick / 2 * std::sin(theta) + d_hat,
                  0.5 * length * std::sin(theta) + thick / 2 * std::cos(theta) + d_hat, 0);
    const std::string ladder =
        setting.add(Box{Vec3(thick, length, 0.2 * length) / 2}, 8, at, about_z(90 - theta / kDegree));
    Run run(setting);
    const double fall = std::sqrt(length / kG);  // s, the scale of its fall
    run.go(h);                                   // it lands
    run.at_limit = 0;
    run.go(0.8 * fall);
    const Vec3 before = run.c(ladder);
    run.go(0.8 * fall);
    if (beyond > 0) {
      CHECK((run.c(ladder) - before).norm() < 1e-5 * length);
    } else {
      CHECK(run.c(ladder).x() - before.x() > 0.01 * length);
    }
    CHECK(run.at_limit == 0);
  }
}

TEST_CASE("a cube that slides and spins on its corners is solved in every step, and makes no energy") {
  const double mu = GENERATE(0.2, 0.4, 0.7), h = GENERATE(1.0 / 30, 1.0 / 60, 1.0 / 240),
               edge = GENERATE(0.05, 0.5), turn = GENERATE(0.0, 20.0, 45.0);
  CAPTURE(mu, h, edge, turn);
  Setting setting(h, mu, 0.02 * edge);
  setting.ground();
  const spec::Orientation yaw = spec::AxisAngle{Vec3::UnitY(), turn};
  setting.add({.shape = Box{Vec3::Constant(edge / 2)},
               .mass = 2.0,
               .position = Vec3(0, 0.52 * edge, 0),
               .orientation = yaw,
               .velocity = Vec3(3, 0, 1),
               .angular_velocity = Vec3(0, 4, 0)});
  Run run(setting);
  run.go(1);
  CHECK(run.at_limit == 0);
  CHECK(run.halved == 0);
  CHECK(run.rise < 1e-9);
}

// Each box is hit while it stands 2 cm from the next: where its free flight ends tells nothing of that one.
TEST_CASE("a row of boxes that is pushed is solved but for its hits, and none ends in the next") {
  const double h = GENERATE(1.0 / 60, 1.0 / 240), mu = GENERATE(0.2, 0.4), aside = GENERATE(0.0, 0.1);
  const int count = GENERATE(3, 8);
  CAPTURE(h, mu, aside, count);
  const double edge = 0.4;
  Setting setting(h, mu, 0.01);
  setting.ground();
  for (int k = 0; k < count; ++k)
    setting.add(Box{Vec3::Constant(edge / 2)}, 64, Vec3(1.05 * edge * k, edge / 2, 0));
  setting.add({.shape = Box{Vec3::Constant(edge / 2)},
               .mass = 256.0,
               .position = Vec3(-1.5, edge / 2, aside * edge),
               .velocity = Vec3(8, 0, 0)});
  Run run(setting);
  run.go(1.5);
  CHECK(run.at_limit <= 7);  // there are as many hits at any h
  CHECK(run.overlap < 0.1 * edge);
}

}  // namespace pabd::test_friction_solved
