// SPDX-License-Identifier: MIT
// What slides and rolls.
#include <cmath>

#include "app/validate/case.h"
#include "sim/body/shape_kind.h"

namespace pabd::validate {
namespace {

constexpr double kMu = 0.3, kRadius = 0.1, kSlope = 20 * kDegree;

struct Round {
  const char* key;
  Shape shape;
  double k;     // I/(m r²) about the axis that it rolls about, z
  bool turned;  // its axis lies along z where the shape has it along y
};

std::vector<Round> round_bodies() {
  return {{"ball", Sphere{kRadius}, 0.4, false},
          {"can", make_shape("cylinder", {kRadius, 0.3}), 0.5, true},
          {"coin", make_shape("cylinder", {kRadius, 0.02}), 0.5, true}};
}

void add_round(Bench& bench, const Round& round, double degrees) {
  bench.friction(kMu);
  bench.ground(degrees);
  const double angle = degrees * kDegree, height = kRadius + bench.builder().params.contact.d_hat;
  spec::Orientation turn{1, 0, 0, 0};
  if (round.turned) turn = spec::AxisAngle{Vec3::UnitX(), 90};
  bench.add("body", round.shape, 1, height * Vec3(std::sin(angle), std::cos(angle), 0), turn);
  bench.build();
}

// Let go with 3 m/s and no spin on a plane: rolls with 1/(1 + k) of it after 3/(μ g (1 + 1/k)) s.
Outcome slide_to_roll(Bench& bench, const Round& round) {
  add_round(bench, round, 0);
  bench.v("body") = Vec3(3, 0, 0);
  Outcome out;
  const double rolls = 3 / (1 + round.k);
  bench.run(
      1.5, [&] { out.see(bench.time(), bench.v("body").x(), std::max(rolls, 3 - kMu * kG * bench.time())); });
  out.value = out.ours.back();
  return out;
}

// From rest down 20°: its acceleration, by its way in 1.5 s.
Outcome roll_down(Bench& bench, const Round& round) {
  add_round(bench, round, kSlope / kDegree);
  Outcome out;
  const Vec3 down(std::cos(kSlope), -std::sin(kSlope), 0);
  const double a = kG * std::sin(kSlope) / (1 + round.k);
  bench.run(1.5, [&] { out.see(bench.time(), bench.v("body").dot(down), a * bench.time()); });
  out.value = out.ours.back() / bench.time();
  return out;
}

// A box down 30°: its acceleration.
Outcome slide_down(Bench& bench) {
  bench.friction(kMu);
  bench.ground(30);
  const double angle = 30 * kDegree, height = 0.1 + bench.builder().params.contact.d_hat;
  const Vec3 normal(std::sin(angle), std::cos(angle), 0), down(std::cos(angle), -std::sin(angle), 0);
  bench.add("box", Box{{0.2, 0.1, 0.2}}, 5, height * normal, spec::AxisAngle{Vec3::UnitZ(), -30});
  Outcome out;
  bench.run(1, [&] {
    out.see(bench.time(), bench.v("box").dot(down),
            kG * (std::sin(angle) - kMu * std::cos(angle)) * bench.time());
  });
  out.value = out.ours.back() / bench.time();
  return out;
}

// A box of 3 m/s on a plane: how far it comes.
Outcome stop(Bench& bench) {
  bench.friction(kMu);
  bench.ground();
  bench.add("box", Box{{0.2, 0.1, 0.2}}, 5, {0, 0.1 + bench.builder().params.contact.d_hat, 0});
  bench.build();
  bench.v("box") = Vec3(3, 0, 0);
  Outcome out;
  const double end = 3 / (kMu * kG);
  bench.run(1.5, [&] {
    const double t = std::min(bench.time(), end);
    out.see(bench.time(), bench.c("box").x(), 3 * t - 0.5 * kMu * kG * t * t);
  });
  out.value = out.ours.back();
  return out;
}

// A box of 10 kg on the ground with 25 balls of 1 kg on it, pushed by 150 N along its diagonal: 0.4 between box and ground, 0.8
// between balls and box. The balls roll with 2/7 of its acceleration: (F − 0.4 · 35 g)/(10 + 25 · 2/7) = 0.7385 m/s².
constexpr double kPush = 150, kBox = 10, kBalls = 25, kUnder = 0.4, kOn = 0.8;
constexpr double kBoxSpeeds = (kPush - kUnder * (kBox + kBalls) * kG) / (kBox + kBalls * 2 / 7);
Outcome pushed_under_balls(Bench& bench, bool ball) {
  const double d_hat = bench.builder().params.contact.d_hat;
  const Vec3 along = Vec3(1, 0, 1).normalized();
  const auto friction = [](double mu) { return SurfaceFriction{mu, mu}; };
  bench.builder().params.contact.friction_rule = FrictionRule::min;
  bench.builder().add(
      spec::Body{.name = "ground", .shape = Plane{Vec3::UnitY(), 0}, .friction = friction(kUnder)});
  bench.builder().add(spec::Body{.name = "box",
                                 .shape = Box{{2, 0.1, 2}},
                                 .mass = kBox,
                                 .position = Vec3(0, 0.1 + d_hat, 0),
                                 .friction = friction(kOn),
                                 .force = Keyed<Vec3>{{{0, kPush * along}}}});
  for (int k = 0; k < 25; ++k)
    bench.builder().add(spec::Body{.name = "ball " + std::to_string(k),
                                   .shape = Sphere{0.1},
                                   .mass = 1,
                                   .position = Vec3(0.5 * (k % 5 - 2), 0.3 + 2 * d_hat, 0.5 * (k / 5 - 2)),
                                   .friction = friction(kOn)});
  Outcome out;
  const double due = ball ? kBoxSpeeds * 2 / 7 : kBoxSpeeds;
  bench.run(2,
            [&] { out.see(bench.time(), bench.v(ball ? "ball 7" : "box").dot(along), due * bench.time()); });
  out.value = out.ours.back() / bench.time();
  return out;
}

// A ball that rolls against a friction of l f_n.
constexpr double kResists = 0.002;
Outcome roll_until_it_stops(Bench& bench) {
  bench.builder().params.contact.rolling = kResists;
  add_round(bench, round_bodies().front(), 0);
  bench.v("body") = Vec3(0.5, 0, 0);
  bench.omega("body") = Vec3(0, 0, -0.5 / kRadius);
  const double slowed = kResists * kG / (1.4 * kRadius), end = 0.5 / slowed;
  Outcome out;
  bench.run(4, [&] {
    const double t = std::min(bench.time(), end);
    out.see(bench.time(), bench.c("body").x(), 0.5 * t - 0.5 * slowed * t * t);
  });
  out.value = out.ours.back();
  return out;
}

}  // namespace

void add_rolling(std::vector<Case>& cases) {
  for (const Round& round : round_bodies()) {
    cases.push_back({std::string("roll-") + round.key, 3 / (1 + round.k),
                     [round](Bench& bench) { return slide_to_roll(bench, round); }});
    cases.push_back({std::string("downhill-") + round.key, kG * std::sin(kSlope) / (1 + round.k),
                     [round](Bench& bench) { return roll_down(bench, round); }});
  }
  cases.push_back(
      {"slide-downhill", kG * (std::sin(30 * kDegree) - kMu * std::cos(30 * kDegree)), slide_down});
  cases.push_back({"slide-stop", 9 / (2 * kMu * kG), stop});
  for (const bool ball : {false, true})
    cases.push_back({ball ? "pushed-ball" : "pushed-box", ball ? kBoxSpeeds * 2 / 7 : kBoxSpeeds,
                     [ball](Bench& bench) { return pushed_under_balls(bench, ball); }});
  cases.push_back({"roll-stop", 0.25 * 1.4 * kRadius / (2 * kResists * kG), roll_until_it_stops});
}

}  // namespace pabd::validate
