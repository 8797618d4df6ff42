// SPDX-License-Identifier: MIT
// Where on their way bodies are looked at (Deviation D7).
#include <catch2/catch.hpp>

#include "sim/collision/detect.h"
#include "sim/math/so3.h"
#include "tests/collision/reference.h"

namespace pabd::test_passage {

using namespace reference;

namespace {

// Two bodies, of which the second one flies and turns.
struct Flight {
  Setup start;
  Vec3 way, turn = Vec3::Zero();
  double spin = 0;  // m

  std::vector<ContactPoint> contacts() const {
    const std::vector<Vec3> ways{Vec3::Zero(), way}, turns{Vec3::Zero(), turn};
    const std::vector<double> spins{0, spin};
    const Passage passage{start.c, start.R, ways, turns, spins, 0.01};
    const std::vector<Vec3> c{start.c[0], start.c[1] + way};
    const std::vector<Mat3> R{start.R[0], exp_so3(turn) * start.R[1]};
    const std::vector<double> reach{0.005, 0.005 + way.norm() + spin};
    CollisionWorkspace workspace;
    std::vector<ContactPoint> out;
    detect(start.model, c, R, passage, reach, {}, 1, workspace, out);
    return out;
  }
};

}  // namespace

TEST_CASE("a ball that would be behind a wall is looked at where it first touches it") {
  for (const double thickness : {0.002, 0.05, 0.5}) {
    for (const double speed : {1.0, 3.0, 10.0}) {  // a step; m
      for (const double slant : {0.0, 0.7}) {
        CAPTURE(thickness, speed, slant);
        Flight flight;
        flight.start.add(Box{{thickness / 2, 4, 4}}, Vec3::Zero(), Mat3::Identity(), 0.005, true);
        flight.start.add(Sphere{0.03}, {-0.4, 0, 0}, Mat3::Identity(), 0.005);
        flight.way = speed * Vec3(1, slant, 0);
        const auto found = flight.contacts();
        REQUIRE(found.size() == 1);
        CHECK(found[0].part < 1);
        CHECK(found[0].d > 0);
        CHECK(found[0].d < 0.01);
        CHECK(found[0].n == Vec3(-1, 0, 0));
        CHECK(found[0].least_start_d == 0.01);
      }
    }
  }
}

TEST_CASE("what rolls over a floor, however fast, is looked at where it comes to") {
  for (const double turn : {0.1, 1.0, 3.0}) {
    CAPTURE(turn);
    Flight flight;
    flight.start.add(Box{{50, 0.05, 4}}, {0, -0.05, 0}, Mat3::Identity(), 0.005, true);
    flight.start.add(Sphere{0.3}, {-0.4, 0.309, 0}, Mat3::Identity(), 0.005);
    flight.way = {0.3 * turn, 0, 0};
    flight.turn = {0, 0, -turn};
    const auto found = flight.contacts();
    REQUIRE(found.size() == 1);
    CHECK(found[0].part == 1);
    CHECK(found[0].y_b.x() == Approx(-0.4 + 0.3 * turn));
    CHECK(found[0].least_start_d == Approx(0.009));
  }
}

TEST_CASE("a box that falls past another is looked at where it first touches it, not beside it") {
  for (const double beside : {0.005, 0.02}) {  // how far the one reaches over the other; m
    for (const double fall : {0.05, 0.1}) {
      CAPTURE(beside, fall);
      Flight flight;
      flight.start.add(Box{{0.25, 0.25, 0.25}}, Vec3::Zero(), Mat3::Identity(), 0.005, true);
      flight.start.add(Box{{0.25, 0.25, 0.25}}, {0.5 - beside, 0.52, 0}, Mat3::Identity(), 0.005);
      flight.way = fall * -Vec3::UnitY();
      const auto found = flight.contacts();
      REQUIRE_FALSE(found.empty());
      for (const ContactPoint& point : found) {
        CHECK(std::abs(point.n.y()) == Approx(1));
        CHECK(point.d > 0);
        CHECK(point.least_start_d == Approx(0.01));
      }
    }
  }
}

TEST_CASE("a rod whose end swings through a wall is looked at on its way") {
  Flight flight;
  flight.start.add(Box{{0.01, 4, 4}}, {0.05, 0, 0}, Mat3::Identity(), 0.005, true);
  flight.start.add(Box{{0.02, 1, 0.02}}, {0, -1.2, 0}, Mat3::Identity(), 0.005);
  flight.way = Vec3::Zero();
  flight.turn = {0, 0, -1.2};  // its upper end goes towards +x
  flight.spin = 1.2;
  const auto found = flight.contacts();
  REQUIRE_FALSE(found.empty());
  for (const ContactPoint& p : found) CHECK(p.part < 1);
}

}  // namespace pabd::test_passage
