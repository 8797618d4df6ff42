// SPDX-License-Identifier: MIT
// What bounces, against Newton's law of restitution and the conservation of energy and momentum.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/world/world.h"

namespace pabd::test_restitution {

using namespace world;

namespace {

// e of the first hit of a body that falls from rest, by its energy then and before, if it hit at that height: somewhere
// between the thickness of the contact and the deepest overlap.
struct Bounce {
  double speed2, fallen_from, now;
  double e_at(double y) const {
    return std::sqrt((speed2 + 2 * kG * (now - y)) / (2 * kG * (fallen_from - y)));
  }
};
Bounce first_bounce(Run& run, const std::string& name) {
  const double top = run.c(name).y();
  for (int i = 0; i < 3000 && run.v(name).y() <= 0; ++i) run.go(run.scene.params.h);
  return {std::pow(run.v(name).y(), 2), top, run.c(name).y()};
}
void check_bounces(Run& run, const std::string& name, double below, double e) {
  const Bounce seen = first_bounce(run, name);
  const double d_hat = run.scene.params.contact.d_hat, least = seen.e_at(below + d_hat),
               most = seen.e_at(below - run.overlap);
  CHECK(std::min(least, most) < 1.01 * e);
  CHECK(std::max(least, most) > 0.99 * e);
}

}  // namespace

TEST_CASE("a ball bounces with e times its speed, whatever the step, N, d̂ and κ") {
  const double h = GENERATE(1.0 / 30, 1.0 / 60, 1.0 / 240, 1.0 / 1000), e = GENERATE(0.3, 0.75, 1.0);
  const int N = GENERATE(1, 3, 8);
  const double kappa = GENERATE(0.0, 10.0, 1e5);  // 0: auto
  CAPTURE(h, e, N, kappa);
  for (const double height : {1.6, 5.13, 12.77}) {
    Setting setting(h);
    ContactParams& contact = setting.builder.params.contact;
    setting.builder.params.solver.integrator = Integrator::bdf2;
    contact.restitution = e;
    contact.N = N;
    if (kappa > 0) contact.kappa = kappa;
    setting.ground();
    const std::string ball = setting.add(Sphere{0.25}, 10, {0, height + 0.25, 0});
    Run run(setting);
    check_bounces(run, ball, 0.25, e);
    CHECK(run.rise < 1e-9 * run.weight() * height);
  }
}

// A public benchmark of engines drops balls of 10 kg from 5 m: 490.5 J.
TEST_CASE("a ball with e = 1 keeps 490.5 J over 20 s of bounces") {
  const double h = GENERATE(1.0 / 30, 1.0 / 60, 1.0 / 240, 1.0 / 1000);
  Setting setting(h);
  setting.builder.params.solver.integrator = Integrator::bdf2;
  setting.builder.params.contact.restitution = 1;
  setting.ground();
  const std::string ball = setting.add(Sphere{0.5}, 10, {0, 5.5, 0});
  Run run(setting);
  run.go(20);
  const double energy = run.kinetic() + run.weight() * (run.c(ball).y() - 0.5);
  CAPTURE(h);
  CHECK(energy == Approx(490.5).epsilon(0.01));
  CHECK(run.rise < 1e-6);
}

TEST_CASE("a box that falls on a face or an edge comes up as it went down") {
  const double h = GENERATE(1.0 / 60, 1.0 / 240), e = GENERATE(0.5, 1.0), degrees = GENERATE(0.0, 45.0);
  const Vec3 half = degrees == 0 ? GENERATE(Vec3(0.2, 0.2, 0.2), Vec3(0.5, 0.05, 0.3)) : Vec3(0.2, 0.2, 0.4);
  CAPTURE(h, e, degrees, half.transpose());
  Setting setting(h);
  setting.builder.params.solver.integrator = Integrator::bdf2;
  setting.builder.params.contact.restitution = e;
  setting.ground();
  const std::string box = setting.add(Box{half}, 7, {0, 2.3, 0}, about_z(degrees));
  Run run(setting);
  check_bounces(run, box, degrees == 0 ? half.y() : 0.2 * std::sqrt(2), e);
  CHECK(run.omega(box).norm() < 1e-3);
  CHECK(run.rise < 1e-9 * run.begin);
}

TEST_CASE("boxes that tumble with e = 1 keep their energy, with less they lose some and come to rest") {
  const double h = GENERATE(1.0 / 60, 1.0 / 240), e = GENERATE(0.4, 1.0);
  const double degrees = GENERATE(10.0, 31.0, 77.0);
  CAPTURE(h, e, degrees);
  Setting setting(h, 0);
  setting.builder.params.solver.integrator = Integrator::bdf2;
  setting.builder.params.contact.restitution = e;
  setting.ground();
  const std::string box = setting.add(Box{{0.3, 0.2, 0.1}}, 7, {0, 2.3, 0}, about_z(degrees));
  Run run(setting);
  run.go(6);
  const double end = run.kinetic() + run.weight() * run.c(box).y();
  CHECK(run.rise < 1e-6 * run.begin);
  CHECK(end > (e == 1 ? 0.9 : 0) * run.begin);
  CHECK(run.kinetic() < (e == 1 ? 1.01 * run.begin : 1e-3));
}

TEST_CASE("friction of what bounces is that of Coulomb's law, as it is told") {
  const double h = GENERATE(1.0 / 60, 1.0 / 240), e = GENERATE(0.3, 0.85);
  CAPTURE(h, e);
  Setting setting(h);
  setting.builder.params.contact.restitution = e;
  setting.ground();
  for (int k = 0; k < 5; ++k)
    setting.add(Box{{0.2, 0.15, 0.25}}, 5, {1.0 * k, 1.4, 0}, about_z(13.0 * k + 7));
  Run run(setting);
  double excess = 0;
  run.go(2, [&] { excess = std::max(excess, run.report.friction_excess); });
  CHECK(excess < 0.01);
  CHECK(run.rise < 1e-6 * run.begin);
}

TEST_CASE("a row of balls passes on as many as hit it, whether they stand in touch or apart") {
  const double h = GENERATE(1.0 / 30, 1.0 / 60, 1.0 / 1000), gap = GENERATE(0.0102, 0.013, 0.03, 0.08);
  const int hit = GENERATE(1, 2, 3);
  CAPTURE(h, gap, hit);
  Setting setting(h, 0);
  setting.builder.params.gravity.setZero();
  setting.builder.params.solver.integrator = Integrator::bdf2;
  setting.builder.params.contact.restitution = 1;
  const double r = 0.25, v = 3;
  std::vector<std::string> row;
  for (int i = 0; i < 7; ++i) {
    const double apart = i < hit ? -0.4 : 0;
    row.push_back(setting.add(Sphere{r}, 5, {(2 * r + gap) * i + apart, 0, 0}));
  }
  Run run(setting);
  for (int i = 0; i < hit; ++i) run.send(row[i], {v, 0, 0});
  run.go(1.5);
  for (int i = 0; i < 7; ++i) {
    CAPTURE(i);
    CHECK(run.v(row[i]).x() == Approx(i < 7 - hit ? 0 : v).margin(0.01 * v));
  }
  CHECK(run.rise < 1e-2 * run.begin);
}

TEST_CASE("balls of different masses part as a collision of two says, with and without e of their own") {
  const double ratio = GENERATE(0.01, 0.5, 1.0, 30.0), e = GENERATE(0.2, 0.4, 0.9);
  CAPTURE(ratio, e);
  Setting setting(1.0 / 60, 0);
  setting.builder.params.gravity.setZero();
  setting.builder.params.contact.friction_rule = FrictionRule::max;
  setting.add({.name = "left",
               .shape = Sphere{0.2},
               .mass = 1,
               .position = Vec3(-0.6, 0, 0),
               .velocity = Vec3(2, 0, 0),
               .restitution = e});
  setting.add({.name = "right",
               .shape = Sphere{0.3},
               .mass = ratio,
               .position = Vec3(0.6, 0, 0),
               .velocity = Vec3(-1, 0, 0)});
  Run run(setting);
  run.go(2);
  const double left = run.v("left").x(), right = run.v("right").x();
  CHECK(right - left == Approx(3 * e).margin(0.01));
  CHECK(left + ratio * right == Approx(2 - ratio).margin(1e-9 + 1e-9 * ratio));
}

TEST_CASE("what rests is at rest with any restitution, and a heap comes to rest") {
  const double h = GENERATE(1.0 / 30, 1.0 / 60, 1.0 / 240), e = GENERATE(0.5, 0.9, 1.0);
  CAPTURE(h, e);
  Setting setting(h);
  setting.builder.params.solver.integrator = Integrator::bdf2;
  setting.builder.params.contact.restitution = e;
  setting.ground();
  for (int i = 0; i < 6; ++i) setting.add(Box{{0.2, 0.1, 0.2}}, 3, {0, 0.111 + 0.2101 * i, 0});
  Run run(setting);
  run.go(2);
  CHECK(run.kinetic() < 1e-6);
  CHECK(run.rise < 1e-3 * run.begin);
}

TEST_CASE("a ball that hits the floor aslant rolls on after it where friction suffices") {
  const double e = GENERATE(0.3, 0.6, 1.0);
  CAPTURE(e);
  Setting setting(1.0 / 240, 10);
  setting.builder.params.solver.integrator = Integrator::bdf2;
  setting.builder.params.contact.restitution = e;
  setting.ground();
  const std::string ball = setting.add(Sphere{0.1}, 1, {0, 0.6, 0});
  Run run(setting);
  run.send(ball, {2, 0, 0}, {0, 0, 3});
  for (int i = 0; i < 500 && run.v(ball).y() <= 0; ++i) run.go(1.0 / 240);
  // Momentum about the point of contact: v = (5/7) v₀ − (2/7) r ω₀.
  CHECK(run.v(ball).x() == Approx(5.0 / 7 * 2 - 2.0 / 7 * 0.1 * 3).epsilon(0.02));
  CHECK(run.rise < 1e-9);
}

}  // namespace pabd::test_restitution
