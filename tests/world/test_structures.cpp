// SPDX-License-Identifier: MIT
// What stands by its weight and friction alone, a little inside the limits of statics, and falls a little outside.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/world/world.h"

namespace pabd::test_structures {

using namespace world;

namespace {

// The corners of an outline in the plane z = 0, made thick.
std::vector<Vec3> thick(const std::vector<Vec3>& outline, double width) {
  std::vector<Vec3> out;
  for (const Vec3& p : outline)
    for (const double z : {-width / 2, width / 2}) out.emplace_back(p.x(), p.y(), z);
  return out;
}

// Half a ring of stones about the origin, on the ground. Gives back the name of the keystone.
std::string add_arch(Setting& setting, int stones, double radius, double thickness) {
  const double d_hat = setting.builder.params.contact.d_hat;
  std::string key;
  for (int k = 0; k < stones; ++k) {
    std::vector<Vec3> outline;
    for (const int end : {0, 1}) {
      const double angle = kPi * (k + end) / stones;
      const Vec3 out(std::cos(angle), std::sin(angle), 0), along(-out.y(), out.x(), 0);
      for (const double r : {radius - thickness / 2, radius + thickness / 2})
        outline.push_back(r * out + (end == 0 ? 0.5 : -0.5) * d_hat * along + Vec3(0, d_hat / 2, 0));
    }
    const std::string stone =
        setting.add_hull(thick(outline, 0.4 * radius), 100 * thickness / stones, Vec3::Zero());
    if (k == stones / 2) key = stone;
  }
  return key;
}

}  // namespace

// The arch of least thickness, 0.1075 of its mean radius: Milankovitch 1907, Heyman 1969.
TEST_CASE("an arch stands when it is 0.13 of its radius thick, of however many stones, and falls at 0.085") {
  const int stones = GENERATE(9, 17, 31, 81);
  const double radius = GENERATE(0.5, 4.0), h = GENERATE(1.0 / 60, 1.0 / 240);
  CAPTURE(stones, radius, h);
  for (const double share : {0.16, 0.13, 0.085}) {
    CAPTURE(share);
    Setting setting(h, 0.8, 2e-4 * radius);
    setting.ground();
    const std::string key = add_arch(setting, stones, radius, share * radius);
    Run run(setting);
    run.go(share > 0.1 ? 3 : 6 * std::sqrt(radius));
    if (share > 0.1) {
      CHECK(run.way(key).norm() < 2e-4 * radius * stones);
      CHECK(run.kinetic() < 1e-8 * run.weight() * radius);
    } else if (stones > 9) {  // fewer stones cannot choose where they hinge
      CHECK(run.c(key).y() < 0.5 * radius);
    } else {
      CHECK(run.rise < 1e-6 * run.begin);
    }
  }
}

// The book stack: n blocks overhang by half a block times the harmonic number (Johnson 1955).
TEST_CASE("a stack of blocks overhangs by almost half the harmonic number, and falls beyond it") {
  const int count = GENERATE(2, 3, 6);
  const double length = GENERATE(0.2, 2.0), h = GENERATE(1.0 / 60, 1.0 / 240);
  CAPTURE(count, length, h);
  for (const double share : {0.96, 1.04}) {
    CAPTURE(share);
    const double thin = 0.15 * length, d_hat = 0.005 * thin;
    Setting setting(h, 0.6, d_hat);
    setting.add(Box{Vec3(length, 0.5 * length, 0.3 * length) / 2}, 0, {-length / 2, -0.25 * length, 0});
    double x = -length / 2;
    for (int k = 0; k < count; ++k) {  // from the bottom up: the k-th is the (count - k)-th from the top
      x += share * length / (2 * (count - k));
      setting.add(Box{Vec3(length, thin, 0.3 * length) / 2}, 1.5,
                  {x, thin / 2 + d_hat + k * (thin + d_hat), 0});
    }
    Run run(setting);
    run.go(1.5 * std::sqrt(length));
    const std::string top = "b" + std::to_string(count);
    CHECK((share < 1) == (run.way(top).norm() < d_hat * count));
    CHECK((share > 1) == (run.c(top).y() < 0));
  }
}

namespace {

// What friction a thin board at that angle to the ground needs that leans on a smooth wall, or on its mirror image.
double friction_of(double length, double thickness, double angle) {
  return (std::cos(angle) - thickness / length * std::sin(angle)) / (2 * std::sin(angle));
}

}  // namespace

// The ladder of every book on statics.
TEST_CASE("a ladder at a smooth wall stands with 4 % more friction than it needs and slides with 4 % less") {
  const double degrees = GENERATE(40.0, 55.0, 70.0), length = GENERATE(0.5, 3.0),
               h = GENERATE(1.0 / 60, 1.0 / 240);
  CAPTURE(degrees, length, h);
  const double thin = 0.03 * length, angle = degrees * kDegree, d_hat = 0.01 * thin;
  for (const double share : {1.04, 0.96}) {
    const double mu = share * friction_of(length, thin, angle);
    CAPTURE(mu);
    Setting setting(h, mu, d_hat);
    setting.ground();
    spec::Body wall;
    wall.shape = Plane{-Vec3::UnitX(), 0};
    wall.friction = SurfaceFriction{0, 0};
    setting.add(wall);
    const double reach = length / 2 * std::cos(angle) + thin / 2 * std::sin(angle) + d_hat;
    const double high = length / 2 * std::sin(angle) + thin / 2 * std::cos(angle) + d_hat;
    const std::string ladder =
        setting.add(Box{Vec3(length, thin, 0.2 * length) / 2}, 8, {-reach, high, 0}, about_z(degrees));
    Run run(setting);
    run.go(2 * std::sqrt(length));
    CHECK((share > 1) == (run.way(ladder).norm() < 20 * d_hat));
    CHECK((share < 1) == (run.c(ladder).y() < 0.7 * high));
  }
}

// Houses of cards: Box2D's and Jolt's demonstrations; Kry and Pai's and Kaufman's (2008) tests of friction.
TEST_CASE("a house of cards stands with enough friction, and falls with too little for a pair of cards") {
  const int levels = GENERATE(1, 2, 3);
  const double h = GENERATE(1.0 / 60, 1.0 / 240), length = GENERATE(0.09, 1.0);
  CAPTURE(levels, h, length);
  const double angle = 68 * kDegree, thin = 0.012 * length, d_hat = 0.02 * thin;
  for (const double mu : {0.6, 0.8 * friction_of(length, thin, angle)}) {
    CAPTURE(mu);
    Setting setting(h, mu, d_hat);
    setting.ground();
    const double reach = length / 2 * std::cos(angle) + thin / 2 * std::sin(angle) + d_hat / 2;
    const double high = length * std::sin(angle) + thin * std::cos(angle);
    const double spacing = 4 * reach + 2 * thin;
    double base = d_hat;
    std::string top;
    for (int level = 0; level < levels; ++level) {
      const int pairs = levels - level;
      for (int k = 0; k < pairs; ++k) {
        const double x = spacing * (k - 0.5 * (pairs - 1));
        for (const double side : {-1.0, 1.0})
          top = setting.add(Box{Vec3(length, thin, 0.7 * length) / 2}, 0.002,
                            {x + side * reach, base + high / 2, 0}, about_z(side < 0 ? 68 : 112));
      }
      base += high + d_hat;
      for (int k = 0; k + 1 < pairs; ++k)
        setting.add(Box{Vec3(spacing - 2 * d_hat, thin, 0.7 * length) / 2}, 0.002,
                    {spacing * (k - 0.5 * (pairs - 2)), base + thin / 2, 0});
      base += thin + d_hat;
    }
    Run run(setting);
    const double before = run.c(top).y();
    run.go(2);
    CHECK((mu > 0.5) == (run.way(top).norm() < 20 * d_hat * levels));
    CHECK((mu < 0.5) == (run.c(top).y() < 0.9 * before));
  }
}

namespace {

// Times at which dominoes of that height, a row of 40, have turned by 0.1 rad each.
std::vector<double> topple(double height, double spacing, double h) {
  Setting setting(h, 0.2, 0.002 * height);
  setting.ground();
  std::vector<std::string> names;
  const double turn = 1.2 / std::sqrt(height);  // of the first, about the edge that it topples over; rad/s
  for (int k = 0; k < 40; ++k) {
    spec::Body domino{.shape = Box{Vec3(0.15, 1, 0.5) * height / 2},
                      .mass = 2 * height * height * height,
                      .position = Vec3(spacing * height * k, 0.502 * height, 0)};
    if (k == 0) {
      domino.angular_velocity = Vec3(0, 0, -turn / kDegree);
      domino.velocity = turn * height * Vec3(0.5, 0.075, 0);
    }
    names.push_back(setting.add(domino));
  }
  Run run(setting);
  std::vector<double> at;
  run.go(14 * std::sqrt(height), [&] {
    while (at.size() < names.size() && run.R(names[at.size()])(1, 1) < std::cos(0.1))
      at.push_back(run.state.time);
  });
  CHECK(run.rise < 1e-6 * run.begin);
  return at;
}

}  // namespace

// The front runs steadily, its speed in sqrt(g H) a matter of shape alone: Stronge 1987, van Leeuwen 2010.
TEST_CASE("a row of dominoes falls with a steady front, and a row four times as high takes twice as long") {
  const double spacing = GENERATE(0.35, 0.6);
  const double h = 1.0 / 1000;
  CAPTURE(spacing);
  const std::vector<double> small = topple(0.2, spacing, h), large = topple(0.8, spacing, 2 * h);
  REQUIRE(small.size() == 40);
  REQUIRE(large.size() == 40);
  CHECK(small[36] - small[24] == Approx(small[24] - small[12]).epsilon(0.02));
  CHECK(large[36] - large[12] == Approx(2 * (small[36] - small[12])).epsilon(0.01));
}

// The beam balance.
TEST_CASE("a board on an edge stays where its loads balance, 1 to 100, and tips where they do not") {
  const double ratio = GENERATE(1.0, 10.0, 100.0), h = GENERATE(1.0 / 60, 1.0 / 240);
  CAPTURE(ratio, h);
  for (const double off :
       {0.0, 0.08, -0.08}) {  // of the centre of mass from the middle of a support 0.1 wide
    CAPTURE(off);
    Setting setting(h, 0.6, 0.001);
    setting.add(Box{{0.05, 0.3, 0.3}}, 0, {0, 0.3, 0});
    const double board = 2, light = 1, heavy = ratio, arm = 1.4;
    const double near = ((board + light + heavy) * off + light * arm) / heavy;  // where the heavy one stands
    const std::string plank = setting.add(Box{{2, 0.03, 0.2}}, board, {0, 0.631, 0});
    setting.add(Box{{0.1, 0.1, 0.1}}, light, {-arm, 0.762, 0});
    setting.add(Box{{0.1, 0.1, 0.1}}, heavy, {near, 0.762, 0});
    Run run(setting);
    double tilt = 0;  // until it is plain which way it goes: loads that slide off change it
    run.go(2, [&] {
      if (std::abs(tilt) < 3) tilt = std::asin(run.R(plank)(1, 0)) / kDegree;
    });
    if (off == 0) {
      CHECK(std::abs(tilt) < 0.1);
    } else {
      CHECK(tilt * off < 0);
      CHECK(std::abs(tilt) > 3);
    }
  }
}

}  // namespace pabd::test_structures
