// SPDX-License-Identifier: MIT
// Time of one step of shipped scenes, split by phase. Counters are ms a step; args: threads, settled (0: the
// first second of the scene, 1: after 5 s).

#include <benchmark/benchmark.h>

#include "sim/scene/scene.h"
#include "sim/solver/time_step.h"

namespace {

using namespace pabd;

void run_scene(benchmark::State& bench, const char* name) {
  Scene scene = load_scene(std::string(PABD_SCENES) + "/" + name + ".json");
  const StepOptions options{false, false, static_cast<int>(bench.range(0))};
  StepWorkspace workspace;
  StepReport report;
  const bool settled = bench.range(1) != 0;
  if (settled) {
    for (int k = 0; k < 300; ++k) step(scene.model, scene.params, options, scene.initial, workspace, report);
  }
  State state = scene.initial;
  PhaseTimes sum;
  double iterations = 0, contacts = 0;
  for (auto _ : bench) {
    if (state.step >= scene.initial.step + 60) {
      bench.PauseTiming();
      state = scene.initial;
      bench.ResumeTiming();
    }
    step(scene.model, scene.params, options, state, workspace, report);
    sum.detect += report.times.detect;
    sum.set_up += report.times.set_up;
    sum.solve += report.times.solve;
    sum.velocities += report.times.velocities;
    iterations += report.iterations;
    contacts += report.contacts;
  }
  const auto mean = [](double total) {
    return benchmark::Counter(total, benchmark::Counter::kAvgIterations);
  };
  bench.counters["detect_ms"] = mean(sum.detect);
  bench.counters["set_up_ms"] = mean(sum.set_up);
  bench.counters["solve_ms"] = mean(sum.solve);
  bench.counters["velocities_ms"] = mean(sum.velocities);
  bench.counters["iterations"] = mean(iterations);
  bench.counters["contacts"] = mean(contacts);
}

}  // namespace

#define PABD_SCENE(name)                    \
  BENCHMARK_CAPTURE(run_scene, name, #name) \
      ->ArgNames({"threads", "settled"})    \
      ->ArgsProduct({{1, 2}, {0, 1}})       \
      ->Unit(benchmark::kMillisecond)       \
      ->UseRealTime()
PABD_SCENE(pyramid);
PABD_SCENE(pile);
PABD_SCENE(stack);

BENCHMARK_MAIN();
