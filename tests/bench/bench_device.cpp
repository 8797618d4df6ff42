// SPDX-License-Identifier: MIT
// The solver on the GPU against the processor's, over the number of bodies: ms of a step and of its phases, bytes a body.
//
//   bench_device [towers|heap|avalanche] [--team K] [--gpu] [bodies...]      1000 10000 100000 1000000
//
// towers: columns of ten boxes, each a little beside the one below, at rest. heap: boxes that fell in any
// orientation, while they hit each other. avalanche: mixed shapes on a slope. Both solvers make ten sweeps, no fewer.
// --team: threads that share a body in a sweep. --gpu: only the GPU.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <string>
#include <vector>

#include "render/device/compute_functions.h"
#include "render/device/device_solver.h"
#include "sim/base/available_cpus.h"
#include "sim/base/error.h"
#include "sim/solver/time_step.h"
#include "tests/bench/device_settings.h"

using namespace pabd;
using namespace pabd::bench;

namespace {

// Milliseconds of a step of the processor.
double time_processor(const Setting& setting, int threads, int steps) {
  State state = setting.state;
  StepWorkspace workspace;
  StepReport report;
  StepOptions options;
  options.threads = threads;
  step(setting.model, setting.params, options, state, workspace, report);
  const auto start = Clock::now();
  for (int k = 0; k < steps; ++k) step(setting.model, setting.params, options, state, workspace, report);
  return ms_since(start) / steps;
}

void measure(GlContext& context, const std::string& scene, int team, int halvings, bool compare, int bodies) {
  const bool towers = scene == "towers";
  Setting setting = scene == "avalanche" ? avalanche(bodies) : make_setting(!towers, bodies);
  setting.params.solver.halvings = halvings;
  DeviceOptions options;
  options.time_phases = true;
  options.team = team;
  const auto start = Clock::now();
  DeviceSolver device(context, setting.model, setting.state, options);
  device.step(setting.params);
  const double begin = ms_since(start);
  const int warm_up = towers ? 20 : 60, steps = 60;
  for (int k = 0; k < warm_up; ++k) device.enqueue(setting.params);
  device.finish();
  const auto timed = Clock::now();
  for (int k = 0; k < steps; ++k) device.enqueue(setting.params);
  const StepSummary summary = device.finish();
  const double ms = ms_since(timed) / steps;
  const DeviceTimes& t = device.times();

  device.read_state(setting.state);
  setting.state.joint_force.clear();
  const int processor_steps = bodies <= 1000 ? 100 : bodies <= 10000 ? 20 : bodies <= 100000 ? 4 : 1;
  const int threads = available_cpus();
  const double one = compare ? time_processor(setting, 1, processor_steps) : 0;
  const double all = compare ? time_processor(setting, threads, processor_steps) : 0;
  fmt::print(
      "| {} | {} | {} | {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.0f} | {:.2f} | "
      "{:.2f} | {:.1f} |\n",
      scene, bodies, device.pairs(), device.contacts(), device.colors(), ms, t.broad_phase, t.narrow_phase,
      t.set_up, t.solve, t.velocities, static_cast<double>(device.bytes()) / bodies, one, all, all / ms);
  fmt::print(
      "  start {:.0f} ms, {} steps repeated, kinetic {:.4g} J, least gap {:.4g} m, friction excess {:.3g}, "
      "residual {:.3g}\n",
      begin, device.repeated(), summary.kinetic, summary.min_gap, summary.friction_excess, summary.residual);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) try {
  std::string scene = "towers";
  int team = 0, halvings = 0;
  bool compare = true;
  std::vector<int> sizes;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    if (word == "heap" || word == "towers" || word == "avalanche") {
      scene = word;
    } else if (word == "--gpu") {
      compare = false;
    } else if (word == "--team" && k + 1 < argc) {
      team = std::clamp(std::atoi(argv[++k]), 1, 32);
    } else if (word == "--halvings" && k + 1 < argc) {
      halvings = std::clamp(std::atoi(argv[++k]), 0, 8);
    } else {
      sizes.push_back(std::atoi(argv[k]));
    }
  }
  if (sizes.empty()) sizes = {1000, 10000, 100000, 1000000};
  std::vector<ContextAttempt> attempts;
  const auto context = create_headless_context(Backend::automatic, attempts);
  const ComputeLimits limits = compute_limits(ComputeFunctions(*context));
  fmt::print("{}, OpenGL {}; processor: {} threads\n\n", limits.renderer, limits.version, available_cpus());
  fmt::print(
      "| scene | bodies | pairs | contacts | colors | ms a step | broad | narrow | set up | solve | end | "
      "bytes a body | "
      "CPU, 1 thread | all threads | ratio "
      "|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const int bodies : sizes) measure(*context, scene, team, halvings, compare, bodies);
  return 0;
} catch (const Error& error) {
  fmt::print(stderr, "bench_device: {}\n", error.what());
  return 4;
}
