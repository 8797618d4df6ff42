// SPDX-License-Identifier: MIT
// Mechanisms and what hangs on joints: loads of all masses, loops, wheels and figures, against statics, kinematics and
// the conservation of energy.
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/body/shape_kind.h"
#include "tests/support/places.h"
#include "tests/world/world.h"

namespace pabd::test_joints {

using namespace world;

namespace {

// Links one below the other from `from` on, each of its own length along `along`, joined at their ends; the last is a ball.
// Gives back their names, the ball's last.
std::vector<std::string> hang(Setting& setting, int links, double length, double link_mass, double weight,
                              const Vec3& from, const Vec3& along) {
  std::vector<std::string> names;
  std::string before;
  const double degrees = std::atan2(-along.x(), -along.y()) / kDegree;
  for (int k = 0; k < links; ++k) {
    names.push_back(setting.add(Capsule{0.1 * length, 0.7 * length}, link_mass,
                                from + (k + 0.5) * length * along, about_z(-degrees)));
    setting.join(JointType::spherical, before, names.back(), from + k * length * along);
    before = names.back();
  }
  const Vec3 end = from + links * length * along;
  names.push_back(setting.add(Sphere{0.4 * length}, weight, end + 0.5 * length * along));
  setting.join(JointType::spherical, before, names.back(), end);
  return names;
}

}  // namespace

// A heavy weight on a light chain stretches it in every engine of impulses: godot issue 50002, reactphysics3d issue 329.
TEST_CASE("a chain of light links holds a weight a thousand times theirs, at rest and in swing") {
  const int links = GENERATE(5, 20, 60);
  const double ratio = GENERATE(1.0, 1000.0), h = GENERATE(1.0 / 30, 1.0 / 60, 1.0 / 240),
               degrees = GENERATE(0.0, 60.0);
  CAPTURE(links, ratio, h, degrees);
  const double length = 0.1, mass = 0.05;
  const Vec3 along(std::sin(degrees * kDegree), -std::cos(degrees * kDegree), 0);
  Setting setting(h);
  const auto names = hang(setting, links, length, mass, ratio * mass, Vec3::Zero(), along);
  Run run(setting);
  run.go(2);
  CHECK(run.joint_error < 1e-4 * length);
  CHECK(run.rise < 1e-6 * run.weight() * links * length);
  if (degrees == 0) {
    CHECK(run.report.joint_reports[0].force.y() == Approx(run.weight()).epsilon(1e-4));
    CHECK(run.way(names.back()).norm() < 1e-4 * length);
  }
}

// A pendulum's speed at its lowest point: energy. Steps of implicit Euler take ω² h/2 of the amplitude a second.
TEST_CASE(
    "a weight on a chain swings through its lowest point with sqrt(2 g L (1 - cos)), whatever the masses") {
  const double ratio = GENERATE(300.0, 3000.0), degrees = GENERATE(20.0, 50.0);
  CAPTURE(ratio, degrees);
  const Vec3 along(std::sin(degrees * kDegree), -std::cos(degrees * kDegree), 0);
  Setting setting(1.0 / 1000);
  const auto names = hang(setting, 8, 0.2, 0.02, 0.02 * ratio, Vec3::Zero(), along);
  Run run(setting);
  const double L = 8.5 * 0.2;
  double fastest = 0;
  run.go(1.2, [&] { fastest = std::max(fastest, run.v(names.back()).norm()); });
  CHECK(fastest == Approx(std::sqrt(2 * kG * L * (1 - std::cos(degrees * kDegree)))).epsilon(0.01));
  CHECK(run.joint_error < 1e-5);
}

// A tower of blocks on rigid joints under a heavy one sways and falls: JoltPhysics issue 1392.
TEST_CASE("blocks joined rigidly carry a head of a hundred times their mass, upright and sideways") {
  const double head = GENERATE(1.0, 10.0, 100.0), h = GENERATE(1.0 / 60, 1.0 / 240);
  const bool sideways = GENERATE(false, true);
  CAPTURE(head, h, sideways);
  const Vec3 along = sideways ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  Setting setting(h);
  std::string before;
  for (int k = 0; k < 6; ++k) {
    const std::string block =
        setting.add(Box{Vec3::Constant(k % 2 ? 0.2 : 0.1)}, k == 5 ? head : 1, (0.15 + 0.3 * k) * along);
    setting.join(JointType::fixed, before, block, 0.3 * k * along);
    before = block;
  }
  Run run(setting);
  run.go(2);
  CHECK(run.way(before).norm() < 1e-4);
  CHECK(run.report.joint_reports[0].force.y() == Approx(run.weight()).epsilon(1e-4));
  double moment = 0;  // about the foot
  for (int k = 0; k < 6; ++k) moment += (k == 5 ? head : 1) * kG * (0.15 + 0.3 * k);
  CHECK(run.report.joint_reports[0].moment.z() ==
        Approx(sideways ? moment : 0).epsilon(1e-3).margin(1e-3 * head));
}

// IFToMM's benchmark A02 is a four-bar linkage that passes through its singular pose; this one is a parallelogram of
// other lengths and masses that swings: energy gives its speed.
TEST_CASE("a parallelogram of bars swings through its lowest pose with the speed that energy gives") {
  const double crank = GENERATE(0.5, 1.5), coupler = GENERATE(0.6, 2.0),
               m = GENERATE(0.3, 20.0);  // m of the coupler
  CAPTURE(crank, coupler, m);
  Setting setting(1.0 / 1000);
  const double degrees = 40;  // of the cranks from straight down
  const Vec3 down(std::sin(degrees * kDegree), -std::cos(degrees * kDegree), 0), across(coupler, 0, 0);
  const auto bar = [&](double length, double mass, const Vec3& middle, double turn) {
    return setting.add(Box{Vec3(length, 0.04, 0.04) / 2}, mass, middle, about_z(turn));
  };
  const std::string one = bar(crank, 1, crank / 2 * down, degrees - 90);
  const std::string other = bar(crank, 1, across + crank / 2 * down, degrees - 90);
  const std::string link = bar(coupler, m, crank * down + across / 2, 0);
  setting.join(JointType::hinge, "", one, Vec3::Zero());
  setting.join(JointType::hinge, "", other, across);
  setting.join(JointType::hinge, one, link, crank * down);
  setting.join(JointType::hinge, link, other, crank * down + across);
  Run run(setting);
  double fastest = 0;
  run.go(0.9 * std::sqrt(crank), [&] { fastest = std::max(fastest, run.v(link).norm()); });
  const double fall = crank * (1 - std::cos(degrees * kDegree));
  const double inertia = m * crank * crank + 2 * (crank * crank + 0.04 * 0.04) / 12 + 2 * crank * crank / 4;
  const double omega = std::sqrt(2 * kG * fall * (m + 1) / inertia);
  CHECK(fastest == Approx(omega * crank).epsilon(0.01));
  CHECK(run.joint_error < 1e-6);
  CHECK(run.rise < 1e-9 * run.weight());
}

// Ragdolls that fall downstairs: heavy and light limbs explode in O3DE's issue 2610.
TEST_CASE("a ragdoll that falls down the stairs at long steps makes no energy and stays in one piece") {
  const double h = GENERATE(1.0 / 60, 1.0 / 120, 1.0 / 480), forward = GENERATE(0.0, 0.25, 0.5);
  CAPTURE(h, forward);
  SceneBuilder builder("stairs", places::scenes());
  builder.params.h = h;
  builder.add(spec::Include{.scene = "ragdoll.json", .position = Vec3(forward, 0.0, 0)});
  spec::Body ground;
  ground.shape = Plane{Vec3::UnitY(), 0};
  builder.add(ground);
  Run run(builder.build());
  run.go(3);
  CHECK(run.rise < 1e-6 * run.begin);
  CHECK(run.joint_error < 1e-3);
  for (std::size_t i = 0; i < run.state.c.size(); ++i) {
    const bool moves = run.scene.model.fixed[i] == 0;
    CHECK((!moves || run.state.c[i].y() > 0.02));
  }
}

namespace {

// A rope bridge of planks between two fixed posts, hinged end to end. Gives back the name of the middle plank.
std::string add_bridge(Setting& setting, int planks, double length) {
  std::string before, middle;
  for (int k = 0; k < planks; ++k) {
    const double x = (k + 0.5 - planks / 2.0) * length;
    const std::string plank = setting.add(Box{{0.48 * length, 0.02, 0.4}}, 2, {x, 2, 0});
    setting.join(JointType::hinge, before, plank, {x - length / 2, 2, 0});
    if (k == planks / 2) middle = plank;
    before = plank;
  }
  setting.join(JointType::hinge, before, "", {planks / 2.0 * length, 2, 0});
  return middle;
}

}  // namespace

// Box2D's "Bridge", with what falls on it.
TEST_CASE("a bridge of planks holds crates that fall on it, light and heavy") {
  const int planks = GENERATE(8, 25);
  const double mass = GENERATE(0.1, 5.0, 400.0), h = GENERATE(1.0 / 60, 1.0 / 240);
  CAPTURE(planks, mass, h);
  Setting setting(h);
  const std::string middle = add_bridge(setting, planks, 0.3);
  std::vector<std::string> crates;
  for (int k = 0; k < 3; ++k)
    crates.push_back(setting.add(Box{{0.12, 0.12, 0.12}}, mass, {0.5 * (k - 1), 2.4 + 0.3 * k, 0.05 * k}));
  Run run(setting);
  run.go(2);
  CHECK(run.joint_error < 1e-4);
  CHECK(run.rise < 1e-6 * run.begin);
  CHECK(run.way(middle).norm() < 0.05);  // its ends are as far apart as it is long
}

namespace {

// Two arms on a stem that begin in each other and are joined to the same end: what other people's robots are like.
Run forked(double degrees, double radius, double h) {
  Setting setting(h, 1);
  setting.add(Capsule{radius, 1}, 30, {0, 0.5, 0});
  for (const double side : {-1.0, 1.0}) {
    const double angle = side * degrees;
    const Vec3 out(-std::sin(angle * kDegree), std::cos(angle * kDegree), 0);
    const std::string arm = setting.add(Capsule{radius, 1.2}, 35, Vec3(0, 1, 0) + 0.6 * out, about_z(angle));
    setting.join(JointType::hinge, "b0", arm, {0, 1, 0});
  }
  setting.join(JointType::hinge, "", "b0", Vec3::Zero());
  return Run(setting);
}

// What overlaps comes apart at 3 m/s at most (contact.recovery_speed): no more energy than all bodies have at that speed.
void check_gentle(Run& run, double seconds) {
  double most = 0;
  run.go(seconds, [&] { most = std::max(most, run.report.kinetic + run.report.potential - run.begin); });
  CHECK(most < run.weight() / kG * 3 * 3 / 2);
}

}  // namespace

// Links two joints apart that overlap at the start: T1 of the findings, MoveIt and Drake leave such pairs out.
TEST_CASE("a fork whose arms begin inside each other comes apart gently") {
  const double degrees = GENERATE(25.0, 45.0, 70.0), radius = GENERATE(0.05, 0.12),
               h = GENERATE(1.0 / 60, 1.0 / 240);
  CAPTURE(degrees, radius, h);
  Run run = forked(degrees, radius, h);
  check_gentle(run, 3);
  CHECK(run.joint_error < 1e-3);
}

}  // namespace pabd::test_joints
