// SPDX-License-Identifier: MIT
// Mechanisms that a drive moves, against their kinematics. A drive does what work its motion takes: no step is made again, and
// nothing is slowed down.
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/math/so3.h"
#include "tests/world/world.h"

namespace pabd::test_drives {

using namespace world;

namespace {

constexpr double kTurn = 2 * kPi;  // rad/s

// About the origin, from its place on.
void turn_steadily(Setting& setting, const std::string& crank) {
  setting.builder.add(spec::Joint{.type = JointType::hinge,
                                  .j = crank,
                                  .anchor = Vec3(0, 0, 0),
                                  .axis = Vec3::UnitZ(),
                                  .drive = Profile{{{0, 0}, {10, 3600}}}});
}

// A bar from one point to another, in its own plane.
std::string add_bar(Setting& setting, const Vec3& from, const Vec3& to, double plane, double mass) {
  const Vec3 along = to - from;
  const double degrees = std::atan2(along.y(), along.x()) / kDegree;
  return setting.add(Box{Vec3(along.norm(), 0.04, 0.04) / 2}, mass, (from + to) / 2 + plane * Vec3::UnitZ(),
                     about_z(degrees));
}

// Where the coupler meets the rocker: so far from both, on the left of the way from the first to the second.
Vec3 meet(const Vec3& from, double coupler, const Vec3& pivot, double rocker) {
  const Vec3 way = pivot - from;
  const double d = way.norm();
  const double along = (coupler * coupler - rocker * rocker + d * d) / (2 * d);
  const double aside = std::sqrt(coupler * coupler - along * along);
  return from + (along * way + aside * Vec3::UnitZ().cross(way)) / d;
}

}  // namespace

// The slider-crank of every book on mechanisms.
TEST_CASE("the piston of a driven crank is at r cos φ + sqrt(l² − r² sin² φ)") {
  const double r = GENERATE(0.1, 0.4), ratio = GENERATE(1.5, 4.0), mass = GENERATE(0.5, 500.0),
               h = GENERATE(1.0 / 60, 1.0 / 240);
  CAPTURE(r, ratio, mass, h);
  const double l = ratio * r;
  Setting setting(h);
  const std::string crank = setting.add(Box{Vec3(r, 0.1 * r, 0.1 * r) / 2}, 1, {r / 2, 0, 0});
  const std::string rod = setting.add(Box{Vec3(l, 0.1 * r, 0.1 * r) / 2}, 1, {r + l / 2, 0, 0});
  const std::string piston = setting.add(Box{Vec3::Constant(0.2 * r)}, mass, {r + l, 0, 0});
  turn_steadily(setting, crank);
  setting.join(JointType::hinge, crank, rod, {r, 0, 0});
  setting.join(JointType::hinge, rod, piston, {r + l, 0, 0});
  setting.join(JointType::slider, "", piston, {r + l, 0, 0}, Vec3::UnitX());
  Run run(setting);
  double error = 0;
  run.go(2, [&] {
    const double angle = kTurn * run.state.time;
    const double x = r * std::cos(angle) + std::sqrt(l * l - r * r * std::sin(angle) * std::sin(angle));
    error = std::max(error, std::abs(run.c(piston).x() - x));
  });
  CHECK(error < 1e-5 * r);
  CHECK(run.joint_error < 1e-5 * r);
  CHECK(run.halved == 0);
}

// Grashof's: a crank and a rocker, and two that go round.
TEST_CASE("a driven linkage of four bars goes where the lengths of its bars say, whatever they weigh") {
  struct Bars {
    double crank, coupler, rocker, ground;
  };
  const Bars bars = GENERATE(Bars{0.2, 0.6, 0.4, 0.6}, Bars{0.2, 0.5, 0.5, 0.5}, Bars{0.5, 0.55, 0.5, 0.2});
  const double a = bars.crank, b = bars.coupler, c = bars.rocker, d = bars.ground;
  const double heavy = GENERATE(0.1, 5.0, 200.0), h = GENERATE(1.0 / 30, 1.0 / 60, 1.0 / 240, 1.0 / 1000);
  CAPTURE(a, b, c, d, heavy, h);
  const auto crank_end = [&](double angle) { return Vec3(a * std::cos(angle), a * std::sin(angle), 0); };
  const Vec3 pivot(d, 0, 0), from = crank_end(0), to = meet(from, b, pivot, c);
  Setting setting(h);
  setting.builder.params.solver.integrator = GENERATE(Integrator::euler, Integrator::bdf2);
  const std::string crank = add_bar(setting, Vec3::Zero(), from, -0.06, 1);
  const std::string coupler = add_bar(setting, from, to, 0, heavy),
                    rocker = add_bar(setting, pivot, to, 0.06, 1);
  turn_steadily(setting, crank);
  setting.join(JointType::hinge, crank, coupler, from);
  setting.join(JointType::hinge, coupler, rocker, to);
  setting.join(JointType::hinge, "", rocker, pivot);
  Run run(setting);
  double error = 0;
  run.go(2, [&] {
    const Vec3 end = meet(crank_end(kTurn * run.state.time), b, pivot, c);
    error = std::max(error, (run.way(rocker) - (end - to) / 2).norm());
  });
  CHECK(error < 1e-5);
  CHECK(run.joint_error < 1e-5);
  CHECK(run.halved == 0);
}

TEST_CASE("an arm on a driven ball joint goes the way of its keys, in whole steps") {
  const double length = GENERATE(0.2, 2.0), h = GENERATE(1.0 / 60, 1.0 / 240, 1.0 / 1000);
  CAPTURE(length, h);
  Setting setting(h);
  const std::string arm =
      setting.add(Box{Vec3(length, 0.1 * length, 0.1 * length) / 2}, 8, {length / 2, 0, 0});
  const TurnProfile turn{{{0, Vec3::Zero()}, {1, Vec3(0, 90, 60)}, {2, Vec3(80, 90, -60)}}};
  setting.builder.add(
      spec::Joint{.type = JointType::spherical, .j = arm, .anchor = Vec3(0, 0, 0), .turn = turn});
  Run run(setting);
  double error = 0;
  run.go(2, [&] {
    const Vec3 c = exp_so3(kDegree * turn.at(run.state.time)) * Vec3(length / 2, 0, 0);
    error = std::max(error, (run.c(arm) - c).norm());
  });
  CHECK(error < 1e-5 * length);
  CHECK(run.halved == 0);
}

}  // namespace pabd::test_drives
