// SPDX-License-Identifier: MIT
// What spins: tops and free bodies.
#include <cmath>

#include "app/validate/case.h"
#include "app/validate/crossings.h"
#include "sim/body/mass_properties.h"

namespace pabd::validate {
namespace {

// A top on a ball joint at the origin, at 40° to the vertical. It precesses steadily at the rates that solve
// I₁ cos θ Ω² − I₃ ω₃ Ω + m g l = 0.
constexpr double kTopLean = 40 * kDegree, kArm = 0.1, kSpin = 40;        // rad, m, rad/s
constexpr double kAxial = 0.08 / 12, kAcross = 0.05 / 12 + kArm * kArm;  // of 1 kg, 0.2 × 0.1 × 0.2 m; kg m²

double precession(double sign) {
  const double a = kAcross * std::cos(kTopLean), b = kAxial * kSpin;
  return (b + sign * std::sqrt(b * b - 4 * a * kG * kArm)) / (2 * a);
}

Outcome heavy_top(Bench& bench, double sign) {
  const Vec3 up(std::sin(kTopLean), std::cos(kTopLean), 0);
  const double rate = precession(sign);
  bench.add("top", Box{{0.1, 0.05, 0.1}}, 1, kArm * up, spec::AxisAngle{Vec3::UnitZ(), -kTopLean / kDegree});
  bench.join(JointType::spherical, "", "top", Vec3::Zero());
  bench.build();
  bench.omega("top") = rate * Vec3::UnitY() + (kSpin - rate * std::cos(kTopLean)) * up;
  bench.v("top") = bench.omega("top").cross(kArm * up);
  Outcome out;
  double turned = 0, before = 0;
  bench.run(2, [&] {
    const Vec3& c = bench.c("top");
    const double angle = std::atan2(-c.z(), c.x());
    turned += std::remainder(angle - before, 2 * kPi);
    before = angle;
    out.see(bench.time(), turned, rate * bench.time());
  });
  out.value = turned / bench.time();
  return out;
}

// I = diag(1, 2, 2.7) kg m², ω = (0.02, 4, 0.013) rad/s: turns over again and again.
Outcome fourth_flip(Bench& bench) {
  bench.builder().params.gravity.setZero();
  bench.add("body", Box{Vec3(std::sqrt(1.85), std::sqrt(0.85), std::sqrt(0.15)) / 2}, 12, Vec3::Zero());
  bench.build();
  bench.omega("body") = Vec3(0.02, 4, 0.013);
  Outcome out;
  Crossings up, down;
  bench.run(30, [&] {
    const double omega = (bench.R("body").transpose() * bench.omega("body")).y();
    up.see(bench.time(), omega);
    down.see(bench.time(), -omega);
    out.see(bench.time(), omega);
  });
  out.value = up.at().size() > 1 ? up.at()[1] : 0;
  return out;
}

// Largest share by which energy and angular momentum change in 100 steps.
Outcome fast_cube(Bench& bench) {
  bench.builder().params.gravity.setZero();
  bench.add("cube", Box{Vec3(0.5, 0.45, 0.4)}, 1, Vec3::Zero());
  bench.build();
  bench.omega("cube") = 6e4 * Vec3(1, 2, 2) / 3;
  const Mat3 I = inertia_tensor(bench.scene().model.J[0]);
  const auto spin = [&]() -> Vec3 {
    const Mat3& R = bench.R("cube");
    return R * I * R.transpose() * bench.omega("cube");
  };
  const Vec3 before = spin();
  const double energy = bench.energy();
  Outcome out;
  bench.run(100 * bench.h(), [&] {
    out.value = std::max(
        {out.value, (spin() - before).norm() / before.norm(), std::abs(bench.energy() - energy) / energy});
  });
  return out;
}

}  // namespace

void add_spins(std::vector<Case>& cases) {
  for (const double sign : {-1.0, 1.0})
    cases.push_back({sign > 0 ? "heavy-top-fast" : "heavy-top-slow", precession(sign),
                     [sign](Bench& bench) { return heavy_top(bench, sign); }});
  cases.push_back({"flips", 26.1005, fourth_flip});
  cases.push_back({"spinning-cube", 0, fast_cube});
}

}  // namespace pabd::validate
