// SPDX-License-Identifier: MIT
// What slides and what holds, against Coulomb's law in closed form.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/world/world.h"

namespace pabd::test_sliding {

using namespace world;

namespace {

struct Size {
  double edge, h;
};
Size size_and_step() {
  return GENERATE(Size{0.05, 1.0 / 60}, Size{0.3, 1.0 / 30}, Size{0.4, 1.0 / 240}, Size{2, 1.0 / 1000});
}

// A box of the given half edges at rest on a slope, just out of touch.
std::string on_slope(Setting& setting, double degrees, const Vec3& half, double mass, double along = 0) {
  const double gap = setting.builder.params.contact.d_hat;
  return setting.add(Box{half}, mass, along * downhill(degrees) + (half.y() + gap) * uphill_normal(degrees),
                     about_z(-degrees));
}

}  // namespace

// A crate on a slope just below the friction angle creeps: matter-js issue 752, newton pull request 2549.
TEST_CASE("a crate holds a degree below the friction angle and slides a degree above it") {
  const Size s = size_and_step();
  const double mu = GENERATE(0.2, 0.7), limit = std::atan(mu) / kDegree;
  CAPTURE(s.edge, s.h, mu);
  const double d_hat = 0.02 * s.edge;
  Setting below(s.h, mu, d_hat), above(s.h, mu, d_hat);
  below.slope(limit - 1);
  above.slope(limit + 1);
  const Vec3 half = Vec3(1, 0.3, 0.8) * s.edge / 2;
  const std::string held = on_slope(below, limit - 1, half, 3), slides = on_slope(above, limit + 1, half, 3);
  Run holds(below), goes(above);
  holds.go(0.5);
  const Vec3 before = holds.c(held);
  holds.go(2);
  CHECK((holds.c(held) - before).norm() < 1e-6 * s.edge);
  goes.go(0.5);
  const double v = goes.v(slides).norm();
  goes.go(0.5);
  const double angle = (limit + 1) * kDegree;
  CHECK(goes.v(slides).norm() - v ==
        Approx(0.5 * kG * (std::sin(angle) - mu * std::cos(angle))).epsilon(0.01));
  CHECK(goes.rise < 1e-9);
}

// A thrown box stops after v²/2μg: newton's tests of dynamic friction, matter-js issue 612.
TEST_CASE("a box that is thrown along the floor stops after v²/(2 μ g)") {
  const Size s = size_and_step();
  const double mu = GENERATE(0.15, 0.6), v = 2.5;
  CAPTURE(s.edge, s.h, mu);
  Setting setting(s.h, mu, 0.02 * s.edge);
  setting.ground();
  // Flat, so that it neither tips nor pitches.
  const std::string box = setting.add({.shape = Box{Vec3(1, 0.1, 1) * s.edge / 2},
                                       .mass = 2.0,
                                       .position = Vec3(0, 0.07 * s.edge, 0),
                                       .velocity = Vec3(v, 0, 0)});
  Run run(setting);
  run.go(2.5);
  // The speed falls by μ g h a step, and moves the box only afterwards: half a step of way less.
  CHECK(run.way(box).x() == Approx(v * v / (2 * mu * kG) - v * s.h / 2).epsilon(0.01));
  CHECK(run.v(box).norm() < 1e-6);
}

// Tipping or sliding, a textbook question: Meriam and Kraige, Statics, chapter 6.
TEST_CASE("on a slope that steepens a block slides if μ is below width over height, else it tips") {
  const double width = GENERATE(0.2, 0.5), h = GENERATE(1.0 / 60, 1.0 / 240);
  const double height = GENERATE(0.4, 1.0);
  for (const double share : {0.9, 1.1}) {
    const double mu = share * width / height,
                 degrees = std::atan(std::max(1.04, 1.04 * share) * width / height) / kDegree;
    Setting setting(h, mu, 0.004);
    setting.slope(degrees);
    const std::string block = on_slope(setting, degrees, Vec3(width, height, 0.4) / 2, 5);
    Run run(setting);
    run.go(1);
    CAPTURE(width, height, h, mu, degrees);
    const double tilt = std::acos(run.R(block).col(1).dot(uphill_normal(degrees))) / kDegree;
    CHECK((share > 1) == (tilt > 8));
    CHECK((share < 1) == (run.way(block).dot(downhill(degrees)) > 0.02 && tilt < 1));
  }
}

// A belt that starts faster than friction allows: conveyors of the engines' forums, T1 of the findings.
TEST_CASE("a box on a belt that starts too fast is taken along with μ g, whatever its mass") {
  const double mu = GENERATE(0.1, 0.35), mass = GENERATE(0.05, 0.2, 2.0, 300.0);
  const double h = GENERATE(1.0 / 60, 1.0 / 240), belt_speed = GENERATE(3.0, 7.0);
  const double gap = GENERATE(0.0099, 0.01);  // just within d̂, and not
  CAPTURE(mu, mass, h, belt_speed, gap);
  Setting setting(h, mu);
  const std::string belt = setting.add(Box{{12, 0.1, 0.5}}, 60, {0, 0.1, 0});
  const std::string box = setting.add(Box{{0.2, 0.1, 0.15}}, mass, {-4, 0.3 + gap, 0});
  setting.builder.add(spec::Joint{.type = JointType::slider,
                                  .j = belt,
                                  .anchor = Vec3(0, 0.1, 0),
                                  .axis = Vec3::UnitX(),
                                  .drive = Profile{{{0, 0}, {2, 2 * belt_speed}}}});
  Run run(setting);
  for (const double time : {0.3, 0.6, 0.8}) {
    run.go(time - run.state.time);
    CHECK(run.v(box).x() == Approx(mu * kG * run.state.time).epsilon(0.02));
  }
  CHECK(run.v(belt).x() == Approx(belt_speed).epsilon(1e-4));
}

// Momentum of two bodies that rub: what slides off a thrown board, without a ground that holds.
TEST_CASE("a board that is thrown under a box takes it along to one speed, after v² / (2 μ g (1 + m/M))") {
  const double ratio = GENERATE(0.01, 1.0, 10.0), h = GENERATE(1.0 / 60, 1.0 / 500);
  const double mu = 0.3, v = 1.5, M = 4, m = ratio * M;
  CAPTURE(ratio, h);
  Setting setting(h, mu, 0.002);
  spec::Body floor;
  floor.shape = Plane{Vec3::UnitY(), 0};
  floor.friction = SurfaceFriction{0, 0};
  setting.add(floor);
  const SurfaceFriction rough{mu, mu};
  const std::string board = setting.add(
      {.shape = Box{{1, 0.02, 0.3}}, .mass = M, .position = Vec3(0, 0.022, 0), .friction = rough});
  const std::string box = setting.add(
      {.shape = Box{{0.1, 0.03, 0.1}}, .mass = m, .position = Vec3(0, 0.0741, 0), .friction = rough});
  Run run(setting);
  run.go(0.3);
  const Vec3 apart = run.c(board) - run.c(box);
  run.send(board, {v, 0, 0});
  run.go(1.2);
  const double together = M * v / (M + m);
  CHECK(run.v(board).x() == Approx(together).epsilon(1e-3));
  CHECK(run.v(box).x() == Approx(together).epsilon(1e-3));
  double slip = 0;  // that of steps of h, each with the speed at its end
  for (double u = v; u > 0; u -= mu * kG * (1 + m / M) * h) slip += u == v ? 0 : u * h;
  CHECK((run.c(board) - run.c(box) - apart).x() == Approx(slip).epsilon(0.02).margin(0.02 * v * h));
  CHECK(run.rise < 1e-9);
}

// A held object creeps out of a gripper: MuJoCo issue 3328, Gazebo issue 2703.
TEST_CASE("two fingers hold a box without creep when 2 μ F exceeds its weight, and else it slips") {
  const double h = GENERATE(1.0 / 60, 1.0 / 240), edge = GENERATE(0.02, 0.2), mu = GENERATE(0.3, 0.8);
  const double m = 2000 * edge * edge * edge;
  for (const double share : {1.3, 0.6}) {  // of the force that holds
    CAPTURE(h, edge, mu, share);
    const double force = share * m * kG / (2 * mu), d_hat = 0.01 * edge;
    Setting setting(h, mu, d_hat);
    const std::string box = setting.add(Box{Vec3::Constant(edge / 2)}, m, Vec3::Zero());
    for (const double side : {-1.0, 1.0}) {
      const Vec3 at(side * (0.65 * edge + 0.9 * d_hat), 0, 0);
      const std::string finger = setting.add(Box{Vec3(0.15, 2, 0.4) * edge}, m, at);
      setting.builder.add(spec::Joint{.type = JointType::slider,
                                      .j = finger,
                                      .anchor = at,
                                      .axis = Vec3(-side, 0, 0),
                                      .motor = spec::Motor{.force = Profile{{{0, force}}}}});
    }
    Run run(setting);
    run.go(share > 1 ? 0.2 : 0.04);  // before it has left the fingers
    const Vec3 c = run.c(box);
    const double v = run.v(box).y(), t = share > 1 ? 3 : 0.05;
    run.go(t);
    if (share > 1) {
      CHECK((run.c(box) - c).norm() < 1e-5 * edge);
    } else {
      const double steps = static_cast<double>(std::lround(t / h));
      CHECK(run.v(box).y() - v == Approx(-steps * h * (kG - 2 * mu * force / m)).epsilon(0.01));
    }
  }
}

// Objects slip in a gripper that moves: bullet3 issue 2607.
TEST_CASE("a box in a gripper goes along with it up to the acceleration 2 μ F/m − g") {
  const double h = GENERATE(1.0 / 60, 1.0 / 240), mu = 0.5, m = 0.3, edge = 0.08;
  const double force = GENERATE(5.0, 8.0), most = 2 * mu * force / m - kG;
  for (const double share : {0.8, 1.25}) {
    CAPTURE(h, force, share);
    const double a = share * most, d_hat = 0.001;
    Setting setting(h, mu, d_hat);
    const std::string box = setting.add(Box{Vec3::Constant(edge / 2)}, m, Vec3::Zero());
    const std::string hand = setting.add(Box{{0.2, 0.02, 0.02}}, 1, {0, 0.2, 0});
    Profile rise;  // at rest for 0.3 s, then y = a t²/2
    for (int k = 0; k <= 60; ++k) rise.keys.emplace_back(0.3 + 0.005 * k, a * 0.005 * k * 0.005 * k / 2);
    setting.builder.add(spec::Joint{.type = JointType::slider,
                                    .j = hand,
                                    .anchor = Vec3(0, 0.2, 0),
                                    .axis = Vec3::UnitY(),
                                    .drive = rise});
    for (const double side : {-1.0, 1.0}) {
      const Vec3 at(side * (0.055 + 0.9 * d_hat), 0, 0);
      const std::string finger = setting.add(Box{{0.015, 0.1, 0.03}}, 0.05, at);
      setting.builder.add(spec::Joint{.type = JointType::slider,
                                      .i = hand,
                                      .j = finger,
                                      .anchor = at,
                                      .axis = Vec3(-side, 0, 0),
                                      .motor = spec::Motor{.force = Profile{{{0, force}}}}});
    }
    Run run(setting);
    run.go(0.3);
    const Vec3 in_hand = run.c(box) - run.c(hand);
    run.go(0.1);
    const double slipping = run.v(hand).y() - run.v(box).y();
    run.go(0.1);
    if (share < 1) {
      CHECK((run.c(box) - run.c(hand) - in_hand).norm() < 1e-4);
    } else {
      CHECK(run.v(hand).y() - run.v(box).y() - slipping == Approx((a - most) * 0.1).epsilon(0.02));
    }
  }
}

// A wedge between two blocks, a textbook question of Lagrange's equations.
TEST_CASE("a smooth wedge drives two smooth blocks apart with M g tan α / (M + 2 m tan² α)") {
  const double alpha = GENERATE(20.0, 45.0) * kDegree, ratio = GENERATE(0.1, 1.0, 20.0),
               h = GENERATE(1.0 / 60, 1.0 / 500);
  CAPTURE(alpha / kDegree, ratio, h);
  const double m = 2, M = ratio * m, tan = std::tan(alpha), high = 2.4, d_hat = 0.001;
  Setting setting(h, 0, d_hat);
  setting.ground();
  const auto prism = [](std::initializer_list<Vec3> outline) {
    std::vector<Vec3> points;
    for (const Vec3& p : outline)
      for (const double z : {-1.2, 1.2}) points.emplace_back(p.x(), p.y(), z);
    return points;
  };
  // The wedge's sides would meet 20 cm below the ground; each block has the slope that meets one.
  setting.add_hull(
      prism({{0.8 * tan, 0.6, 0}, {-0.8 * tan, 0.6, 0}, {2.6 * tan, high, 0}, {-2.6 * tan, high, 0}}), M,
      Vec3::Zero());
  std::string blocks[2];
  for (const int side : {0, 1}) {
    const double s = side == 0 ? -1 : 1, gap = d_hat / std::cos(alpha);
    const double at = 0.2 * tan + gap;  // of the slope's lower end
    blocks[side] = setting.add_hull(
        prism({{s * at, 0, 0}, {s * (at + 2 * tan), 2, 0}, {s * (at + 4), 2, 0}, {s * (at + 4), 0, 0}}), m,
        Vec3(0, d_hat, 0));
  }
  Run run(setting);
  run.go(0.2);  // it has met them, and no longer bounces
  const double v = run.v(blocks[1]).x();
  run.go(0.1);
  const double a = M * kG * tan / (M + 2 * m * tan * tan);
  CHECK(run.v(blocks[1]).x() - v == Approx(0.1 * a).epsilon(0.01));
  CHECK(run.v(blocks[0]).x() == Approx(-run.v(blocks[1]).x()).epsilon(1e-6));
}

}  // namespace pabd::test_sliding
