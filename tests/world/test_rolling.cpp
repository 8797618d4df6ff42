// SPDX-License-Identifier: MIT
// What rolls, against closed forms. With k = I/(m r²), 2/5 for a ball, 2/3 for a hollow one, 1/2 for a cylinder, 1 for a hoop:
//   down a slope               it accelerates with g sin α/(1 + k)
//   thrown without spin        it ends with v/(1 + k)
//   on a belt                  it accelerates with k/(1 + k) of the belt's acceleration
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/body/shape_kind.h"
#include "tests/world/rollers.h"

namespace pabd::test_rolling {

using namespace world;

// Galileo's inclined plane: an exercise of every textbook, and of the engines' validation suites.
TEST_CASE("what rolls down a slope accelerates with g sin α/(1 + k)") {
  const Round round = GENERATE(Round{Kind::ball, 0.011}, Round{Kind::ball, 0.3}, Round{Kind::hollow, 0.05},
                               Round{Kind::cylinder, 0.04}, Round{Kind::cylinder, 0.25},
                               Round{Kind::disc, 0.1}, Round{Kind::hoop, 0.15});
  const double h = GENERATE(1.0 / 60, 1.0 / 240), degrees = GENERATE(3.0, 20.0);
  CAPTURE(int(round.kind), round.radius, h, degrees);
  auto [run, body] = on_slope(round, degrees, h, 0.6);
  const Vec3 down = downhill(degrees);
  const double v = run.v(body).dot(down);
  run.go(1.5);
  const double a = kG * std::sin(degrees * kDegree) / (1 + round.k());
  CHECK(run.v(body).dot(down) - v == Approx(1.5 * a).epsilon(0.005));
  CHECK(-run.omega(body).z() * round.radius == Approx(run.v(body).dot(down)).epsilon(0.01));
  CHECK(run.rise < 1e-6);
}

// Billiards and bowling: Coriolis 1835; J. Walker, The Flying Circus of Physics.
TEST_CASE("what is thrown without spin ends rolling with v/(1 + k)") {
  const Round round = GENERATE(Round{Kind::ball, 0.011}, Round{Kind::ball, 0.3}, Round{Kind::hollow, 0.05},
                               Round{Kind::cylinder, 0.04}, Round{Kind::cylinder, 0.25},
                               Round{Kind::disc, 0.1}, Round{Kind::hoop, 0.15});
  const double h = GENERATE(1.0 / 60, 1.0 / 240), speed = GENERATE(1.0, 4.0), mu = 0.3;
  CAPTURE(int(round.kind), round.radius, h, speed);
  auto [run, body] = on_slope(round, 0, h, mu);
  run.send(body, {speed, 0, 0});
  const double k = round.k(), sliding = speed * k / (1 + k) / (mu * kG);
  run.go(1.1 * sliding + 0.1);
  CHECK(run.v(body).x() == Approx(speed / (1 + k)).epsilon(0.005));
  CHECK(-run.omega(body).z() * round.radius == Approx(speed / (1 + k)).epsilon(0.01));
  CHECK(run.rise < 1e-6);
}

// A rolling ball loses nothing: box2d issue 604 and pull request 617; cylinders as wheels bounce: Autodesk/synthesis issue 490.
TEST_CASE("what rolls keeps its energy for five seconds, to 0.5 %") {
  const Round round = GENERATE(Round{Kind::ball, 0.011}, Round{Kind::ball, 0.3}, Round{Kind::hollow, 0.05},
                               Round{Kind::cylinder, 0.04}, Round{Kind::cylinder, 0.25},
                               Round{Kind::disc, 0.1}, Round{Kind::hoop, 0.15});
  const double h = GENERATE(1.0 / 30, 1.0 / 60, 1.0 / 240), speed = GENERATE(0.3, 3.0);
  CAPTURE(int(round.kind), round.radius, h, speed);
  auto [run, body] = on_slope(round, 0, h, 0.5);
  run.send(body, {speed, 0, 0}, {0, 0, -speed / round.radius});
  const double kinetic = run.kinetic();
  run.go(5);
  CHECK(run.kinetic() == Approx(kinetic).epsilon(0.005));
  CHECK(std::abs(run.way(body).z()) < 1e-3);
  CHECK(run.rise < 1e-4 * kinetic);
}

// A ball on a moving belt: the classic of non-holonomic mechanics (Pars; Neimark and Fufaev).
TEST_CASE("on a belt that accelerates a round body takes k/(1 + k) of the acceleration") {
  const Round round = GENERATE(Round{Kind::ball, 0.1}, Round{Kind::hollow, 0.2}, Round{Kind::cylinder, 0.05},
                               Round{Kind::cylinder, 0.15}, Round{Kind::disc, 0.3});
  const double h = GENERATE(1.0 / 60, 1.0 / 240), a = 2;
  CAPTURE(int(round.kind), round.radius, h);
  Setting setting(h, 0.5);
  const std::string belt = setting.add(Box{{10, 0.1, 1}}, 50, {0, -0.1, 0});
  const std::string body = setting.add(round.shape(), 1, {0, round.radius + 0.0095, 0}, along_z());
  Profile drive;
  for (int k = 0; k <= 200; ++k) drive.keys.emplace_back(0.3 + 0.01 * k, a * 1e-4 * k * k / 2);
  setting.builder.add(spec::Joint{
      .type = JointType::slider, .j = belt, .anchor = Vec3(0, 0, 0), .axis = Vec3::UnitX(), .drive = drive});
  Scene scene = setting.builder.build();
  if (round.kind == Kind::hollow) scene.model.J[1] = Mat3::Identity() * round.radius * round.radius / 3;
  Run run(std::move(scene));
  run.go(0.5);
  const double v = run.v(body).x();
  run.go(1);
  const double k = round.k();
  CHECK(run.v(body).x() - v == Approx(a * k / (1 + k)).epsilon(0.01));
}

// Soap box race: wheels of inertia I take part of the weight's work.
TEST_CASE("a cart on four wheels runs downhill with g sin α M/(M + 4 I/r²)") {
  const double radius = GENERATE(0.05, 0.3), wheel = GENERATE(0.2, 3.0),
               h = GENERATE(1.0 / 60, 1.0 / 240, 1.0 / 600), degrees = 8;
  CAPTURE(radius, wheel, h);
  Setting setting(h, 0.7, 0.02 * radius);
  setting.slope(degrees);
  const double board = 4, all = board + 4 * wheel;
  const std::string cart = add_cart(setting, degrees, wheel, radius, board);
  Run run(setting);
  run.go(0.3);
  const double v = run.v(cart).norm();
  run.go(1.2);
  const double a = kG * std::sin(degrees * kDegree) * all / (all + 2 * wheel);
  CHECK(run.v(cart).norm() - v == Approx(1.2 * a).epsilon(0.005));
  CHECK(run.joint_error < 1e-4 * radius);
  CHECK(run.rise < 1e-6);
}

// Wheels catch on a floor of tiles: the ghost collisions of voxel games (qu3e issue 58), roads of boxes.
TEST_CASE("a cart keeps its speed and height on a road made of boxes") {
  const double speed = GENERATE(1.0, 5.0), tile = GENERATE(0.37, 1.0),
               h = GENERATE(1.0 / 60, 1.0 / 240, 1.0 / 600), radius = 0.12;
  CAPTURE(speed, tile, h);
  Setting setting(h, 0.7, 0.004);
  add_tiles(setting, tile, static_cast<int>(14 / tile), 4);
  const std::string cart = add_cart(setting, 0, 0.5, radius, 4);
  Run run(setting);
  run.go(0.5);
  const double high = run.c(cart).y();
  run.send(cart, {speed, 0, 0});
  for (const char* wheel : {"w0", "w1", "w2", "w3"}) run.send(wheel, {speed, 0, 0}, {0, 0, -speed / radius});
  const double kinetic = run.kinetic();
  double lowest = high, highest = high;
  run.go(std::min(3.0, 11 / speed), [&] {
    lowest = std::min(lowest, run.c(cart).y());
    highest = std::max(highest, run.c(cart).y());
  });
  CHECK(run.kinetic() == Approx(kinetic).epsilon(0.005));
  CHECK(highest - lowest < 0.002);
  CHECK(run.joint_error < 1e-4 * radius);
}

// Balls on tiles: the same reports.
TEST_CASE("a ball keeps its speed on a floor of tiles, at any angle to the seams") {
  const double degrees = GENERATE(0.0, 17.0, 45.0), radius = GENERATE(0.03, 0.2),
               h = GENERATE(1.0 / 60, 1.0 / 240), speed = 2;
  CAPTURE(degrees, radius, h);
  Setting setting(h, 0.5, 0.003);
  add_tiles(setting, 0.5, 13, 13);
  const std::string ball = setting.add(Sphere{radius}, 0.4, {0, radius + 0.003, 0});
  Run run(setting);
  run.go(0.3);
  const Vec3 way(std::cos(degrees * kDegree), 0, std::sin(degrees * kDegree));
  run.send(ball, speed * way, Vec3::UnitY().cross(way) * speed / radius);
  run.go(2.4);
  CHECK((run.v(ball) - speed * way).norm() < 1e-3 * speed);
}

// Cans in a heap that never rest: T5 of the findings; a demonstration of every engine.
TEST_CASE("lying cylinders between two stops come to rest in a heap") {
  const int base = GENERATE(2, 3, 4);
  const double radius = GENERATE(0.033, 0.2), h = GENERATE(1.0 / 60, 1.0 / 240);
  CAPTURE(base, radius, h);
  const double gap = 0.03 * radius;
  Setting setting(h, 0.5, gap);
  setting.ground();
  const double half = base * (radius + gap / 2);
  for (const double side : {-1.0, 1.0})
    setting.add(Box{Vec3(1, 1.5, 4) * radius}, 0, {side * (half + gap / 2 + radius), 1.5 * radius, 0});
  for (int row = 0; row < base; ++row)
    for (int k = 0; k < base - row; ++k)
      setting.add(make_shape("cylinder", {radius, 3.5 * radius}), 0.35,
                  {(2 * k - (base - row - 1)) * (radius + gap / 2),
                   radius + gap + row * std::sqrt(3.0) * (radius + gap / 2), 0},
                  along_z());
  Run run(setting);
  run.go(4);
  CHECK(run.kinetic() < 1e-9 * run.weight() * radius);
  CHECK(run.carried() == Approx(run.weight()).epsilon(1e-3));
  CHECK(run.rise < 1e-6 * run.weight() * radius);
}

// A prism that turns on a smooth floor: T3 of the findings.
TEST_CASE("a prism of many sides that spins on a smooth floor makes no energy") {
  const int sides = GENERATE(5, 12, 32);
  const double rate = GENERATE(5.0, 40.0), h = GENERATE(1.0 / 60, 1.0 / 240), radius = 0.1;
  CAPTURE(sides, rate, h);
  Setting setting(h, 0, 0.003);
  setting.ground();
  std::vector<Vec3> corners;
  for (int k = 0; k < sides; ++k)
    for (const double z : {-0.06, 0.06})
      corners.emplace_back(radius * std::sin(2 * kPi * k / sides), radius * std::cos(2 * kPi * k / sides), z);
  const std::string prism = setting.add_hull(corners, 2, {0, radius + 0.003, 0});
  Run run(setting);
  run.send(prism, Vec3::Zero(), {0, 0, -rate});
  run.go(3);
  CHECK(run.rise < 1e-4 * run.begin);
}

// Coleman, Chatterjee, Ruina, "Motions of a rimless spoked wheel" (1997): an impact takes ω⁺/ω⁻ = (I + m r² cos 2π/n)/(I + m r²).
// Contacts that give way take less, and where it hops there are fewer.
TEST_CASE("a prism of many sides that rolls loses no more than a rimless wheel, and never gains") {
  const int sides = GENERATE(32, 64);
  const double rate = GENERATE(5.0, 20.0), h = GENERATE(1.0 / 60, 1.0 / 240), radius = 0.3, mass = 1;
  CAPTURE(sides, rate, h);
  Setting setting(h);
  setting.ground();
  const double side = kPi / sides, low = radius * std::cos(side);
  std::vector<Vec3> corners;
  for (int k = 0; k < sides; ++k)
    for (const double z : {-0.2, 0.2})
      corners.emplace_back(radius * std::sin((2 * k + 1) * side), radius * std::cos((2 * k + 1) * side), z);
  const std::string prism = setting.add_hull(corners, mass, {0, low + 0.01, 0});
  Run run(setting);
  run.send(prism, {rate * low, 0, 0}, {0, 0, -rate});
  run.go(0.1);  // it lies on its contacts
  const double start = run.kinetic();
  run.go(4.9);
  const double r2 = radius * radius, I = mass * r2 / 2 * (1 - 2 * std::pow(std::sin(side), 2) / 3);
  const double kept = (I + mass * r2 * std::cos(2 * side)) / (I + mass * r2);
  double wheel = rate;
  for (double t = 2 * side / wheel; t < 4.9; t += 2 * side / wheel) wheel *= kept;
  CHECK(run.kinetic() > start * std::pow(wheel / rate, 2));
  CHECK(run.rise < 1e-4 * run.begin);
}

}  // namespace pabd::test_rolling
