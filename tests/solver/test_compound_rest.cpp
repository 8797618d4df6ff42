// SPDX-License-Identifier: MIT
// Compounds in motion: an L rests with the right force, pieces of a box behave as the box, a bowl holds a
// ball.
#include <catch2/catch.hpp>

#include "sim/body/compound.h"
#include "sim/math/so3.h"
#include "tests/support/hulls.h"
#include "tests/support/scenario.h"

namespace pabd::test_compound_rest {

using testing::hull_of;
using testing::World;

namespace {

Hull box(const Vec3& lo, const Vec3& hi) {
  std::vector<Vec3> points;
  for (int k = 0; k < 8; ++k) {
    points.emplace_back(k & 1 ? hi.x() : lo.x(), k & 2 ? hi.y() : lo.y(), k & 4 ? hi.z() : lo.z());
  }
  return hull_of(points);
}

Compound L_shape() {
  return make_compound({box({0, 0, -0.2}, {1, 0.2, 0.2}), box({0, 0.2, -0.2}, {0.2, 1, 0.2})});
}

// A square floor and four walls that lean outwards, mitred; the inner foot is 1 × 1.
Compound bowl() {
  std::vector<Hull> parts{box({-0.5, 0, -0.5}, {0.5, 0.08, 0.5})};
  for (int side = 0; side < 4; ++side) {
    const Mat3 R = exp_so3({0, side * kPi / 2, 0});
    std::vector<Vec3> points;
    for (const double lean : {0.0, 0.2}) {
      for (const double x : {0.5, 0.58}) {
        for (const double z : {-1.0, 1.0}) {
          points.push_back(R * Vec3(x + lean, lean == 0 ? 0 : 0.5, z * (x + lean)));
        }
      }
    }
    parts.push_back(hull_of(points));
  }
  return make_compound(parts);
}

}  // namespace

TEST_CASE("an L comes to rest; its contacts carry the weight below its centre of mass") {
  World world;
  world.add_ground();
  const double mass = 60;
  const Compound L = L_shape();
  world.add(L, mass, {0, L.data->centroid.y() + 0.05, 0}, exp_so3({0.05, 0.6, 0.03}));
  StepReport last;
  testing::run(world, 400, {false, true, 1}, [&](const StepReport& r) { last = r; });
  CHECK(last.kinetic < 1e-8);
  CHECK(last.min_gap > 0);
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
  for (const ContactReport& c : last.contact_reports) {
    const Vec3 f = c.normal_force * c.n + c.friction;
    force += f;
    torque += (c.y_b - world.state.c[1]).cross(f);
  }
  const double weight = mass * 9.81;
  CHECK((force - Vec3(0, weight, 0)).norm() < 1e-3 * weight);
  CHECK(torque.norm() < 1e-3 * weight * 0.5);
  CHECK(world.state.c[1].y() == Approx(L.data->centroid.y()).margin(0.01));  // on its long leg
}

TEST_CASE("an L sticks to a slope below the friction angle") {
  // tan 20° = 0.36 < μ = 0.5. Named contacts are remembered: it does not creep.
  World world;
  const double slope = 20 * kPi / 180;
  const Vec3 n(std::sin(slope), std::cos(slope), 0);
  world.add_ground(n);
  world.params.contact.mu_static = world.params.contact.mu_dynamic = 0.5;
  const Compound L = L_shape();
  const Mat3 R = exp_so3({0, 0, -slope});
  world.add(L, 60, R * Vec3(0, L.data->centroid.y() + 0.0095, 0), R);
  testing::run(world, 60);
  const Vec3 before = world.state.c[1];
  testing::run(world, 240);
  CHECK((world.state.c[1] - before).norm() < 1e-5);
}

TEST_CASE("a box in two pieces stands and slides as the box does") {
  const auto run = [](const Shape& shape) {
    World world;
    world.add_ground();
    world.add(shape, 100, {0, 0.51, 0});
    world.state.v[1] = {1.5, 0, 0};
    testing::run(world, 120);
    CHECK(world.state.v[1].norm() < 1e-6);
    return world.state.c[1];
  };
  const Vec3 whole = run(box(Vec3::Constant(-0.5), Vec3::Constant(0.5)));
  const Vec3 pieces =
      run(make_compound({box({-0.5, -0.5, -0.5}, {0, 0.5, 0.5}), box({0, -0.5, -0.5}, {0.5, 0.5, 0.5})}));
  CHECK(whole.x() > 0.1);  // it slid: v²/(2 μ g) = 0.23 m
  CHECK((pieces - whole).norm() < 0.01 * whole.x());
}

TEST_CASE("a bowl holds a ball, and both come to rest, for every number of threads") {
  const Compound shape = bowl();
  const Index dish = 1, ball = 2;
  const auto thrown_in = [&] {
    World world;
    world.add_ground();
    world.add(shape, 30, {0, shape.data->centroid.y() + 0.01, 0});
    world.add(Sphere{0.15}, 5, {0.25, 0.9, 0.1});
    return world;
  };
  World one = thrown_in(), two = thrown_in();
  testing::run(one, 60, {false, false, 1});
  testing::run(two, 60, {false, false, 2});
  for (std::size_t i = 0; i < one.state.c.size(); ++i) {
    CHECK(one.state.c[i] == two.state.c[i]);
    CHECK(one.state.R[i] == two.state.R[i]);
  }
  StepReport last;
  testing::run(one, 840, {false, true, 1}, [&](const StepReport& r) { last = r; });
  CHECK(last.status != StepStatus::non_finite);
  const Vec3 from = one.state.c[ball] - one.state.c[dish];
  CHECK(std::abs(from.x()) < 0.5);
  CHECK(std::abs(from.z()) < 0.5);
  CHECK(one.state.c[ball].y() == Approx(0.08 + 0.15).margin(0.03));
  Vec3 on_ball = Vec3::Zero();
  for (const ContactReport& c : last.contact_reports) {
    const Vec3 f = c.normal_force * c.n + c.friction;
    if (c.b == ball) on_ball += f;
    if (c.a == ball) on_ball -= f;
  }
  CHECK((on_ball - Vec3(0, 5 * 9.81, 0)).norm() < 0.02 * 5 * 9.81);
}

}  // namespace pabd::test_compound_rest
