// SPDX-License-Identifier: MIT
// contact.damping against closed forms. With the quadratic barrier and no onset a contact is the spring k = κ/d̂² and the
// damper τ k, which never pull: ω² = k/m, ζ = τ ω/2. A step of implicit Euler adds h to τ.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/world/world.h"

namespace pabd::test_damping {

using namespace world;

namespace {

constexpr double kThickness = 0.01, kKappa = 1;  // k = 1e4 N/m

Setting springy(double h, double tau) {
  Setting setting(h, 0, kThickness);
  ContactParams& contact = setting.builder.params.contact;
  contact.barrier = BarrierKind::quadratic;
  contact.onset = 0;
  contact.kappa = kKappa;
  contact.damping = tau;
  setting.ground();
  return setting;
}

// Speed after a hit over that before it, until the force is 0.
double restitution(double zeta) {
  if (zeta == 1) return std::exp(-2);
  if (zeta < 1) {
    const double w = std::sqrt(1 - zeta * zeta);
    return std::exp(-zeta / w * std::atan2(2 * zeta * w, 2 * zeta * zeta - 1));
  }
  const double w = std::sqrt(zeta * zeta - 1);
  return std::exp(-zeta / w * std::log((zeta + w) / (zeta - w)));
}

}  // namespace

TEST_CASE("a hit on a spring and a damper that never pull has the restitution of its damping") {
  const double zeta = GENERATE(0.05, 0.25, 1.0, 3.0), h = 1e-5;
  const double omega = std::sqrt(kKappa / (kThickness * kThickness));  // of 1 kg
  Setting setting = springy(h, 2 * zeta / omega);
  setting.builder.params.gravity.setZero();
  const std::string ball = setting.add(
      spec::Body{.shape = Sphere{0.2}, .mass = 1, .position = Vec3(0, 0.212, 0), .velocity = Vec3(0, -1, 0)});
  Run run(setting);
  run.go(0.2);
  CAPTURE(zeta);
  CHECK(run.v(ball).y() == Approx(restitution(zeta + h * omega / 2)).epsilon(2e-3));
  CHECK(run.rise < 1e-12);
}

TEST_CASE("what bobs on its contacts comes to rest as a damped oscillator does") {
  const double h = GENERATE(1.0 / 2000, 1.0 / 8000), tau = GENERATE(0.001, 0.004);
  Setting setting = springy(h, tau);
  const double mass = 20, omega2 = 4 * kKappa / (kThickness * kThickness * mass);  // four corners
  const double rest = kThickness - kG / omega2;
  const std::string box = setting.add(
      spec::Body{.shape = Box{{0.3, 0.2, 0.3}}, .mass = mass, .position = Vec3(0, 0.2 + rest, 0)});
  Run run(setting);
  run.go(1);
  CHECK(run.c(box).y() - 0.2 == Approx(rest).epsilon(1e-6));  // damping does not change where it rests
  const double v = 0.4 * kG / std::sqrt(omega2);
  run.send(box, {0, v, 0});
  const double lost = 0.5 * (tau + h) * omega2, w = std::sqrt(omega2 - lost * lost), time = 2 * kPi / w;
  run.go(time);
  CAPTURE(h, tau);
  CHECK(run.v(box).y() == Approx(v * std::exp(-lost * run.steps * h)).epsilon(0.02));
  CHECK(run.rise < 1e-9);
}

TEST_CASE("damping never pulls: what leaves fast leaves with its speed") {
  const double h = GENERATE(1.0 / 60, 1.0 / 1000);
  Setting setting = springy(h, 0.1);
  setting.builder.params.gravity.setZero();
  const std::string ball = setting.add(
      spec::Body{.shape = Sphere{0.2}, .mass = 1, .position = Vec3(0, 0.209, 0), .velocity = Vec3(0, 3, 0)});
  Run run(setting);
  run.go(0.1);
  CHECK(run.v(ball).y() == Approx(3).epsilon(1e-12));
}

TEST_CASE("a tower that sways on soft contacts comes to rest sooner, and as deep") {
  double kinetic[2], top[2];
  for (const int damped : {0, 1}) {
    Setting setting(1.0 / 240, 0.6, 0.02);
    setting.builder.params.contact.kappa = 100;
    setting.builder.params.contact.damping = damped ? 0.02 : 0;
    setting.ground();
    std::string block;
    for (int k = 0; k < 6; ++k) {
      spec::Body body{.shape = Box{{0.15, 0.2, 0.15}}, .mass = 4, .position = Vec3(0, 0.219 + 0.419 * k, 0)};
      if (k == 5) body.velocity = Vec3(0.2, 0, 0);
      block = setting.add(body);
    }
    Run run(setting);
    run.go(0.6);
    kinetic[damped] = run.kinetic();
    run.go(8);
    top[damped] = run.c(block).y();
    CHECK(run.kinetic() < 1e-6);
  }
  CHECK(kinetic[1] < 0.2 * kinetic[0]);
  CHECK(top[1] == Approx(top[0]).margin(1e-4));
}

}  // namespace pabd::test_damping
