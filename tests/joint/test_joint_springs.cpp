// SPDX-License-Identifier: MIT
// Springs of joints against closed forms: T = 2π √(I/s), the rest angle under gravity, the implicit scheme itself
//   I (ω' − ω)/h = −s (φ' − φ₀),  φ' = φ + h ω'
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/solver/step_summary.h"
#include "tests/joint/one_joint.h"

namespace pabd::test_joint_springs {

using namespace testing;

namespace {

constexpr double kStiffness = 12;

JointAction spring(double stiffness, double rest, double damping = 0) {
  return {{}, damping, 0, {stiffness, rest}};
}

JointAction table(std::vector<std::pair<double, double>> points, double rest = 0) {
  JointAction action;
  action.spring.table.points = std::move(points);
  action.spring.rest = rest;
  return action;
}

double angle(const World& world) { return std::atan2(world.state.R[0](1, 0), world.state.R[0](0, 0)); }
double offset(const World& world) { return world.state.c[0].z(); }

// Mean time between the moments at which `value` comes up through 0.
template <class Value>
double period(World& world, int steps, const Value& value) {
  double first = 0, last = 0, before = value(world);
  int count = 0;
  run(world, steps, {}, [&](const StepReport& r) {
    REQUIRE(r.status == StepStatus::converged);
    const double now = value(world);
    if (before < 0 && now >= 0) {
      last = r.time - world.params.h * now / (now - before);
      if (count++ == 0) first = last;
    }
    before = now;
  });
  REQUIRE(count > 3);
  return (last - first) / (count - 1);
}

}  // namespace

TEST_CASE("the period of a torsional pendulum is 2π √(I/s), of a block on a spring 2π √(m/s)") {
  World wheel = one_joint(JointType::hinge, spring(kStiffness, 0.4)),
        block = one_joint(JointType::slider, spring(kStiffness, 0.3));
  for (World* world : {&wheel, &block}) world->params.h = 1.0 / 960;
  const double turns = period(wheel, 4000, [](const World& w) { return angle(w) - 0.4; });
  CHECK(turns == Approx(2 * kPi * std::sqrt(kI / kStiffness)).epsilon(2e-4));
  const double slides = period(block, 10000, [](const World& w) { return offset(w) - 0.3; });
  CHECK(slides == Approx(2 * kPi * std::sqrt(2 / kStiffness)).epsilon(2e-4));
}

TEST_CASE("the energy of a table is the integral of its force from 0, wherever that is") {
  for (const double shift : {-3.0, -0.5, 0.0, 0.7, 3.0}) {
    const ForceTable uneven{{{shift - 1, -2}, {shift - 0.2, 1}, {shift + 0.1, 1}, {shift + 1, 7}}};
    for (double x = -5; x <= 5; x += 0.37) {
      CAPTURE(shift, x);
      constexpr int kParts = 20000;
      double sum = 0;
      for (int k = 0; k < kParts; ++k) sum += uneven.at(x * (k + 0.5) / kParts).force * x / kParts;
      CHECK(uneven.at(x).energy == Approx(sum).margin(1e-5));
      const double dx = 1e-6;
      CHECK(uneven.at(x).force ==
            Approx((uneven.at(x + dx).energy - uneven.at(x - dx).energy) / (2 * dx)).margin(1e-4));
    }
  }
}

// A play of ±g between two springs k: 4 g/v for the play and 2π √(m/k) for both springs, v = √(k/m) (A − g).
TEST_CASE("a block with a play between two springs swings with the period that follows") {
  const double play = 0.1, most = 0.25, mass = 2;
  for (const bool swapped : {false, true}) {
    CAPTURE(swapped);
    World block = one_joint(
        JointType::slider,
        table({{-1, -kStiffness * (1 - play)}, {-play, 0}, {play, 0}, {0.2, kStiffness * (0.2 - play)}}),
        Vec3::Zero(), swapped);
    block.params.h = 1.0 / 960;
    const double speed = std::sqrt(kStiffness / mass) * (most - play);
    block.state.v[0] = Vec3(0, 0, speed);
    double highest = 0;
    const double slides = period(block, 18000, [&](const World& w) {
      highest = std::max(highest, offset(w));
      return offset(w);
    });
    CHECK(slides == Approx(4 * play / speed + 2 * kPi * std::sqrt(mass / kStiffness)).epsilon(2e-3));
    CHECK(highest == Approx(most).epsilon(2e-3));
  }
}

TEST_CASE("a spring by a straight table is the spring with that stiffness, in energy as well") {
  for (const JointType type : {JointType::hinge, JointType::slider}) {
    World by_table = one_joint(type, table({{-0.1, -0.1 * kStiffness}, {0.3, 0.3 * kStiffness}}, 0.4)),
          plain = one_joint(type, spring(kStiffness, 0.4));
    std::vector<double> energy;
    run(plain, 200, {}, [&](const StepReport& r) { energy.push_back(r.elastic); });
    std::size_t k = 0;
    run(by_table, 200, {},
        [&](const StepReport& r) { CHECK(r.elastic == Approx(energy[k++]).margin(1e-12)); });
    CHECK((by_table.state.c[0] - plain.state.c[0]).norm() < 1e-12);
    CHECK((by_table.state.R[0] - plain.state.R[0]).norm() < 1e-12);
  }
}

// Pressed beyond the hump at 0.1 m it would snap through to where it carries the weight again: 20 N at 0.2 m.
TEST_CASE("a spring that gives way snaps through to where it carries its load, and makes no energy") {
  JointAction gives_way = table({{0, 0}, {0.1, 15}, {0.15, 5}, {0.25, 35}});
  gives_way.damping = 8;
  World block = one_joint(JointType::slider, gives_way, Vec3(0, 0, 10));
  run(block, 900, {}, [](const StepReport& r) { CHECK(r.kinetic + r.potential + r.elastic < 1e-3); });
  CHECK(offset(block) == Approx(0.2).margin(1e-6));
}

TEST_CASE("springs move as implicit Euler has it, in every solver and either way round") {
  const double h = 1.0 / 60;
  for (const SolverMethod method :
       {SolverMethod::automatic, SolverMethod::newton, SolverMethod::descent, SolverMethod::sissm}) {
    for (const bool swapped : {false, true}) {
      INFO(to_string(method) << swapped);
      World wheel = one_joint(JointType::hinge, spring(kStiffness, 0.4), Vec3::Zero(), swapped),
            block = one_joint(JointType::slider, spring(kStiffness, 0.3), Vec3::Zero(), swapped);
      const double sign = swapped ? -1 : 1;  // of the block's motion
      for (World* world : {&wheel, &block}) {
        world->params.solver.method = method;
        world->params.solver.integrator = Integrator::euler;
        world->params.solver.iterations = 500;
        world->params.solver.tolerance = 1e-12;
      }
      double phi = 0, omega = 0, x = 0, v = 0;
      for (int n = 0; n < 60; ++n) {
        omega = (omega - h / kI * kStiffness * (phi - 0.4)) / (1 + h * h / kI * kStiffness);
        phi += h * omega;
        v = (v - h / 2 * kStiffness * (x - 0.3)) / (1 + h * h / 2 * kStiffness);
        x += h * v;
        run(wheel, 1);
        run(block, 1);
      }
      const bool exact = method == SolverMethod::newton || method == SolverMethod::automatic;
      const double within = exact ? 1e-4 : 2e-3;  // a turn's inertia is that of sin(ω h): 2e-5 of it
      CHECK(std::abs(sign * angle(wheel) - phi) < within);
      CHECK(std::abs(sign * offset(block) - x) < within);
    }
  }
}

TEST_CASE(
    "a spring holds an arm where its torque is that of the weight, and a block by m g/s below its rest") {
  World arm;
  const Index box = arm.add(Box{{0.3, 0.05, 0.05}}, 2, Vec3(0.3, 0.5, 0));
  Joint joint = make_joint(arm, JointType::hinge, kWorld, box, Vec3(0, 0.5, 0));
  joint.action = spring(8, 0.5, 2);
  add_joint(arm, joint);
  run(arm, 900, {}, check_converged);
  double low = -kPi / 2, high = 0.5;  // s (φ₀ − φ) = m g r cos φ
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (8 * (0.5 - middle) > 2 * 9.81 * 0.3 * std::cos(middle) ? low : high) = middle;
  }
  CHECK(angle(arm) == Approx(low).margin(1e-6));
  World block = one_joint(JointType::slider, spring(40, 0.1, 10), Vec3(0, 0, -10));
  run(block, 900, {}, check_converged);
  CHECK(offset(block) == Approx(0.1 - 20.0 / 40).margin(1e-6));
}

TEST_CASE("the energy of a spring is in the report; together with what moves it never rises") {
  const auto integrator = GENERATE(Integrator::euler, Integrator::bdf2);
  for (const double stiffness : {1e-2, 1.0, 1e2, 1e4, 1e6}) {
    for (const SolverMethod method : {SolverMethod::newton, SolverMethod::descent, SolverMethod::sissm}) {
      for (const JointType type : {JointType::hinge, JointType::slider}) {
        World world = one_joint(type, spring(stiffness, 0.5));
        world.params.solver.method = method;
        world.params.solver.integrator = integrator;
        INFO(to_string(integrator) << to_string(type) << ' ' << to_string(method) << ' ' << stiffness);
        const double first = 0.5 * stiffness * 0.25;
        double energy = first;
        run(world, 60, {}, [&](const StepReport& r) {
          CHECK(r.kinetic + r.elastic <= energy * (1 + 1e-6) + 1e-9);
          CHECK(std::abs(r.drive_work) < 1e-12);
          const double away = (type == JointType::hinge ? angle(world) : offset(world)) - 0.5;
          CHECK(r.elastic == Approx(0.5 * stiffness * away * away).margin(1e-3 * first));
          if (integrator == Integrator::euler) energy = r.kinetic + r.elastic;  // of bdf2: above its start
        });
      }
    }
  }
}

TEST_CASE("a spring of a hinge takes the shorter way round") {
  World wheel = one_joint(JointType::hinge, spring(kStiffness, 170 * kPi / 180, 3));
  const double from = -170 * kPi / 180;
  wheel.state.R[0] = Eigen::AngleAxisd(from, Vec3::UnitZ()).toRotationMatrix();
  bool through_half = false;
  run(wheel, 300, {}, [&](const StepReport& r) {
    check_converged(r);
    CHECK(std::abs(angle(wheel)) > 165 * kPi / 180);
    through_half = through_half || angle(wheel) > 0;
  });
  CHECK(through_half);
  CHECK(angle(wheel) == Approx(170 * kPi / 180).margin(1e-6));
}

TEST_CASE("a spring between two bodies that float keeps their momentum") {
  World world;
  world.params.gravity.setZero();
  const Index light = world.add(Box{{0.2, 0.1, 0.1}}, 0.5, Vec3(0.4, 0, 0)),
              heavy = world.add(Box{{0.3, 0.2, 0.2}}, 500, Vec3(-0.3, 0.1, 0));
  Joint joint =
      make_joint(world, JointType::hinge, heavy, light, Vec3(0.1, 0, 0), Vec3(0, 1, 1).normalized());
  joint.action = spring(2, 0.7);
  add_joint(world, joint);
  world.model.no_collide.emplace_back(light, heavy);
  run(world, 90, {}, [&](const StepReport& r) {
    check_converged(r);
    CHECK(momentum(world).norm() < 1e-12 * 500);
    CHECK(spin(world).norm() < 1e-11 * 500);
  });
  CHECK(world.state.omega[light].norm() > 0.1);
}

}  // namespace pabd::test_joint_springs
