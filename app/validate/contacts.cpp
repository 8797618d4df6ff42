// SPDX-License-Identifier: MIT
// What presses, hits and sticks.
#include <cmath>

#include "app/validate/case.h"
#include "app/validate/crossings.h"

namespace pabd::validate {
namespace {

// A ball of 2 kg at rest on the ground, d̂ = 1 cm, κ = 0.1 J: the gap where S(5) carries it; mm.
Outcome gap_under_load(Bench& bench, int N) {
  bench.builder().params.contact.N = N;
  bench.builder().params.contact.d_hat = 0.01;
  bench.builder().params.contact.kappa = 0.1;
  bench.ground();
  bench.add("ball", Sphere{0.2}, 2, {0, 0.206, 0});
  bench.run(12);
  return {1e3 * (bench.c("ball").y() - 0.2), {}, {}, {}};
}

// 1 + u + … + u^(N−1) = m g d̂/κ, u = 1 − d/d̂; mm.
double right_gap(int N) {
  double low = 0, high = 1;
  for (int k = 0; k < 60; ++k) {
    const double u = 0.5 * (low + high);
    double sum = 0;
    for (int n = 0; n < N; ++n) sum += std::pow(u, n);
    (sum < 2 * kG * 0.01 / 0.1 ? low : high) = u;
  }
  return 10 * (1 - low);
}

// A ball of 1 kg that falls 50 m and bounces for 30 s without loss: its energy.
Outcome bouncing_ball(Bench& bench) {
  bench.builder().params.contact.restitution = 1;
  bench.ground();
  const double rest = 0.1 + bench.builder().params.contact.d_hat;
  bench.add("ball", Sphere{0.1}, 1, {0, rest + 50, 0});
  Outcome out;
  bench.run(30, [&] { out.see(bench.time(), bench.energy() - kG * rest, 490.5); });
  out.value = out.ours.back();
  return out;
}

// A ball that falls 1 m with e = 0.7: how high it comes.
Outcome rebound(Bench& bench) {
  bench.builder().params.contact.restitution = 0.7;
  bench.ground();
  const double rest = 0.1 + bench.builder().params.contact.d_hat;
  bench.add("ball", Sphere{0.1}, 1, {0, rest + 1, 0});
  Outcome out;
  bool up = false;
  bench.run(1, [&] {
    up = up || bench.v("ball").y() > 0;
    const double height = bench.c("ball").y() - rest;
    if (up) out.value = std::max(out.value, height);
    out.see(bench.time(), height);
  });
  return out;
}

// Five balls in a row that do not touch, e = 1, the first hits with 2 m/s: the speed of the last.
Outcome row_of_balls(Bench& bench) {
  bench.builder().params.contact.restitution = 1;
  bench.builder().params.gravity.setZero();
  bench.friction(0);
  const double apart = 0.2 + 1.001 * bench.builder().params.contact.d_hat;
  for (int k = 0; k < 5; ++k)
    bench.add("ball " + std::to_string(k), Sphere{0.1}, 1, {k * apart - (k == 0 ? 0.3 : 0), 0, 0});
  bench.build();
  bench.v("ball 0") = Vec3(2, 0, 0);
  bench.run(1);
  return {bench.v("ball 4").x(), {}, {}, {}};
}

// 216 balls without friction that fall into a box: the most by which their energy rises above that at the start, as a part
// of it, or the largest overlap as a part of their radius.
Outcome many_balls(Bench& bench, bool energy) {
  bench.friction(0);
  bench.ground();
  for (const double side : {-1.0, 1.0}) {
    bench.add(side < 0 ? "left" : "right", Box{{0.1, 2, 1}}, 0, {0.9 * side, 2, 0});
    bench.add(side < 0 ? "back" : "front", Box{{1, 2, 0.1}}, 0, {0, 2, 0.9 * side});
  }
  for (int k = 0; k < 216; ++k)
    bench.add("ball " + std::to_string(k), Sphere{0.1}, 1,
              {0.24 * (k % 6 - 2.5) + 0.01 * std::sin(k), 0.4 + 0.24 * (k / 36), 0.24 * (k / 6 % 6 - 2.5)});
  bench.build();
  Outcome out;
  const double start = bench.energy();
  bench.run(3, [&] {
    const double now =
        energy ? (bench.energy() + bench.report().elastic) / start - 1 : bench.report().max_penetration / 0.1;
    out.see(bench.time(), now);
    out.value = std::max(out.value, now);
  });
  return out;
}

// A block of 1 kg on a belt of 0.1 m/s, held by a spring of 100 N/m, μ = 0.5 at rest and 0.3 when it slides.
constexpr double kStick = 0.5, kSlip = 0.3, kBelt = 0.1, kSpring = 100;
double stick_slip_period() {
  const double omega = std::sqrt(kSpring), jump = (kStick - kSlip) * kG / kSpring;
  return 2 * jump / kBelt + 2 / omega * (kPi - std::atan(jump * omega / kBelt));
}
Outcome stick_slip(Bench& bench) {
  bench.builder().params.contact.mu_static = kStick;
  bench.builder().params.contact.mu_dynamic = kSlip;
  const double y = 0.1 + bench.builder().params.contact.d_hat;
  bench.add("belt", Box{{4, 0.1, 0.5}}, 100, {0, -0.1, 0});
  bench.add("block", Box{{0.1, 0.1, 0.1}}, 1, {0, y, 0});
  bench.builder().add(spec::Joint{.type = JointType::slider,
                                  .j = "belt",
                                  .anchor = Vec3(0, -0.1, 0),
                                  .axis = Vec3::UnitX(),
                                  .drive = Profile{{{0, 0}, {20, 20 * kBelt}}}});
  bench.builder().add(spec::Joint{.type = JointType::distance,
                                  .j = "block",
                                  .points = {Vec3(-3, y, 0), Vec3(0, y, 0)},
                                  .length = 3,
                                  .law = {.potential = BondPotential::soft, .kappa = kSpring}});
  Outcome out;
  Crossings crossings;
  bench.run(6, [&] {
    const double stretch = bench.c("block").x();
    if (bench.time() > 1) crossings.see(bench.time(), stretch - kSlip * kG / kSpring);
    out.see(bench.time(), 1e3 * stretch);
  });
  out.value = crossings.period();
  return out;
}

// A block of 0.2 × 1 m that rocks from 5°: what an impact of its base leaves of its energy, from one swing to the next.
constexpr double kSlender = 0.2;
Outcome rocking(Bench& bench) {
  constexpr double kReach = 2e-4, kTilt = 5 * kDegree;
  bench.builder().params.contact.d_hat = kReach;
  bench.friction(1);
  bench.ground();
  const double wide = kSlender * std::cos(kTilt), high = std::cos(kTilt) + kSlender * std::sin(kTilt);
  bench.add("block", Box{{kSlender / 2, 0.5, kSlender / 2}}, 40,
            {0.5 * (std::sin(kTilt) - wide), 0.5 * high + kReach, 0}, spec::AxisAngle{Vec3::UnitZ(), -5});
  Outcome out;
  double last = 0, fastest[2] = {0, 0};
  int swing = 0;
  bench.run(1.5, [&] {
    const double omega = bench.omega("block").z();
    if (omega * last < 0) ++swing;
    last = omega;
    if (swing < 2) fastest[swing] = std::max(fastest[swing], std::abs(omega));
    out.see(bench.time(), omega);
  });
  out.value = std::pow(fastest[1] / fastest[0], 2);
  return out;
}

}  // namespace

void add_contacts(std::vector<Case>& cases) {
  for (const int N : {2, 3, 8})
    cases.push_back(
        {"gap-" + std::to_string(N), right_gap(N), [N](Bench& bench) { return gap_under_load(bench, N); }});
  cases.push_back({"bounce-energy", 490.5, bouncing_ball});
  cases.push_back({"rebound", 0.49, rebound});
  cases.push_back({"row-of-balls", 2, row_of_balls});
  cases.push_back({"many-balls-energy", 0, [](Bench& bench) { return many_balls(bench, true); }});
  cases.push_back({"many-balls-overlap", 0, [](Bench& bench) { return many_balls(bench, false); }});
  cases.push_back({"stick-slip", stick_slip_period(), stick_slip});
  cases.push_back(
      {"rocking", std::pow(1 - 1.5 * kSlender * kSlender / (1 + kSlender * kSlender), 2), rocking});
}

}  // namespace pabd::validate
