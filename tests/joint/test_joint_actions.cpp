// SPDX-License-Identifier: MIT
// Motors, dampers and dry friction against closed forms, or against those of the implicit scheme itself:
//   wheel      I (ω' − ω)/h = τ − c ω'
//   block      m (v' − v)/h = F − c v' − k x',  x' = x + h v'
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/joint/expand.h"
#include "sim/math/so3.h"
#include "sim/solver/step_summary.h"
#include "tests/joint/one_joint.h"

namespace pabd::test_joint_actions {

using namespace testing;

namespace {

JointMotor gives_force(const Profile& force) { return {JointMotor::Gives::force, force}; }
JointMotor gives_speed(double speed, double most, double gain = 0) {
  return {JointMotor::Gives::speed, Profile{{{0, speed}}}, most, gain};
}
Profile always(double value) { return Profile{{{0, value}}}; }

}  // namespace

TEST_CASE("a torque τ turns a wheel by ω = τ t/I, a force pushes a block by v = F t/m, in every solver") {
  for (const SolverMethod method :
       {SolverMethod::automatic, SolverMethod::newton, SolverMethod::descent, SolverMethod::sissm}) {
    for (const bool swapped : {false, true}) {
      INFO(to_string(method) << swapped);
      const double sign = swapped ? -1 : 1;  // of the block's motion
      World wheel = one_joint(JointType::hinge, {gives_force(always(1.5))}, Vec3::Zero(), swapped);
      World block = one_joint(JointType::slider, {gives_force(always(1.5))}, Vec3::Zero(), swapped);
      for (World* world : {&wheel, &block}) {
        world->params.solver.method = method;
        world->params.solver.iterations = 500;
        world->params.solver.tolerance = 1e-12;
        run(*world, 60);
      }
      // A sweep of `descent` may leave E higher by 1e-12 of it: √(2e-12 τ Δ/I) a step, 1e-4 in all.
      const double turns_within = method == SolverMethod::descent ? 1e-4 : 1e-6;
      CHECK((wheel.state.omega[0] - Vec3(0, 0, sign * 1.5 / kI)).norm() < turns_within);
      // The iteration of `sissm` weighs a slider's points along the axis as well, and lags there.
      const double within = method == SolverMethod::sissm ? 2e-3 : 1e-6;
      CHECK((block.state.v[0] - Vec3(0, 0, sign * 1.5 / 2)).norm() < within);
    }
  }
}

TEST_CASE("a torque that rises with time gives its integral") {
  World wheel = one_joint(JointType::hinge, {gives_force(Profile{{{0, 0}, {1, 2}}})});
  run(wheel, 60, {}, check_converged);
  CHECK(wheel.state.omega[0].z() == Approx(1.0 / kI).epsilon(1e-9));
}

namespace {

// Two bodies that float, of 0.5 and 500 kg, on a joint beside the centres of both.
constexpr Index kLight = 0, kHeavy = 1;
const Vec3 kAnchor(0.1, 0, 0), kAxis = Vec3(0, 1, 1).normalized();
World floating(JointType type, const JointAction& action) {
  World world;
  world.params.gravity.setZero();
  world.add(Box{{0.2, 0.1, 0.1}}, 0.5, Vec3(0.4, 0, 0));
  world.add(Box{{0.3, 0.2, 0.2}}, 500, Vec3(-0.3, 0.1, 0));
  Joint joint = make_joint(world, type, kHeavy, kLight, kAnchor, kAxis);
  joint.action = action;
  add_joint(world, joint);
  world.model.no_collide.emplace_back(kLight, kHeavy);
  return world;
}
double turns(const World& world) { return (world.state.omega[kLight] - world.state.omega[kHeavy]).norm(); }

}  // namespace

TEST_CASE("a motor between two bodies that float keeps their momentum, for masses 1 to 1000") {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto check = [](const JointMotor& motor, double at_least) {
    World world = floating(JointType::hinge, {motor, 0.05, 0.02});
    run(world, 90, {}, check_converged);
    CHECK(turns(world) > at_least);
    CHECK(momentum(world).norm() < 1e-12 * 500);
    CHECK(spin(world).norm() < 1e-11 * 500);
  };
  check(gives_force(always(0.3)), 1);
  for (const double gain : {0.0, 1e4, 1e8}) check(gives_speed(10, infinity, gain), 9);
}

TEST_CASE("a motor of given speed speeds up with its torque, holds the speed below it, slips above") {
  const double most = 0.6, speed = 4, h = 1.0 / 60;
  World wheel = one_joint(JointType::hinge, {gives_speed(speed, most)});
  for (int k = 1; k <= 60; ++k) {
    run(wheel, 1, {}, check_converged);
    CHECK(wheel.state.omega[0].z() == Approx(std::min(speed, most * k * h / kI)).epsilon(1e-5));
  }
  // Up along z against a weight of 20 N.
  const auto lifted = [&](double force) {
    World lift = one_joint(JointType::slider, {gives_speed(0.5, force)}, Vec3(0, 0, -10));
    run(lift, 60, {}, check_converged);
    return lift.state.v[0].z();
  };
  CHECK(lifted(25) == Approx(std::min(0.5, 2.5)).epsilon(1e-5));
  CHECK(lifted(15) == Approx(-2.5).epsilon(1e-6));  // (15 − 20) N/2 kg for a second
  CHECK(lifted(std::numeric_limits<double>::infinity()) == Approx(0.5).epsilon(1e-5));
}

TEST_CASE("a motor without a largest torque reaches any speed, by 1/h a step, and friction stops one so") {
  const double h = 1.0 / 60;
  for (const double speed : {50.0, 200.0, 400.0, -1000.0}) {
    World wheel = one_joint(JointType::hinge, {gives_speed(speed, std::numeric_limits<double>::infinity())});
    run(wheel, static_cast<int>(std::abs(speed) * h) + 5, {}, check_converged);
    CHECK(wheel.state.omega[0].z() == Approx(speed).epsilon(1e-4));
  }
  World brake = one_joint(JointType::hinge, {{}, 0, 1e6});
  brake.state.omega[0].z() = 400;
  run(brake, 12, {}, check_converged);
  CHECK(brake.state.omega[0].norm() < 1e-3);
}

TEST_CASE("a soft gain speeds a wheel up by as much as it says, however far it is from its speed") {
  const double h = 1.0 / 60, gain = 0.05, speed = 400;
  World wheel =
      one_joint(JointType::hinge, {gives_speed(speed, std::numeric_limits<double>::infinity(), gain)});
  wheel.params.solver.integrator = Integrator::euler;
  double omega = 0;
  for (int k = 0; k < 60; ++k) {
    omega = (omega + h * gain / kI * speed) / (1 + h * gain / kI);
    run(wheel, 1, {}, check_converged);
    CHECK(wheel.state.omega[0].z() == Approx(omega).epsilon(1e-5));
  }
}

TEST_CASE("a gain makes a motor give way to a load: v = v_t − F/g") {
  World lift = one_joint(JointType::slider, {gives_speed(0.5, 100, 80)}, Vec3(0, 0, -10));
  run(lift, 120, {}, check_converged);
  CHECK(lift.state.v[0].z() == Approx(0.5 - 20.0 / 80).epsilon(1e-6));
}

TEST_CASE("a damped wheel, ball and block slow down as implicit Euler has it, near exp(−c t/I)") {
  const double c = 0.2, h = 1.0 / 60;
  const int steps = 60;
  World wheel = one_joint(JointType::hinge, {{}, c}), ball = one_joint(JointType::spherical, {{}, c}),
        block = one_joint(JointType::slider, {{}, c}), tube = one_joint(JointType::cylindrical, {{}, c});
  wheel.state.omega[0].z() = ball.state.omega[0].z() = 2;
  block.state.v[0].z() = tube.state.v[0].z() = 2;
  tube.state.omega[0].z() = 2;
  for (World* world : {&wheel, &ball, &block, &tube}) {
    world->params.solver.integrator = Integrator::euler;
    run(*world, steps, {}, check_converged);
  }
  const double turns = 2 * std::pow(1 + h * c / kI, -steps), slides = 2 * std::pow(1 + h * c / 2, -steps);
  CHECK(wheel.state.omega[0].z() == Approx(turns).epsilon(1e-6));
  CHECK(ball.state.omega[0].z() == Approx(turns).epsilon(1e-6));
  CHECK(block.state.v[0].z() == Approx(slides).epsilon(1e-9));
  CHECK(tube.state.v[0].z() == Approx(slides).epsilon(1e-9));
  CHECK(tube.state.omega[0].z() == Approx(2).epsilon(1e-9));
  // First order: half the step, half the distance from the exact solution.
  const double exact = 2 * std::exp(-c / kI);
  World fine = one_joint(JointType::hinge, {{}, c});
  fine.params.h = h / 2;
  fine.params.solver.integrator = Integrator::euler;
  fine.state.omega[0].z() = 2;
  run(fine, 2 * steps);
  CHECK((wheel.state.omega[0].z() - exact) / (fine.state.omega[0].z() - exact) == Approx(2).epsilon(0.02));
}

TEST_CASE("dampers of any strength only take energy, in each step by Euler") {
  for (const double c : {1e-3, 1.0, 1e3, 1e6}) {
    for (const JointType type :
         {JointType::hinge, JointType::spherical, JointType::slider, JointType::cylindrical}) {
      World world = one_joint(type, {{}, c}, Vec3(0, -9.81, 0));
      world.params.solver.integrator = Integrator::euler;
      world.state.omega[0] = Vec3(0, 0, 30);
      world.state.v[0].z() = 20;
      if (type == JointType::hinge || type == JointType::spherical) world.state.v[0].setZero();
      if (type == JointType::slider) world.state.omega[0].setZero();
      double energy = kinetic_energy(world.model, world.state);
      INFO(to_string(type) << " c " << c);
      run(world, 30, {}, [&](const StepReport& r) {
        REQUIRE(r.kinetic <= energy * (1 + 1e-9) + 1e-12);
        CHECK(r.drive_work <= 1e-12);
        energy = r.kinetic;
      });
    }
  }
}

TEST_CASE(
    "dampers of any strength beside the centres of bodies that float only take energy, in each step by "
    "Euler") {
  for (const double c : {1e-3, 1.0, 1e3, 1e6, 1e9}) {
    for (const JointType type : {JointType::hinge, JointType::spherical}) {
      World world = floating(type, {{}, c});
      world.params.solver.integrator = Integrator::euler;
      world.state.omega[kLight] = 10 * kAxis;
      world.state.v[kLight] = world.state.omega[kLight].cross(world.state.c[kLight] - kAnchor);
      const Vec3 before = momentum(world), spun = spin(world);
      double energy = kinetic_energy(world.model, world.state);
      INFO(to_string(type) << " c " << c);
      run(world, 30, {}, [&](const StepReport& r) {
        check_converged(r);
        REQUIRE(r.kinetic + r.elastic <= energy * (1 + 1e-9));
        energy = r.kinetic + r.elastic;
      });
      CHECK((momentum(world) - before).norm() < 1e-12 * 500);
      CHECK((spin(world) - spun).norm() < 1e-11 * 500);
      if (c >= 1e3) CHECK(turns(world) < 1e-6);
    }
  }
}

TEST_CASE("a damper resists a small motion by its energy, and not at all one that it does not see") {
  const Mat3 F = exp_so3(Vec3(0.3, 0.2, -0.4));
  for (const JointType type : {JointType::hinge, JointType::spherical, JointType::slider,
                               JointType::cylindrical, JointType::distance}) {
    INFO(to_string(type));
    Joint joint;
    joint.type = type;
    joint.arm = 0.2;
    joint.action = JointAction{{}, 1};
    const PlacedFrame fi{Vec3(0.1, 0.2, 0.3), F},
        fj{fi.y + (type == JointType::distance ? Vec3(0.3, 0.4, 0) : Vec3(Vec3::Zero())), F};
    ActionStep action;
    action.damping = 200;
    const auto energy = [&](const PlacedFrame& at) {
      BondList list;
      add_action(joint, action, {fi, at}, list);
      double sum = 0;
      for (int k = 0; k < list.count; ++k) sum += evaluate(joint.law, list.bond[k]).energy;
      return sum;
    };
    // Of a length also where it is 0.1 m longer than at the start, and pulls, or shorter.
    for (const double start : {0.5, 0.4, 0.6}) {
      action.start = type == JointType::distance ? start : 0;
      BondList list;
      add_action(joint, action, {fi, fj}, list);
      for (int way = 0; way < 6; ++way) {
        const double small = 1e-4;
        const Vec3 go = way < 3 ? small * F.col(way) : Vec3(Vec3::Zero()),
                   turn = way < 3 ? Vec3(Vec3::Zero()) : small * F.col(way - 3);
        double model = 0;
        for (int k = 0; k < list.count; ++k) {
          const Vec3 d = go + turn.cross(list.bond[k].y_b - fj.y);
          model += d.dot(evaluate(joint.law, list.bond[k]).weight * d);
        }
        const double second =
            energy({fj.y + go, exp_so3(turn) * F}) + energy({fj.y - go, exp_so3(-turn) * F}) - 2 * energy(fj);
        if (type == JointType::distance && start > 0.5) {
          CHECK(second <= model + 1e-10);  // a push would rather give way across the line
        } else {
          CHECK(second == Approx(model).epsilon(1e-4).margin(1e-10));
        }
      }
    }
  }
}

TEST_CASE("a spring with a damper moves as implicit Euler has it") {
  const double m = 3, k = 40, c = 2, h = 1.0 / 60, length = 1;
  World world;
  world.params.solver.integrator = Integrator::euler;
  world.params.gravity.setZero();
  const Index ball = world.add(Sphere{0.1}, m, Vec3(1.3, 0, 0));
  Joint joint;
  joint.type = JointType::distance;
  joint.j = ball;
  joint.length = length;
  joint.law.kappa = k;
  joint.on_i = {Vec3::Zero(), Mat3::Identity()};
  joint.on_j = {Vec3::Zero(), Mat3::Identity()};
  joint.action = JointAction{{}, c};
  world.model.joints.push_back(joint);
  double x = 0.3, v = 0;
  for (int n = 0; n < 120; ++n) {
    v = (v - h / m * k * x) / (1 + h / m * (c + h * k));
    x += h * v;
    run(world, 1, {}, check_converged);
    CHECK(world.state.c[ball].x() - length == Approx(x).margin(1e-7));
  }
  CHECK(world.state.v[ball].x() == Approx(v).margin(1e-6));
}

TEST_CASE("dry friction brakes with its force, then holds against less") {
  const double h = 1.0 / 60;
  World block = one_joint(JointType::slider, {{}, 0, 4});
  block.state.v[0].z() = 1;
  for (int k = 1; k <= 60; ++k) {  // 2 m/s²
    run(block, 1, {}, check_converged);
    CHECK(block.state.v[0].z() == Approx(std::max(0.0, 1 - 2 * k * h)).margin(1e-6));
  }
  World held = one_joint(JointType::slider, {{}, 0, 21}, Vec3(0, 0, -10));
  run(held, 60, {}, check_converged);
  CHECK(held.state.c[0].z() == Approx(-60 * 20 / (1e5 * 2 / (h * h))).epsilon(1e-3));  // F/k a step
  World slips = one_joint(JointType::slider, {{}, 0, 19}, Vec3(0, 0, -10));
  run(slips, 60, {}, check_converged);
  CHECK(slips.state.v[0].z() == Approx(-0.5).epsilon(1e-6));
}

TEST_CASE("friction holds a soft joint as it does a stiff one") {
  World arm;
  const Index box = arm.add(Box{{0.3, 0.3, 0.1}}, 2, Vec3(0.3, 0.5, 0));
  Joint joint = make_joint(arm, JointType::hinge, kWorld, box, Vec3(0, 0.5, 0));
  joint.law.kappa = 1e4;
  joint.action = JointAction{{}, 0, 8};  // against 5.9 N m
  arm.model.joints.push_back(joint);
  run(arm, 60, {}, check_converged);
  CHECK(std::abs(arm.state.R[box](1, 0)) < 1e-5);
}

TEST_CASE("what a motor puts in is its torque times the angle, and at most that is found as energy") {
  const auto integrator = GENERATE(Integrator::euler, Integrator::bdf2);
  World wheel = one_joint(JointType::hinge, {gives_force(always(1.5))});
  wheel.params.solver.integrator = integrator;
  double work = 0, kinetic = 0, angle = 0;
  Mat3 last = wheel.state.R[0];
  run(wheel, 60, {}, [&](const StepReport& r) {
    work += r.drive_work;
    kinetic = r.kinetic;
    CHECK(r.elastic < 1e-12);
    const Mat3& now = wheel.state.R[0];
    angle += std::atan2((now * last.transpose())(1, 0), (now * last.transpose())(0, 0));
    last = now;
  });
  CHECK(angle == Approx(0.5 * 1.5 / kI).epsilon(integrator == Integrator::euler ? 1.0 / 59 : 1e-3));
  CHECK(work == Approx(1.5 * angle).epsilon(1e-6));
  CHECK(kinetic == Approx(0.5 * 1.5 * 1.5 / kI).epsilon(1e-6));
}

namespace {

// Arms one behind the other, each moved against the one before in its own way.
World arms(int count) {
  World world;
  Index last = kWorld;
  for (int k = 0; k < count; ++k) {
    const Index arm = world.add(Box{{0.25, 0.05, 0.05}}, 1 + 0.3 * k, Vec3(0.5 * k + 0.25, 2, 0));
    Joint joint = make_joint(world, JointType::hinge, last, arm, Vec3(0.5 * k, 2, 0),
                             k % 2 ? Vec3::UnitY() : Vec3::UnitZ());
    joint.arm = 0.1;
    if (k % 3 == 0) joint.action = JointAction{gives_speed(1, 40), 0.1, 0};
    if (k % 3 == 1) joint.action = JointAction{gives_force(always(2)), 0.3, 1};
    if (k % 3 == 2) joint.action = JointAction{{}, 0.5, 2};
    add_joint(world, joint);
    if (k > 0) world.model.no_collide.emplace_back(last, arm);
    last = arm;
  }
  return world;
}

}  // namespace

TEST_CASE("an arm of many motors and brakes converges, to the same bytes for any number of threads") {
  World one = arms(12), three = arms(12);
  int iterations = 0;
  run(one, 120, StepOptions{.threads = 1}, [&](const StepReport& r) {
    check_converged(r);
    iterations += r.iterations;
  });
  CHECK(iterations < 120 * 8);
  run(three, 120, StepOptions{.threads = 3});
  for (std::size_t i = 0; i < one.state.c.size(); ++i) {
    CHECK(one.state.c[i] == three.state.c[i]);
    CHECK(one.state.omega[i] == three.state.omega[i]);
  }
}

}  // namespace pabd::test_joint_actions
