// SPDX-License-Identifier: MIT
// Balls and capsules that roll, at any turn a step, against closed forms.
//
// A round body of mass m and moment I about its axis of rolling, radius r: with k = I/(m r²), 2/5 for a ball,
//   sliding ends in rolling    at v = (v_0 + k r ω_0)/(1 + k)
//   down a slope               it accelerates with g sin θ/(1 + k)
//   on a turntable             its velocity turns with k/(1 + k) Ω

#include <catch2/catch.hpp>
#include <cmath>

#include "sim/body/mass_properties.h"
#include "sim/math/so3.h"
#include "sim/solver/params.h"
#include "tests/support/scenario.h"

namespace pabd::test_rolling {

using testing::World;

namespace {

constexpr double kMu = 0.4;

const SolverMethod kMethods[] = {SolverMethod::automatic, SolverMethod::newton, SolverMethod::descent};

struct Track {
  Vec3 up, along;                                // unit
  Vec3 axis() const { return up.cross(along); }  // of rolling: v = r ω along
};

// A plane and a body on it that rests under its weight, ready to be sent `along`.
struct Roller {
  World world;
  Track track;
  double radius, k;  // k = I/(m r²)

  double speed() const { return world.state.v[1].dot(track.along); }
  double rim() const { return radius * world.state.omega[1].dot(track.axis()); }
  void send(double v, double rim_speed) {
    world.state.v[1] = v * track.along;
    world.state.omega[1] = rim_speed / radius * track.axis();
  }
};

Roller at_rest(const Shape& shape, const Track& track, double h, SolverMethod method) {
  Roller out{{}, track, 0, 0};
  World& world = out.world;
  const auto* ball = std::get_if<Sphere>(&shape);
  out.radius = ball ? ball->radius : std::get<Capsule>(shape).radius;
  const double mass = 3000 * volume(shape);
  world.params.h = h;
  world.params.solver.method = method;
  world.params.solver.iterations = 50;
  world.params.contact.d_hat = 0.05 * out.radius;
  world.params.contact.mu_static = world.params.contact.mu_dynamic = kMu;
  world.params.gravity = -9.81 * track.up;
  world.add_ground(track.up);
  Mat3 R;
  R << track.along, track.axis(), track.along.cross(track.axis());  // a capsule lies across the track
  world.add(shape, mass, 1.04 * out.radius * track.up, R);
  const Mat3 I = inertia_tensor(world.model.J[1]);
  out.k = I(1, 1) / (mass * out.radius * out.radius);
  testing::run(world, 40);
  world.state.v[1].setZero();
  world.state.omega[1].setZero();
  return out;
}

Track track(const Vec3& up, double turn) {
  const Vec3 n = up.normalized(), side = n.unitOrthogonal();
  return {n, Eigen::AngleAxisd(turn, n) * side};
}

const Track kTracks[] = {track({0, 1, 0}, 0), track({0, 1, 0}, 2.1), track({0.3, 1, -0.5}, 0.7)};

}  // namespace

TEST_CASE("sliding, with and against its spin, ends in rolling at (v_0 + k r ω_0)/(1 + k)") {
  struct Throw {
    Shape shape;
    double turn, spin, h;  // v_0 = turn · r/h, r ω_0 = spin · v_0
    int track;
  };
  const Throw throws[] = {
      {Sphere{0.01}, 30, 0, 1.0 / 60, 0},       {Sphere{0.07}, 8, -0.4, 1.0 / 60, 2},
      {Sphere{0.3}, 2, 1.7, 1.0 / 60, 1},       {Sphere{0.02}, 0.7, 0, 1.0 / 240, 2},
      {Capsule{0.03, 0.2}, 12, 0, 1.0 / 60, 1}, {Capsule{0.1, 0.3}, 3.3, 0.2, 1.0 / 120, 1},
  };
  for (const Throw& t : throws) {
    for (const SolverMethod method : kMethods) {
      Roller body = at_rest(t.shape, kTracks[t.track], t.h, method);
      const double v = t.turn * body.radius / t.h, rim = t.spin * v;
      body.send(v, rim);
      const double sliding = std::abs(v - rim) * body.k / (1 + body.k) / (kMu * 9.81);  // s
      testing::run(body.world, static_cast<int>(1.1 * sliding / t.h) + 10);
      const double expected = (v + body.k * rim) / (1 + body.k);
      INFO("radius " << body.radius << ", turn " << t.turn << ", spin " << t.spin << ", solver "
                     << to_string(method));
      CHECK(body.speed() == Approx(expected).epsilon(0.005));
      CHECK(body.rim() == Approx(expected).epsilon(0.005));
    }
  }
}

TEST_CASE("what rolls keeps its speed, up to thirty radians a step, with every solver") {
  for (const SolverMethod method :
       {SolverMethod::automatic, SolverMethod::newton, SolverMethod::descent, SolverMethod::sissm}) {
    for (const double turn : {0.3, 3.1, 9.0, 30.0}) {
      for (const Shape& shape : {Shape(Sphere{0.05}), Shape(Capsule{0.2, 0.5})}) {
        if (method == SolverMethod::sissm && std::holds_alternative<Capsule>(shape)) continue;
        Roller body = at_rest(shape, kTracks[2], 1.0 / 60, method);
        const double v = turn * body.radius * 60;
        body.send(v, v);
        testing::run(body.world, 120);
        INFO("turn " << turn << ", radius " << body.radius << ", solver " << to_string(method));
        CHECK(body.speed() == Approx(v).epsilon(1e-4));
        CHECK(body.rim() == Approx(v).epsilon(1e-4));
      }
    }
  }
}

TEST_CASE("a slope adds g sin θ/(1 + k) to a slow and to a fast ball") {
  for (const SolverMethod method : kMethods) {
    for (const double turn : {0.0, 5.0, 28.0}) {
      const double h = 1.0 / 60, angle = 12 * kPi / 180;
      Roller ball = at_rest(Sphere{0.04}, kTracks[1], h, method);
      const double v = turn * ball.radius / h;
      ball.send(v, v);
      ball.world.params.gravity =
          9.81 * (std::sin(angle) * ball.track.along - std::cos(angle) * ball.track.up);
      testing::run(ball.world, 60);
      INFO("turn " << turn << ", solver " << to_string(method));
      CHECK(ball.speed() - v == Approx(9.81 * std::sin(angle) / (1 + ball.k)).epsilon(0.005));
    }
  }
}

TEST_CASE("on a turntable the velocity of a ball turns with 2/7 of its speed") {
  struct Case {
    double omega, speed, radius;
  };
  for (const Case& c : {Case{1.5, 0.3, 0.05}, Case{-2, 2, 0.005}, Case{0.8, 4, 0.004}}) {
    for (const SolverMethod method : kMethods) {
      World world;
      world.params.solver.method = method;
      world.params.solver.iterations = 50;
      world.params.contact.d_hat = 0.05 * c.radius;
      const Vec3 up = Vec3::UnitY(), Omega = c.omega * up;
      const Index table = world.add(Box{{20, 0.5, 20}}, 1000, {0, -0.5, 0});
      world.add(Sphere{c.radius}, 5000 * volume(Sphere{c.radius}), {0.3, 1.04 * c.radius, 0.2});
      Joint hinge = testing::make_joint(world, JointType::hinge, kWorld, table, Vec3::Zero(), up);
      hinge.drive = Profile{{{0, 0}, {100, 100 * c.omega}}};
      testing::add_joint(world, hinge);
      world.state.omega[0] = Omega;
      const Vec3 v = c.speed * Vec3(0.6, 0, -0.8);
      world.state.v[1] = v;
      world.state.omega[1] = up.cross(v - Omega.cross(world.state.c[1])) / c.radius;
      testing::run(world, 10);
      const Vec3 start = world.state.v[1];
      constexpr int kSteps = 120;
      testing::run(world, kSteps);
      const Vec3 end = world.state.v[1];
      const double turned = std::atan2(start.cross(end).dot(up), start.dot(end));
      INFO("table " << c.omega << " rad/s, ball " << c.speed << " m/s, solver " << to_string(method));
      CHECK(turned == Approx(2.0 / 7 * c.omega * kSteps * world.params.h).epsilon(0.005));
      CHECK(end.norm() == Approx(start.norm()).epsilon(0.005));
    }
  }
}

TEST_CASE("a ball on two rails rolls on the circle that touches them") {
  for (const double turn : {1.0, 3.0, 12.0}) {
    const double h = 1.0 / 60, radius = 0.03, rail = 0.01, half_gauge = 0.022;
    World world;
    world.params.solver.method = SolverMethod::descent;
    world.params.solver.iterations = 50;
    world.params.contact.d_hat = 0.02 * radius;
    const Mat3 along_x = exp_so3({0, 0, -kPi / 2});
    for (const double z : {-half_gauge, half_gauge}) world.add(Capsule{rail, 500}, 0, {200, 0, z}, along_x);
    const double reach = radius + rail + 0.018 * radius;
    const Index ball =
        world.add(Sphere{radius}, 0.3, {0, std::sqrt(reach * reach - half_gauge * half_gauge), 0});
    testing::run(world, 60);
    const double height = world.state.c[ball].y();
    const double rolling = radius * height / std::hypot(height, half_gauge);  // radius of that circle
    const double k = 0.4 * radius * radius / (rolling * rolling), v = turn * radius / h;
    world.state.v[ball] = {v, 0, 0};
    world.state.omega[ball].setZero();
    testing::run(world, static_cast<int>(v / (0.5 * 9.81) / h) + 20);
    INFO("turn " << turn);
    CHECK(world.state.v[ball].x() == Approx(v / (1 + k)).epsilon(0.005));
    CHECK(-world.state.omega[ball].z() * rolling == Approx(v / (1 + k)).epsilon(0.005));
  }
}

TEST_CASE("two balls that meet while one spins fast rub on each other alike, and gain no energy") {
  for (const SolverMethod method : kMethods) {
    for (const double turn : {2.0, 5.0}) {
      World world;
      world.params.gravity.setZero();
      world.params.solver.method = method;
      world.params.solver.iterations = 200;
      world.params.contact.d_hat = 0.002;
      world.add(Sphere{0.1}, 2, {0, 0, 0});
      world.add(Sphere{0.2}, 5, {0.33, 0.05, 0.02});
      world.state.v[0] = {0.8, 0.1, 0};
      world.state.omega[0] = turn * 60 * Vec3(0.3, -0.5, 0.8).normalized();
      const auto spin = [&](std::size_t i) -> Vec3 {
        return inertia_tensor(world.model.J[i]) * world.state.omega[i];  // the same in every frame
      };
      const Vec3 before = spin(0);
      double last = 1e300;
      INFO("turn " << turn << ", solver " << to_string(method));
      testing::run(world, 30, {}, [&](const StepReport& report) {
        CHECK(report.kinetic + report.elastic <= last * (1 + 1e-9));
        last = report.kinetic + report.elastic;
      });
      const Vec3 lost = before - spin(0), gained = -spin(1);
      CHECK(lost.norm() > 0.02);
      CHECK((gained - 2 * lost).norm() < 0.03 * gained.norm());  // levers of 0.2 and 0.1 m, and the gap
    }
  }
}

TEST_CASE("a ball thrown hard at the ground gains no energy and ends rolling") {
  for (const SolverMethod method : kMethods) {
    const auto thrown = [&](double h) {
      Roller ball = at_rest(Sphere{0.05}, kTracks[0], h, method);
      ball.world.state.c[1] += 0.5 * ball.track.up;
      ball.world.state.v[1] = 20 * ball.track.along - 6 * ball.track.up;
      ball.world.state.omega[1].setZero();
      double last = 1e300;
      testing::run(ball.world, static_cast<int>(6 / h), {}, [&](const StepReport& report) {
        const double energy = report.kinetic + report.elastic + report.potential;
        CHECK(energy <= last + 1e-6 * std::abs(last));
        last = energy;
      });
      CHECK(ball.rim() == Approx(ball.speed()).epsilon(1e-3));
      return ball.speed();
    };
    INFO("solver " << to_string(method));
    thrown(1.0 / 60);  // takes more than the 1/h of spin that a step can give
    CHECK(thrown(1.0 / 240) == Approx(5.0 / 7 * 20).epsilon(0.03));
  }
}

TEST_CASE("round bodies that are pressed together roll on each other where friction acts") {
  // With another lever for the slip than for the force, they gain f ω d.
  const double h = GENERATE(1.0 / 60, 1.0 / 240, 1.0 / 1000);
  const double thickness = GENERATE(0.002, 0.02);
  const bool swapped = GENERATE(false, true);
  World world;
  world.params.h = h;
  world.params.gravity.setZero();
  world.params.contact.d_hat = thickness;
  world.params.contact.kappa = 100 * thickness;
  const double r[2] = {swapped ? 0.15 : 0.2, swapped ? 0.2 : 0.15};
  world.add(Sphere{r[0]}, 40, Vec3::Zero());
  world.add(Sphere{r[1]}, 30, {r[0] + r[1] + 0.7 * thickness, 0, 0});
  Joint rod = testing::make_joint(world, JointType::distance, 0, 1, Vec3::Zero());
  rod.on_i.r = rod.on_j.r = Vec3::Zero();
  rod.length = r[0] + r[1] + 0.7 * thickness;
  testing::add_joint(world, rod);
  world.state.omega[0] = {0, 0, 1.5};
  double gap = 0;
  testing::run(world, static_cast<int>(3 / h), {}, [&](const StepReport& report) { gap = report.min_gap; });
  const Vec3 n = (world.state.c[1] - world.state.c[0]).normalized();
  const Vec3 v_a = world.state.v[0] + world.state.omega[0].cross((r[0] + gap / 2) * n);
  const Vec3 v_b = world.state.v[1] - world.state.omega[1].cross((r[1] + gap / 2) * n);
  CAPTURE(h, thickness, swapped, gap);
  CHECK(gap < thickness);
  CHECK(world.state.omega[1].norm() > 0.1);
  CHECK((v_b - v_a).norm() < 0.02 * h);  // implicit Euler
}

}  // namespace pabd::test_rolling
