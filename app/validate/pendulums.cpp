// SPDX-License-Identifier: MIT
// What swings and what turns about an axis.
#include <cmath>

#include "app/validate/case.h"
#include "app/validate/crossings.h"
#include "sim/body/shape_kind.h"

namespace pabd::validate {
namespace {

constexpr double kPoint = 0.001;  // radius of a ball that stands for a point; m

// A ball of 1 kg on a pin at the origin, 1 m to the right.
void hang(Bench& bench) {
  bench.add("bob", Sphere{kPoint}, 1, Vec3(1, 0, 0));
  bench.join(JointType::hinge, "", "bob", Vec3::Zero());
}

Outcome period_of_pendulum(Bench& bench) {
  hang(bench);
  Outcome out;
  Crossings crossings;
  bench.run(10, [&] { crossings.see(bench.time(), bench.c("bob").x()); });
  out.value = crossings.period();
  return out;
}

Outcome energy_of_pendulum(Bench& bench) {
  hang(bench);
  bench.build();
  Outcome out;
  const double start = bench.energy();
  bench.run(10, [&] { out.see(bench.time(), bench.energy() - start, 0); });
  out.value = out.ours.back();
  return out;
}

// Two points of 1 kg below each other, 1 m apart, let go in one of their modes: the lower one at ±√2 of the angle.
Outcome mode_of_double_pendulum(Bench& bench, double sign) {
  const double first = 0.001, second = sign * std::sqrt(2.0) * first;  // rad
  const Vec3 upper(std::sin(first), -std::cos(first), 0),
      lower = upper + Vec3(std::sin(second), -std::cos(second), 0);
  bench.add("upper", Sphere{kPoint}, 1, upper);
  bench.add("lower", Sphere{kPoint}, 1, lower);
  bench.join(JointType::hinge, "", "upper", Vec3::Zero());
  bench.join(JointType::hinge, "upper", "lower", upper);
  Outcome out;
  Crossings crossings;
  const double omega = std::sqrt((2 - sign * std::sqrt(2.0)) * kG);
  bench.run(10, [&] {
    crossings.see(bench.time(), bench.c("upper").x());
    out.see(bench.time(), std::asin(bench.c("upper").x()) / kDegree,
            first / kDegree * std::cos(omega * bench.time()));
  });
  out.value = crossings.period();
  return out;
}

constexpr double kLean = 50;  // degrees

Outcome conical_pendulum(Bench& bench) {
  const double lean = kLean * kDegree, omega = std::sqrt(kG / std::cos(lean));
  const Vec3 bob(std::sin(lean), -std::cos(lean), 0);
  bench.add("bob", Sphere{kPoint}, 1, bob);
  bench.join(JointType::spherical, "", "bob", Vec3::Zero());
  bench.build();
  bench.omega("bob") = omega * Vec3::UnitY();
  bench.v("bob") = bench.omega("bob").cross(bob);
  Outcome out;
  bench.run(5, [&] {
    out.see(bench.time(), std::acos(-bench.c("bob").y() / bench.c("bob").norm()) / kDegree, kLean);
  });
  out.value = out.ours.back();
  return out;
}

// A chain of 40 rods, 1 m long, in its first mode: the Bessel function J₀(2.4048 √(s/L)), s from the free end.
Outcome mode_of_chain(Bench& bench) {
  constexpr int kLinks = 40;
  constexpr double kLink = 1.0 / kLinks, kZero = 2.404825557695773, kSwing = 0.01;
  std::vector<Vec3> joints{Vec3::Zero()};
  const auto aside = [&](int k) { return kSwing * std::cyl_bessel_j(0, kZero * std::sqrt(1 - k * kLink)); };
  for (int k = 1; k <= kLinks; ++k) {
    const double x = aside(k) - aside(0);
    joints.emplace_back(x, joints.back().y() - std::sqrt(kLink * kLink - std::pow(x - joints.back().x(), 2)),
                        0);
  }
  for (int k = 0; k < kLinks; ++k) {
    const std::string name = "rod " + std::to_string(k);
    const Vec3 way = joints[k + 1] - joints[k];
    bench.add(name, Box{Vec3(0.5 * way.norm(), 1e-3, 1e-3)}, 0.1, (joints[k] + joints[k + 1]) / 2,
              spec::AxisAngle{Vec3::UnitZ(), std::atan2(way.y(), way.x()) / kDegree});
    bench.join(JointType::hinge, k == 0 ? "" : "rod " + std::to_string(k - 1), name, joints[k]);
  }
  Outcome out;
  Crossings crossings;
  const std::string last = "rod " + std::to_string(kLinks - 1);
  bench.build();
  const double start = bench.c(last).x();
  bench.run(8, [&] {
    crossings.see(bench.time(), bench.c(last).x());
    out.see(bench.time(), 1e3 * bench.c(last).x(),
            1e3 * start * std::cos(0.5 * kZero * std::sqrt(kG) * bench.time()));
  });
  out.value = crossings.period();
  return out;
}

// A bead without friction on a rod that turns about a vertical axis with 2 rad/s, 0.1 m from it.
Outcome bead_on_rod(Bench& bench) {
  constexpr double kTurn = 2, kFrom = 0.1;  // rad/s, m
  bench.add("rod", Box{{1, 0.01, 0.01}}, 1, Vec3::Zero());
  bench.add("bead", Sphere{kPoint}, 1, Vec3(kFrom, 0, 0));
  bench.builder().add(spec::Joint{.type = JointType::hinge,
                                  .j = "rod",
                                  .anchor = Vec3::Zero(),
                                  .axis = Vec3::UnitY(),
                                  .drive = Profile{{{0, 0}, {10, 10 * kTurn / kDegree}}}});
  bench.join(JointType::slider, "rod", "bead", Vec3(kFrom, 0, 0), Vec3::UnitX());
  bench.build();
  bench.omega("rod") = bench.omega("bead") = kTurn * Vec3::UnitY();
  bench.v("bead") = bench.omega("bead").cross(bench.c("bead"));
  Outcome out;
  bench.run(1.5, [&] {
    const Vec3& c = bench.c("bead");
    out.see(bench.time(), std::hypot(c.x(), c.z()), kFrom * std::cosh(kTurn * bench.time()));
  });
  out.value = out.ours.back();
  return out;
}

// A disc on a vertical axle 0.1 m beside its centre.
Outcome eccentric_rotor(Bench& bench) {
  constexpr double kSpeed = 20;  // rad/s
  const Vec3 c(0.1, 0, 0);
  bench.add("disc", make_shape("cylinder", {0.2, 0.04}), 1, c);
  bench.join(JointType::hinge, "", "disc", Vec3::Zero(), Vec3::UnitY());
  bench.build();
  bench.omega("disc") = kSpeed * Vec3::UnitY();
  bench.v("disc") = bench.omega("disc").cross(c);
  Outcome out;
  bench.run(1, [&] { out.see(bench.time(), bench.omega("disc").y(), kSpeed); });
  out.value = out.ours.back();
  return out;
}

// A wheel on a spring of 2 N m/rad, with a damper of 0.1 N m s/rad, let go 1 rad away.
Outcome torsion_pendulum(Bench& bench) {
  constexpr double kStiffness = 2, kDamping = 0.1,
                   kInertia = 2 * (0.04 + 0.04) / 12;  // of a box of 0.2 m and 2 kg
  bench.add("wheel", Box{{0.1, 0.1, 0.1}}, 2, Vec3::Zero());
  bench.builder().add(spec::Joint{.type = JointType::hinge,
                                  .j = "wheel",
                                  .anchor = Vec3::Zero(),
                                  .axis = Vec3::UnitZ(),
                                  .damping = kDamping,
                                  .spring = spec::Spring{.stiffness = kStiffness, .rest = 1 / kDegree}});
  const double decay = kDamping / (2 * kInertia), omega = std::sqrt(kStiffness / kInertia - decay * decay);
  Outcome out;
  bench.run(1, [&] {
    const Mat3& R = bench.R("wheel");
    const double t = bench.time();
    out.see(t, std::atan2(R(1, 0), R(0, 0)),
            1 - std::exp(-decay * t) * (std::cos(omega * t) + decay / omega * std::sin(omega * t)));
  });
  out.value = out.ours.back();
  return out;
}

}  // namespace

void add_pendulums(std::vector<Case>& cases) {
  // K(sin 45°), the complete elliptic integral of the first kind.
  constexpr double kQuarter = 1.8540746773013719;
  const double modes = std::sqrt(2.0);
  cases.push_back({"pendulum-period", 4 * kQuarter / std::sqrt(kG), period_of_pendulum});
  cases.push_back({"pendulum-energy", 0, energy_of_pendulum});
  cases.push_back({"double-pendulum-slow", 2 * kPi / std::sqrt((2 - modes) * kG),
                   [](Bench& bench) { return mode_of_double_pendulum(bench, 1); }});
  cases.push_back({"double-pendulum-fast", 2 * kPi / std::sqrt((2 + modes) * kG),
                   [](Bench& bench) { return mode_of_double_pendulum(bench, -1); }});
  cases.push_back({"conical-pendulum", kLean, conical_pendulum});
  cases.push_back({"hanging-chain", 4 * kPi / (2.404825557695773 * std::sqrt(kG)), mode_of_chain});
  cases.push_back({"bead-on-rod", 0.1 * std::cosh(3.0), bead_on_rod});
  cases.push_back({"eccentric-rotor", 20, eccentric_rotor});
  const double decay = 0.1 / (2 * 2 * 0.08 / 12), omega = std::sqrt(2 / (2 * 0.08 / 12) - decay * decay);
  cases.push_back({"torsion-pendulum",
                   1 - std::exp(-decay) * (std::cos(omega) + decay / omega * std::sin(omega)),
                   torsion_pendulum});
}

}  // namespace pabd::validate
