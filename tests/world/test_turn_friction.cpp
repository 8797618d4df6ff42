// SPDX-License-Identifier: MIT
// Rolling and torsional friction against closed forms. With a length l a contact that carries f_n resists a turn with a
// torque of at most l f_n. A round body of radius r with I = k m r² that rolls on a plane is slowed down by
// l g/(r (1 + k)), and stays on a slope of tan θ < l/r.
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/body/shape_kind.h"
#include "tests/world/world.h"

namespace pabd::test_turn_friction {

using namespace world;

namespace {

constexpr double kRadius = 0.2, kMass = 5;
constexpr double kGap = 0.0096;  // of d̂ = 0.01 m: about where bodies come to rest

struct RoundBody {
  const char* name;
  Shape shape;
  double k;  // I/(m r²)
};
const std::vector<RoundBody> kRound = {
    {"ball", Sphere{kRadius}, 0.4},
    {"can", make_shape("cylinder", {kRadius, 0.15}), 0.5},
};

// Lies on the ground, and rolls along x once it is sent.
struct Roller {
  Roller(const RoundBody& body, double h, double length, SolverMethod method = SolverMethod::automatic)
      : setting(h, 0.8) {
    setting.builder.params.contact.rolling = length;
    setting.builder.params.solver.method = method;
    setting.ground();
    name = setting.add(body.shape, kMass, {0, kRadius + kGap, 0}, along_z());
  }
  Setting setting;
  std::string name;
};

void send_rolling(Run& run, const std::string& name, double v) {
  run.go(1);  // it comes to rest on its contact
  run.send(name, {v, 0, 0}, {0, 0, -v / kRadius});
}

}  // namespace

TEST_CASE("what rolls is slowed down by l g/(r (1 + k)), and stops") {
  const double h = GENERATE(1.0 / 30, 1.0 / 60, 1.0 / 240, 1.0 / 1000), length = GENERATE(0.002, 0.02);
  const SolverMethod method = GENERATE(SolverMethod::automatic, SolverMethod::newton, SolverMethod::descent);
  for (const RoundBody& body : kRound) {
    CAPTURE(body.name, h, length, to_string(method));
    Roller roller(body, h, length, method);
    Run run(roller.setting);
    const double slowed = length * kG / (kRadius * (1 + body.k)), v = 2 * slowed;
    send_rolling(run, roller.name, v);
    const double from = run.c(roller.name).x();
    run.go(1);
    CHECK(run.v(roller.name).x() == Approx(v - slowed).epsilon(2e-3));
    run.go(1.5);
    CHECK(std::abs(run.v(roller.name).x()) < 1e-3 * v);  // what holds it is stiff, not rigid
    // A step moves by the speed at its end.
    CHECK(run.c(roller.name).x() - from == Approx(v - h * slowed).epsilon(5e-3));
    CHECK(run.rise < 1e-6 * kMass * v * v);
    CHECK(run.held + run.halved + run.unsolved == 0);
  }
}

TEST_CASE("what lies on a slope rolls where it is steeper than l/r, and not before") {
  const double h = GENERATE(1.0 / 60, 1.0 / 240), tangent = GENERATE(0.05, 0.3);
  for (const RoundBody& body : kRound) {
    for (const double share : {0.98, 1.1}) {
      CAPTURE(body.name, h, tangent, share);
      Setting setting(h, 0.8);
      setting.builder.params.contact.rolling = tangent * kRadius;
      const double angle = std::atan(share * tangent), degrees = angle * 180 / kPi;
      setting.slope(degrees);
      const std::string name =
          setting.add(body.shape, kMass, (kRadius + kGap) * uphill_normal(degrees), along_z());
      Run run(setting);
      run.go(1);
      const double began = run.v(name).dot(downhill(degrees));
      if (share < 1) CHECK(std::abs(began) < 1e-9);
      run.go(1);
      const double gained = run.v(name).dot(downhill(degrees)) - began;
      const double due = kG * (std::sin(angle) - tangent * std::cos(angle)) / (1 + body.k);
      CHECK(gained == Approx(std::max(0.0, due)).epsilon(5e-3).margin(1e-9));
    }
  }
}

TEST_CASE("what spins on a point is slowed down by l m g/I, and stops") {
  const double h = GENERATE(1.0 / 30, 1.0 / 60, 1.0 / 1000), length = GENERATE(0.001, 0.03);
  const double mu = GENERATE(0.0, 0.5);
  Setting setting(h, mu);
  setting.builder.params.contact.torsional = length;
  setting.ground();
  const std::string ball = setting.add(Sphere{kRadius}, kMass, {0, kRadius + kGap, 0});
  Run run(setting);
  const double slowed = length * kG / (0.4 * kRadius * kRadius), spin = 2 * slowed;
  run.go(1);
  run.send(ball, Vec3::Zero(), {0, spin, 0});
  run.go(1);
  CAPTURE(h, length, mu);
  CHECK(run.omega(ball).y() == Approx(spin - slowed).epsilon(2e-3));
  run.go(1.5);
  CHECK(std::abs(run.omega(ball).y()) < 1e-6);
  CHECK(run.v(ball).norm() < 1e-9);
  CHECK(run.unsolved == 0);
}

// A plank of mass M on n rollers goes twice as fast as they do. Both their contacts turn with ω = V/2r, so that
// (M + n (m + I/r²)/4) V' = −l (2 M + n m) g/2r: what they carry counts, not what they weigh.
TEST_CASE("rollers under a load a hundred times their weight are slowed down by the load") {
  const double h = GENERATE(1.0 / 60, 1.0 / 240), load = GENERATE(4.0, 1000.0);
  constexpr double kLength = 0.004, kRoller = 5, kSpeed = 1;
  Setting setting(h, 0.8);
  setting.builder.params.contact.rolling = kLength;
  setting.ground();
  std::vector<std::string> rollers;
  for (const double x : {-0.5, 0.0, 0.5})
    rollers.push_back(
        setting.add(make_shape("cylinder", {kRadius, 0.3}), kRoller, {x, kRadius + kGap, 0}, along_z()));
  const std::string plank = setting.add(Box{{2, 0.05, 0.25}}, load, {0, 2 * (kRadius + kGap) + 0.05, 0});
  Run run(setting);
  run.go(1);
  for (const std::string& roller : rollers)
    run.send(roller, {kSpeed / 2, 0, 0}, {0, 0, -kSpeed / (2 * kRadius)});
  run.send(plank, {kSpeed, 0, 0});
  run.go(0.5);
  const double inertia = load + 3 * kRoller * 1.5 / 4;
  const double slowed = kLength * (2 * load + 3 * kRoller) * kG / (2 * kRadius * inertia);
  CAPTURE(h, load);
  CHECK(run.v(plank).x() == Approx(kSpeed - 0.5 * slowed).epsilon(0.01));
  CHECK(run.rise < 1e-6 * load);
}

TEST_CASE("a ball on a plank that slides freely: momentum is kept, and both end as one") {
  const double h = GENERATE(1.0 / 60, 1.0 / 240);
  Setting setting(h, 0.8);
  setting.builder.params.contact.rolling = 0.01;
  setting.builder.params.contact.friction_rule = FrictionRule::min;
  setting.builder.add(
      spec::Body{.name = "ice", .shape = Plane{Vec3::UnitY(), 0}, .friction = SurfaceFriction{0, 0}});
  const std::string plank = setting.add(Box{{4, 0.1, 0.5}}, 3 * kMass, {0, 0.1 + kGap, 0});
  const std::string ball = setting.add(Sphere{kRadius}, kMass, {-3, 0.2 + kRadius + 2 * kGap, 0});
  Run run(setting);
  send_rolling(run, ball, 1.2);
  const double momentum = run.momentum().x();
  run.go(6);
  CAPTURE(h);
  CHECK(run.momentum().x() == Approx(momentum).epsilon(1e-9));
  CHECK(run.v(ball).x() == Approx(momentum / (4 * kMass)).epsilon(1e-4));
  CHECK(run.v(plank).x() == Approx(momentum / (4 * kMass)).epsilon(1e-4));
  CHECK(run.rise < 1e-6 * kMass);
}

TEST_CASE("bodies have lengths of their own, which combine as friction does") {
  const double h = 1.0 / 120;
  Setting setting(h, 0.8);
  setting.builder.params.contact.friction_rule = FrictionRule::max;
  setting.builder.add(spec::Body{
      .name = "felt", .shape = Plane{Vec3::UnitY(), 0}, .friction = SurfaceFriction{0.8, 0.8, 0, 0.004}});
  const std::string plain = setting.add(Sphere{kRadius}, kMass, {0, kRadius + kGap, 0});
  const std::string soft = setting.add(spec::Body{.shape = Sphere{kRadius},
                                                  .mass = kMass,
                                                  .position = Vec3(0, kRadius + kGap, 2),
                                                  .friction = SurfaceFriction{0.8, 0.8, 0, 0.01}});
  Run run(setting);
  run.go(1);
  for (const std::string& name : {plain, soft}) run.send(name, {1, 0, 0}, {0, 0, -1 / kRadius});
  run.go(1);
  CHECK(run.v(plain).x() == Approx(1 - 0.004 * kG / (1.4 * kRadius)).epsilon(2e-3));
  CHECK(run.v(soft).x() == Approx(1 - 0.01 * kG / (1.4 * kRadius)).epsilon(2e-3));
}

}  // namespace pabd::test_turn_friction
