// SPDX-License-Identifier: MIT
// Where two bodies are nearest or deepest, when that is not where the face is that separates them best.
#include <catch2/catch.hpp>

#include "sim/body/convex_hull.h"
#include "sim/math/so3.h"
#include "tests/collision/reference.h"

namespace pabd::test_nearest_places {

using namespace reference;

namespace {

Mat3 turn(double radians, const Vec3& axis) {
  return Eigen::AngleAxisd(radians, axis.normalized()).toRotationMatrix();
}

double smallest_d(const std::vector<ContactPoint>& contacts) {
  double d = 1e300;
  for (const ContactPoint& p : contacts) d = std::min(d, p.d);
  return d;
}

// A hull that stays where its corners are.
void add_hull(Setup& setup, const std::vector<Vec3>& corners) {
  const auto hull = make_hull(corners).hull;
  setup.add(Hull{hull}, hull->centroid);
}

}  // namespace

TEST_CASE("a corner that points at an edge, where no face keeps the two apart") {
  // A corner of b points along (−1, −1, 0) at the middle of an upright edge of a: (gap, gap)/√2 away from it.
  // Each face plane of either cuts the other body.
  const double half = 0.5, gap = 0.02;
  const Vec3 diagonal = Vec3(1, 1, 0).normalized(), edge(half, half, 0.1);
  for (const double size : {0.5, 0.25}) {
    for (int k = 0; k < 24; ++k) {
      const Mat3 R = turn(0.25 * k, diagonal) * rotation_between(Vec3(1, 1, 1), diagonal);
      const Vec3 c = edge + (gap + size * std::sqrt(3.0)) * diagonal;
      for (const bool hulls : {false, true}) {
        Setup setup;
        setup.add(hulls ? hull_of_box(Vec3::Constant(half)) : Shape(Box{Vec3::Constant(half)}), Vec3::Zero());
        setup.add(hulls ? hull_of_box(Vec3::Constant(size)) : Shape(Box{Vec3::Constant(size)}), c, R);
        INFO("half edge " << size << ", turned by " << 0.25 * k << (hulls ? ", hulls" : ", boxes"));
        CHECK(smallest_d(setup.contacts()) == Approx(gap).epsilon(1e-9));
      }
    }
  }
}

TEST_CASE("edges that cross, where a face that separates nearly as well has nothing above it") {
  Setup setup;
  setup.add(Box{{0.3, 0.5, 0.4}}, Vec3::Zero());
  add_hull(setup, {{-0.536, 0.458, 0.722},
                   {-0.076, 0.796, 1.026},
                   {-0.122, 0.550, 1.193},
                   {-0.404, 0.078, 0.838},
                   {0.017, 0.246, 1.195},
                   {0.069, 0.819, 0.472},
                   {0.177, 0.180, 1.115},
                   {0.344, 0.306, 1.029},
                   {-0.080, -0.045, 0.500},
                   {0.347, 0.583, 0.464},
                   {0.434, 0.541, 0.645},
                   {-0.018, -0.024, 0.459},
                   {0.438, 0.506, 0.620},
                   {0.334, 0.206, 0.454}});
  const double s = signed_distance(setup, 0, 1);
  CHECK(smallest_d(setup.contacts()) == Approx(s).margin(0.021 * s + 3e-4));
}

TEST_CASE("what is below a face but beyond the body is no overlap") {
  Setup setup;
  add_hull(
      setup,
      {{0.219, 0.772, -0.323}, {-0.241, -0.666, -0.332}, {0.304, 0.544, 0.487}, {-0.282, -0.650, 0.167}});
  add_hull(
      setup,
      {{0.220, -1.667, -0.031}, {0.332, -1.331, 1.189}, {-0.040, -0.470, 0.070}, {-1.167, -1.366, 0.550}});
  const double s = signed_distance(setup, 0, 1);
  REQUIRE(s > 0.009);
  CHECK(smallest_d(setup.contacts()) == Approx(s).epsilon(1e-9));
}

TEST_CASE("a stone in a slab is as deep as its lowest corner, however it lies") {
  // Some lie so that the face that looks down most has not got that corner.
  Random random(41);
  const double depth = 0.01;
  const Vec3 slab(3, 1, 3);
  for (const Shape& stone : {rock(10, 0.5, 4), rock(14, 0.5, 5), rock(20, 0.5, 6)}) {
    for (int trial = 0; trial < 1000; ++trial) {
      const Mat3 R = random.rotation();
      const double low = support(stone, Vec3::Zero(), R, -Vec3::UnitY());
      Setup setup;
      setup.add(Box{slab}, Vec3(0, -slab.y(), 0), Mat3::Identity(), 0.01, true);
      setup.add(stone, Vec3(0, low - depth, 0), R, 0.01);
      INFO("trial " << trial);
      const double tolerance = 0.021 * depth + 1e-3 * inner_radius(stone);
      CHECK(smallest_d(setup.contacts()) == Approx(-depth).margin(tolerance));
    }
  }
}

TEST_CASE("a thick capsule beside the rim of a face is as near as it is, not as the face says") {
  // Its lower end is `beyond` the rim and one radius and `gap` above the face; from there it rises over it.
  const double radius = 0.3, half = 0.5;
  for (const double rise : {0.02, 0.05, 0.1, 0.2}) {
    for (const double beyond : {0.02, 0.04, 0.06}) {
      for (const double gap : {-0.002, 0.001, 0.01}) {
        for (const bool hull : {false, true}) {
          const Vec3 u = Vec3(-1, rise, 0).normalized(), end(half + beyond, half + radius + gap, 0);
          Setup setup;
          setup.add(hull ? hull_of_box(Vec3::Constant(half)) : Shape(Box{Vec3::Constant(half)}),
                    Vec3::Zero());
          setup.add(Capsule{radius, 1}, end + 0.5 * u, rotation_between(Vec3::UnitY(), u));
          const double s = signed_distance(setup, 0, 1);
          INFO("rise " << rise << ", beyond " << beyond << ", gap " << gap << (hull ? ", hull" : ", box"));
          CHECK(smallest_d(setup.contacts()) == Approx(s).margin(0.021 * std::abs(s) + 1e-3 * half));
        }
      }
    }
  }
}

TEST_CASE("a capsule that stands askew on a face of a hull touches it with the end of its cap") {
  for (const double askew : {0.1, 0.4, 1.0, 1.5}) {
    for (const double around : {0.0, 1.0, 2.5, 4.0}) {
      const Vec3 u(std::sin(askew) * std::cos(around), std::cos(askew), std::sin(askew) * std::sin(around));
      const Shape shapes[] = {Box{{1, 0.5, 1}}, hull_of_box({1, 0.5, 1})};
      std::vector<ContactPoint> contacts[2];
      for (int k = 0; k < 2; ++k) {
        Setup setup;
        setup.add(shapes[k], Vec3::Zero());
        setup.add(Capsule{0.1, 0.6}, Vec3(0, 0.5 + 0.1 + 0.004, 0) + 0.3 * u,
                  rotation_between(Vec3::UnitY(), u));
        contacts[k] = setup.contacts();
      }
      INFO("askew by " << askew);
      CHECK(smallest_d(contacts[1]) == Approx(0.004).epsilon(1e-9));
      REQUIRE(contacts[0].size() == contacts[1].size());
      for (std::size_t k = 0; k < contacts[0].size(); ++k)
        CHECK((contacts[0][k].y_b - contacts[1][k].y_b).norm() < 1e-12);
    }
  }
}

TEST_CASE("capsules that lean on each other touch with a cap where the side would be past its end") {
  const Capsule longer{0.1, 1}, shorter{0.3, 0.8};
  for (const double lean : {-0.19, -0.1, 0.02, 0.15}) {
    for (double past = -0.05; past < 0.1; past += 0.004) {
      // The end of the long axis is `past` inside the end of the short one, which leans towards it.
      const Vec3 u = Vec3::UnitY(), v(std::sin(lean), std::cos(lean), 0);
      Setup setup;
      setup.add(longer, -0.5 * longer.length * u);
      setup.add(shorter, Vec3(0.42, 0, 0) - (0.5 * shorter.length - past) * v,
                rotation_between(Vec3::UnitY(), v));
      INFO("lean " << lean << ", past " << past);
      const auto contacts = setup.contacts();
      for (const ContactPoint& p : contacts) {
        const auto a = static_cast<std::size_t>(p.a), b = static_cast<std::size_t>(p.b);
        CHECK(std::abs(surface_distance(setup.model.shape[b], setup.c[b], setup.R[b], p.y_b)) < 1e-12);
        CHECK(std::abs(surface_distance(setup.model.shape[a], setup.c[a], setup.R[a], p.y_a)) < 1e-12);
      }
      CHECK(smallest_d(contacts) == Approx(signed_distance(setup, 0, 1)).margin(1e-9));
    }
  }
}

TEST_CASE("thin capsules that cross at less than a hundredth are nearest where they cross") {
  const Capsule thin{0.01, 2};
  for (const double angle : {0.0005, 0.002, 0.005, 0.009, 0.011}) {
    for (const double gap : {-0.002, 0.001, 0.01}) {
      Setup setup;
      setup.add(thin, Vec3::Zero());
      setup.add(thin, Vec3(2 * thin.radius + gap, 0, 0), turn(angle, Vec3::UnitX()));
      INFO("angle " << angle << ", gap " << gap);
      CHECK(smallest_d(setup.contacts()) == Approx(gap).margin(0.02 * std::abs(gap) + 1e-3 * thin.radius));
    }
  }
}

}  // namespace pabd::test_nearest_places
