// SPDX-License-Identifier: MIT
// What stands up to a limit: looked for by halving.
#include <cmath>

#include "app/validate/case.h"
#include "sim/body/convex_hull.h"

namespace pabd::validate {
namespace {

// Between `fails` and `holds`, with so many runs.
double limit(Bench& bench, double fails, double holds, int runs, const std::function<bool(double)>& stands) {
  for (int k = 0; k < runs; ++k) {
    const double middle = 0.5 * (fails + holds);
    bench.clear();
    (stands(middle) ? holds : fails) = middle;
  }
  return 0.5 * (fails + holds);
}

// A half ring of stones of mean radius 1 m on the ground; thickness in m.
bool arch_stands(Bench& bench, double thickness) {
  constexpr int kStones = 31;
  constexpr double kReach = 2e-4;
  bench.builder().params.contact.d_hat = kReach;
  bench.friction(0.8);
  bench.ground();
  for (int k = 0; k < kStones; ++k) {
    std::vector<Vec3> corners;
    for (const int end : {0, 1}) {
      const double angle = kPi * (k + end) / kStones;
      const Vec3 out(std::cos(angle), std::sin(angle), 0), along(-out.y(), out.x(), 0);
      for (const double r : {1 - thickness / 2, 1 + thickness / 2})
        for (const double z : {-0.2, 0.2})
          corners.push_back(r * out + (end == 0 ? 0.5 : -0.5) * kReach * along + Vec3(0, kReach / 2, z));
    }
    const Hull stone{make_hull(corners).hull};
    bench.add("stone " + std::to_string(k), stone, 1, stone.data->centroid);
  }
  const std::string key = "stone " + std::to_string(kStones / 2);
  bench.build();
  const Vec3 start = bench.c(key);
  bench.run(5);
  return (bench.c(key) - start).norm() < 0.02;
}
Outcome arch(Bench& bench) {
  return {limit(bench, 0.09, 0.13, 6, [&](double t) { return arch_stands(bench, t); }), {}, {}, {}};
}

// Four blocks of 1 m above each other, each as far out as a share of the harmonic series allows.
constexpr int kBlocks = 4;
bool overhang_stands(Bench& bench, double share) {
  constexpr double kThin = 0.15, kReach = 0.001;
  bench.builder().params.contact.d_hat = kReach;
  bench.friction(0.6);
  bench.add("table", Box{{0.5, 0.25, 0.15}}, 0, {-0.5, -0.25, 0});
  double x = -0.5;
  for (int k = 0; k < kBlocks; ++k) {  // from the bottom up
    x += share / (2 * (kBlocks - k));
    bench.add("block " + std::to_string(k), Box{{0.5, kThin / 2, 0.15}}, 1.5,
              {x, kThin / 2 + kReach + k * (kThin + kReach), 0});
  }
  const std::string top = "block " + std::to_string(kBlocks - 1);
  bench.build();
  const Vec3 start = bench.c(top);
  bench.run(4);
  return (bench.c(top) - start).norm() < 0.02;
}
double harmonic_overhang() {
  double sum = 0;
  for (int k = 1; k <= kBlocks; ++k) sum += 0.5 / k;
  return sum;
}
Outcome overhang(Bench& bench) {
  const double share = limit(bench, 1.1, 0.9, 7, [&](double part) { return overhang_stands(bench, part); });
  return {share * harmonic_overhang(), {}, {}, {}};
}

// A thin board of 1 m at 55° on the ground, against a smooth wall at x = 0.
constexpr double kSteep = 55 * kDegree, kBoard = 0.03;
bool board_stands(Bench& bench, double mu) {
  constexpr double kReach = 3e-4;
  bench.builder().params.contact.d_hat = kReach;
  bench.friction(mu);
  bench.ground();
  bench.builder().add(
      spec::Body{.name = "wall", .shape = Plane{-Vec3::UnitX(), 0}, .friction = SurfaceFriction{0, 0}});
  const double reach = 0.5 * std::cos(kSteep) + kBoard / 2 * std::sin(kSteep) + kReach;
  const double high = 0.5 * std::sin(kSteep) + kBoard / 2 * std::cos(kSteep) + kReach;
  bench.add("board", Box{{0.5, kBoard / 2, 0.1}}, 2, {-reach, high, 0},
            spec::AxisAngle{Vec3::UnitZ(), kSteep / kDegree});
  bench.build();
  const Vec3 start = bench.c("board");
  bench.run(4);
  return (bench.c("board") - start).norm() < 0.02;
}
Outcome ladder(Bench& bench) {
  return {limit(bench, 0.25, 0.45, 7, [&](double mu) { return board_stands(bench, mu); }), {}, {}, {}};
}

}  // namespace

void add_structures(std::vector<Case>& cases) {
  cases.push_back({"arch", 0.1075, arch});
  cases.push_back({"overhang", harmonic_overhang(), overhang});
  cases.push_back(
      {"ladder", (std::cos(kSteep) - kBoard * std::sin(kSteep)) / (2 * std::sin(kSteep)), ladder});
}

}  // namespace pabd::validate
