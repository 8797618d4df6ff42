#include "tests/bench/peers/measure.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fstream>

#include "sim/collision/detect.h"
#include "sim/error.h"
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
  throw Error(ExitCode::file, "/proc/self/status: expected a line VmHWM; run on Linux");
}

Index highest_body(const State& state) {
  Index top = 0;
  for (Index i = 1; i < state.size(); ++i) {
    if (state.c[i].y() > state.c[top].y()) top = i;
  }
  return top;
}

// One yardstick for every engine: overlap of its poses, by this project's collision code.
class Ruler {
 public:
  explicit Ruler(const Model& model) : model_(model), reach_(static_cast<std::size_t>(model.size()), 0.0) {}

  void measure(const State& state, Depth& depth) {
    detect(model_, state.c, state.R, reach_, {}, 1, workspace_, points_);
    for (const ContactPoint& point : points_) depth.add(-point.d);
  }

 private:
  const Model& model_;
  std::vector<double> reach_;
  CollisionWorkspace workspace_;
  std::vector<ContactPoint> points_;
};

}  // namespace

void Depth::add(double depth) {
  if (!(depth > 0)) return;
  max = std::max(max, depth);
  sum += depth;
  ++count;
}

Measurement measure(const PeerScene& peer, int threads) {
  using Clock = std::chrono::steady_clock;
  const Scene& scene = peer.scene;
  Measurement result;
  State timed_end = scene.initial;
  {
    const auto engine = make_engine(scene, {threads, false});
    std::vector<double> times, cpu_times;
    for (int k = 0; k < kSteps; ++k) {
      const double cpu_start = process_cpu_ms();
      const auto start = Clock::now();
      engine->step();
      times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
      cpu_times.push_back(process_cpu_ms() - cpu_start);
    }
    result.median_ms = median(times);
    result.median_cpu_ms = median(cpu_times);
    result.median_last_ms = median({times.end() - kLastSteps, times.end()});
    result.peak_mib = peak_memory_mib();
    engine->read(timed_end);
  }

  const auto engine = make_engine(scene, {threads, true});
  State state = scene.initial;
  Ruler ruler(scene.model);
  std::vector<double> depths;
  for (int k = 0; k < kSteps; ++k) {
    engine->step();
    engine->penetrations(depths);
    const bool last = k >= kSteps - kLastSteps;
    for (const double depth : depths) {
      result.run.add(depth);
      if (last) result.last.add(depth);
    }
    if (!last) continue;
    engine->read(state);
    ruler.measure(state, result.ruler_last);
  }
  result.repeatable = state.c == timed_end.c && state.R == timed_end.R;
  result.kinetic = kinetic_energy(scene.model, state);
  if (peer.has_top) {
    const Index top = highest_body(scene.initial);
    Vec3 way = state.c[top] - scene.initial.c[top];
    result.top_drop = -way.y();
    way.y() = 0;
    result.top_shift = way.norm();
  }
  return result;
}

}  // namespace pabd::peers
