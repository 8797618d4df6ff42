// SPDX-License-Identifier: MIT
// Time of one warm `detect` on one thread: a heap of turned cubes, a flat brick wall, and a long row that
// never meets.
#include <benchmark/benchmark.h>

#include <random>

#include "sim/collision/detect.h"
#include "tests/support/draws.h"

using namespace pabd;

namespace {

constexpr double kReach = 0.02;  // m, of each body

struct Bodies {
  Model model;
  std::vector<Vec3> c;
  std::vector<Mat3> R;
  std::vector<double> reach;

  void add(const Shape& shape, const Vec3& centre, const Mat3& rotation) {
    const bool plane = std::holds_alternative<Plane>(shape);
    model.name.emplace_back();
    model.shape.push_back(shape);
    model.mass.push_back(plane ? 0 : 1);
    model.J.push_back(Mat3::Identity());
    model.fixed.push_back(plane);
    c.push_back(centre);
    R.push_back(rotation);
    reach.push_back(kReach);
  }
};

void time_detect(benchmark::State& state, const Bodies& bodies) {
  CollisionWorkspace workspace;
  std::vector<ContactPoint> contacts;
  detect(bodies.model, bodies.c, bodies.R, bodies.reach, {}, 1, workspace, contacts);
  for (auto _ : state) {
    detect(bodies.model, bodies.c, bodies.R, bodies.reach, {}, 1, workspace, contacts);
    benchmark::DoNotOptimize(contacts.data());
  }
  state.counters["pairs"] = static_cast<double>(workspace.pairs.size());
  state.counters["contacts"] = static_cast<double>(contacts.size());
}

void heap(benchmark::State& state) {
  const auto side = state.range(0);
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> shake(-0.2, 0.2);
  std::normal_distribution<double> normal;
  Bodies bodies;
  bodies.add(Plane{Vec3::UnitY(), 0}, Vec3::Zero(), Mat3::Identity());
  for (std::int64_t i = 0; i < side * side * side; ++i) {
    const auto x = static_cast<double>(i % side), y = static_cast<double>(i / side % side),
               z = static_cast<double>(i / (side * side));
    const Vec3 shift = testing::draw_vector([&] { return shake(generator); });
    const double w = normal(generator);
    const Vec3 u = testing::draw_vector([&] { return normal(generator); });
    const Quat turn(w, u.x(), u.y(), u.z());
    bodies.add(Box{Vec3::Constant(0.5)}, 1.15 * Vec3(x, y + 0.5, z) + shift,
               turn.normalized().toRotationMatrix());
  }
  time_detect(state, bodies);
}

void wall(benchmark::State& state) {
  Bodies bodies;
  bodies.add(Plane{Vec3::UnitY(), 0}, Vec3::Zero(), Mat3::Identity());
  for (int row = 0; row < 20; ++row)
    for (int i = 0; i < 20; ++i) {
      bodies.add(Box{{1, 0.5, 0.5}}, Vec3(2.01 * i + row % 2, 1.0099 * row + 0.509, 0), Mat3::Identity());
    }
  time_detect(state, bodies);
}

void row(benchmark::State& state) {
  Bodies bodies;
  for (std::int64_t i = 0; i < state.range(0); ++i) {
    bodies.add(Box{{0.5, 0.1, 0.1}}, Vec3(1.2 * static_cast<double>(i), 0, 0), Mat3::Identity());
  }
  time_detect(state, bodies);
}

}  // namespace

BENCHMARK(heap)->ArgName("side")->Arg(10)->Arg(20)->Unit(benchmark::kMillisecond);
BENCHMARK(wall)->Unit(benchmark::kMillisecond);
BENCHMARK(row)->Arg(1000000)->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
