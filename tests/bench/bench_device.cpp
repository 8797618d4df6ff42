// SPDX-License-Identifier: MIT
// The solver on the GPU against the processor's, over the number of bodies: ms of a step and of its phases, bytes a body.
//
//   bench_device [towers|heap] [bodies...]      1000 10000 100000 1000000
//
// towers: columns of ten boxes, each a little beside the one below, at rest. heap: boxes that fell in any
// orientation, while they hit each other. Both solvers make ten sweeps, no fewer.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "render/device/compute_functions.h"
#include "render/device/device_solver.h"
#include "sim/base/available_cpus.h"
#include "sim/base/error.h"
#include "sim/body/mass_properties.h"
#include "sim/solver/time_step.h"

using namespace pabd;

namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

struct Setting {
  Model model;
  State state;
  Params params;
};

void add(Setting& out, const Shape& shape, double density, const Vec3& c, const Mat3& R) {
  const bool fixed = is_plane(shape);
  const MassProperties mass = fixed ? MassProperties{0, Mat3::Zero()} : mass_properties(shape, density);
  out.model.name.push_back("");
  out.model.shape.push_back(shape);
  out.model.mass.push_back(mass.mass);
  out.model.J.push_back(mass.J);
  out.model.fixed.push_back(fixed);
  out.state.c.push_back(c);
  out.state.R.push_back(R);
  out.state.v.push_back(Vec3::Zero());
  out.state.omega.push_back(Vec3::Zero());
}

Setting make_setting(bool heap, int bodies) {
  constexpr int kHeight = 10;
  Setting out;
  out.params.solver.method = SolverMethod::descent;
  out.params.solver.iterations = 10;
  out.params.solver.tolerance = 0;
  add(out, Plane{{0, 1, 0}, 0}, 0, Vec3::Zero(), Mat3::Identity());
  const int side = static_cast<int>(std::ceil(std::sqrt(bodies / kHeight)));
  std::mt19937 random(1);
  const auto draw = [&] { return 2.0 * random() / 4294967296.0 - 1; };
  for (int k = 0; k < bodies; ++k) {
    const int column = k / kHeight, floor = k % kHeight;
    const double pitch = heap ? 0.8 : 1;
    Vec3 c(pitch * (column % side), 0.25 + 0.5 * floor + 0.0098 * (floor + 1), pitch * (column / side));
    Mat3 R = Mat3::Identity();
    if (!heap) c.x() += 0.02 * (floor % 2);
    if (heap) {
      c.y() += 0.5 + 0.4 * floor;
      const double x = draw(), y = draw(), z = draw(), angle = 3 * draw();
      R = Eigen::AngleAxisd(angle, Vec3(x, y, z).normalized()).toRotationMatrix();
    }
    add(out, Box{{0.25, 0.25, 0.25}}, 1000, c, R);
  }
  return out;
}

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

void measure(GlContext& context, bool heap, int bodies) {
  Setting setting = make_setting(heap, bodies);
  DeviceOptions options;
  options.time_phases = true;
  const auto start = Clock::now();
  DeviceSolver device(context, setting.model, setting.state, options);
  device.step(setting.params);
  const double begin = ms_since(start);
  const int warm_up = heap ? 60 : 20, steps = 60;
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
  const double one = time_processor(setting, 1, processor_steps);
  const double all = time_processor(setting, threads, processor_steps);
  fmt::print(
      "| {} | {} | {} | {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.2f} | {:.0f} | {:.2f} | "
      "{:.2f} | {:.1f} |\n",
      heap ? "heap" : "towers", bodies, device.pairs(), device.contacts(), device.colors(), ms, t.broad_phase,
      t.narrow_phase, t.set_up, t.solve, t.velocities, static_cast<double>(device.bytes()) / bodies, one, all,
      all / ms);
  fmt::print(
      "  start {:.0f} ms, {} steps repeated, kinetic {:.4g} J, least gap {:.4g} m, friction excess {:.3g}, "
      "residual {:.3g}\n",
      begin, device.repeated(), summary.kinetic, summary.min_gap, summary.friction_excess, summary.residual);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) try {
  bool heap = false;
  std::vector<int> sizes;
  for (int k = 1; k < argc; ++k) {
    const std::string word = argv[k];
    if (word == "heap" || word == "towers") {
      heap = word == "heap";
    } else {
      sizes.push_back(std::atoi(argv[k]));
    }
  }
  if (sizes.empty()) sizes = {1000, 10000, 100000, 1000000};
  std::vector<ContextAttempt> attempts;
  const auto context = create_headless_context(Backend::automatic, attempts);
  const ComputeLimits limits = compute_limits(ComputeFunctions(*context));
  fmt::print("{}, OpenGL {}; processor: {} threads\n\n", limits.renderer, limits.version,
             available_cpus());
  fmt::print(
      "| scene | bodies | pairs | contacts | colors | ms a step | broad | narrow | set up | solve | end | "
      "bytes a body | "
      "CPU, 1 thread | all threads | ratio "
      "|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const int bodies : sizes) measure(*context, heap, bodies);
  return 0;
} catch (const Error& error) {
  fmt::print(stderr, "bench_device: {}\n", error.what());
  return 4;
}
