// SPDX-License-Identifier: MIT
#include "tests/bench/peers/measure.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <fstream>

#include "sim/base/error.h"
#include "sim/solver/step_summary.h"

namespace pabd::peers {

namespace {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double process_cpu_ms() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

double peak_memory_mib() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) / 1024;
  }
  throw Error(ErrorKind::file, "/proc/self/status: expected a line VmHWM; run on Linux");
}

}  // namespace

namespace {

struct Times {
  std::vector<double> wall, cpu;  // of each step; ms
};

Times time_steps(Engine& engine, int steps) {
  using Clock = std::chrono::steady_clock;
  Times times;
  const double begin = process_cpu_ms();
  for (int k = 0; k < steps; ++k) {
    const double cpu_start = process_cpu_ms();
    if (k > 0 && cpu_start - begin > 1e3 * kBudget) break;
    const auto start = Clock::now();
    engine.step();
    times.wall.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    times.cpu.push_back(process_cpu_ms() - cpu_start);
  }
  return times;
}

}  // namespace

Measurement measure(const PeerScene& peer, int threads) {
  const Scene& scene = peer.scene;
  Measurement result;
  State timed_end;
  {
    const auto engine = make_engine(scene, {threads, false});
    const Times times = time_steps(*engine, peer.steps);
    result.steps = static_cast<int>(times.wall.size());
    result.median_ms = median(times.wall);
    result.median_cpu_ms = median(times.cpu);
    result.median_last_ms = median({times.wall.end() - std::min(result.steps, kLastSteps), times.wall.end()});
    result.peak_mib = peak_memory_mib();
    timed_end = scene.initial;
    engine->read(timed_end);
  }

  const auto engine = make_engine(scene, {threads, true});
  State state = scene.initial;
  OverlapRuler overlap(scene.model);
  std::vector<double> depths;
  for (int k = 0; k < result.steps; ++k) {
    engine->step();
    engine->penetrations(depths);
    const bool last = k >= result.steps - kLastSteps;
    for (const double depth : depths) {
      result.run.add(depth);
      if (last) result.last.add(depth);
    }
    if (!last && scene.model.joints.empty()) continue;
    engine->read(state);
    if (last) overlap.measure(state, result.ruler_last);
    const double drift = joint_drift(scene.model, state);
    if (!(drift <= result.drift)) result.drift = drift;
    if (!std::isfinite(drift)) break;
  }
  result.repeatable = state.c == timed_end.c && state.R == timed_end.R;
  result.kinetic = kinetic_energy(scene.model, state);
  const double lost = potential_energy(scene.model, scene.params, scene.initial) -
                      potential_energy(scene.model, scene.params, state);
  result.energy_change =
      (result.kinetic - kinetic_energy(scene.model, scene.initial) - lost) / std::abs(lost);
  if (peer.has_top) {
    const std::size_t top = static_cast<std::size_t>(highest_body(scene.initial));
    Vec3 way = state.c[top] - scene.initial.c[top];
    result.top_drop = -way.y();
    way.y() = 0;
    result.top_shift = way.norm();
  }
  return result;
}

}  // namespace pabd::peers
