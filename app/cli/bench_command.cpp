// SPDX-License-Identifier: MIT
// pabd bench: the shipped scenes, or others, one after the other, as a table to paste into a report.
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <stdlib.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <ctime>
#include <memory>
#include <optional>
#include <stdexcept>

#include "app/cli/bench_table.h"
#include "app/cli/device_option.h"
#include "app/cli/help_text.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/cli/scene_lookup.h"
#include "app/cli/simulation_setup.h"
#include "app/cli/streams.h"
#include "app/session/step_at_time.h"
#include "sim/base/counted.h"
#include "sim/base/error.h"
#include "sim/import/import.h"
#include "sim/scene/text.h"
#include "sim/solver/step_summary.h"
#include "sim/trace/trace.h"

namespace pabd::cli {
namespace {

constexpr std::int64_t kDefaultSteps = 300;
constexpr std::int64_t kMostSteps = 1'000'000;

struct BenchOptions {
  CommonOptions common;
  std::vector<std::string> scenes;
  std::optional<double> time;
  std::optional<std::int64_t> steps;
  std::int64_t repeat = 1;
  std::string json;
  std::string device;
  bool force = false;
  bool solvers = false;
};

struct BenchScene {
  std::string name;
  std::string asked;  // the solver, where several are compared
  std::shared_ptr<const Scene> scene;
  std::int64_t steps;
  DeviceChoice device;
};

void check_bench(const BenchOptions& options) {
  if (options.time) check_range("--time", *options.time, 0, 1e6, "s");
  if (options.steps)
    check_range("--steps", static_cast<double>(*options.steps), 1, static_cast<double>(kMostSteps));
  check_range("--repeat", static_cast<double>(options.repeat), 1, 1000);
  if (options.solvers && !options.device.empty() && options.device != "cpu")
    throw Error(ErrorKind::bad_input, "--solvers: compares solvers of the processor: leave out --device");
}

std::int64_t step_count(const BenchOptions& options, const std::string& name, const Scene& scene) {
  if (!options.time) return options.steps.value_or(kDefaultSteps);
  const std::int64_t steps = steps_until(*options.time, scene.params.h);
  if (steps >= 1 && steps <= kMostSteps) return steps;
  throw Error(ErrorKind::bad_input,
              fmt::format("--time {}: {} of {}; expected 1 … {}, which is {:.4g} … {:.4g} s", *options.time,
                          counted(steps, "step"), name, kMostSteps, scene.params.h,
                          static_cast<double>(kMostSteps) * scene.params.h));
}

// All of them before the first step: what is wrong with the last is said at once.
std::vector<BenchScene> open_scenes(const BenchOptions& options, InputFiles& inputs) {
  std::vector<std::pair<std::string, std::filesystem::path>> named;
  for (const std::string& name : options.scenes) named.emplace_back(name, find_scene(name));
  if (options.scenes.empty()) {
    for (const auto& file : shipped_scenes()) named.emplace_back(file.stem().string(), file);
  }
  if (named.empty()) {
    throw Error(ErrorKind::file,
                "no folder with shipped scenes was found; run 'cmake --install' again, or name files");
  }
  std::vector<BenchScene> scenes;
  for (const auto& [name, file] : named) {
    auto scene = std::make_shared<const Scene>(load_any_scene(file, options.common.sets));
    for (const auto& read : scene->files) inputs.add(read);
    const std::int64_t steps = step_count(options, name, *scene);
    if (!options.solvers) {
      DeviceChoice device = choose_device(options.device, Backend::automatic, name,
                                          {{&scene->model, &scene->params, &scene->initial}}, {});
      scenes.push_back({name, "", std::move(scene), steps, std::move(device)});
      continue;
    }
    for (const SolverMethod method : {SolverMethod::automatic, SolverMethod::descent, SolverMethod::newton}) {
      auto with = std::make_shared<Scene>(*scene);
      with->params.solver.method = method;
      scenes.push_back({name, to_string(method), std::move(with), steps, {}});
    }
  }
  return scenes;
}

double process_cpu_ms() {
  timespec t = {};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

BenchHead describe_here(const BenchOptions& options) {
  BenchHead head;
  head.date = fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::time(nullptr)));
  head.cpu = find_cpu();
  if (getloadavg(&head.load, 1) != 1) head.load = -1;
  head.threads = options.common.thread_count();
  head.repeat = static_cast<int>(options.repeat);
  return head;
}

// Measures scene after scene, until the end or until somebody asks for it.
class Bench {
 public:
  Bench(const BenchOptions& options, int threads) : options_(options), threads_(threads) {}

  void measure(const BenchScene& scene) {
    BenchRow row;
    row.scene = scene.name;
    row.asked = scene.asked;
    row.bodies = scene.scene->model.size();
    row.joints = scene.scene->model.joints.size();
    row.device = scene.device.name;
    const auto engine = scene.device.engine(Backend::automatic);  // the repetitions share what is compiled
    Progress progress("step of " + printable(scene.name), scene.steps * options_.repeat,
                      !options_.common.quiet);
    for (std::int64_t k = 0; k < options_.repeat && !interrupt_.requested(); ++k)
      run(scene, k, engine, progress, row);
    if (row.statistics.steps > 0) rows_.push_back(std::move(row));
  }

  const std::vector<BenchRow>& rows() const { return rows_; }
  const std::optional<Error>& failure() const { return failure_; }
  const InterruptGuard& interrupt() const { return interrupt_; }

 private:
  void run(const BenchScene& scene, std::int64_t repetition, const std::shared_ptr<StepEngine>& engine,
           Progress& progress, BenchRow& row) {
    using Clock = std::chrono::steady_clock;
    Session session(scene.scene, threads_);
    session.solve_with(engine);
    session.let_bodies_stay(true);
    session.prepare();
    session.stop_when([this] { return interrupt_.requested(); });
    // As the last step told it: where the next one fails the state may be an older one.
    double kinetic = row.kinetic;
    bool failed = false;
    for (std::int64_t done = 0; done < scene.steps && !interrupt_.requested();) {
      const double cpu = process_cpu_ms();
      const auto start = Clock::now();
      const StepReport& report = session.step();
      const double ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
      if (report.status == StepStatus::interrupted) break;
      row.wall_ms.push_back(ms);
      row.cpu_ms.push_back(process_cpu_ms() - cpu);
      if (repetition == 0) row.statistics.add(report);
      progress.update(repetition * scene.steps + ++done, report);
      if (report.status != StepStatus::non_finite) {
        kinetic = report.kinetic;
        continue;
      }
      failed = true;
      if (!failure_) failure_ = diverged_error(scene.name, session.report());
      break;
    }
    if (interrupt_.requested() && repetition > 0) return;
    session.complete_state();
    const std::string hash = state_hash(session.state());
    if (repetition > 0 && hash != row.hash)
      throw std::logic_error(
          fmt::format("{}: repetition {} ended in another state", scene.name, repetition + 1));
    row.hash = hash;
    row.kinetic = failed ? kinetic : kinetic_energy(session.model(), session.state());
  }

  const BenchOptions& options_;
  int threads_;
  InterruptGuard interrupt_;
  std::vector<BenchRow> rows_;
  std::optional<Error> failure_;  // the first scene that diverged; the others go on
};

int bench(const BenchOptions& options) {
  check_bench(options);
  InputFiles inputs;
  const std::vector<BenchScene> scenes = open_scenes(options, inputs);
  std::optional<TextOutput> json;
  if (!options.json.empty()) json.emplace("--json", options.json, options.force, inputs);
  const BenchHead head = describe_here(options);
  Bench bench(options, head.threads);
  for (const BenchScene& scene : scenes) {
    if (bench.interrupt().requested()) break;
    bench.measure(scene);
  }
  if (options.json != "-") {
    write_stdout(bench_markdown(head, bench.rows()));
    if (options.solvers) write_stdout(choice_markdown(bench.rows()));
  }
  if (json) {
    json->write(json_text(bench_json(head, bench.rows())));
    json->finish();
  }
  if (bench.failure()) throw *bench.failure();
  return bench.interrupt().exit_code();
}

}  // namespace

void add_bench_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<BenchOptions>();
  const Command command(
      app, "bench", "measure scenes: a Markdown table of times, solvers and errors, for a report",
      {"pabd bench", "pabd bench pyramid bridge --steps 60 --json bench.json",
       "pabd bench pile --time 5 --threads 1 --repeat 3", "pabd bench wall --set solver.method=newton",
       "pabd bench pile --device gpu --steps 100"},
      options->common);
  using namespace group;
  command.argument("SCENE", options->scenes,
                   "scene files, or names of shipped scenes (default: all shipped ones)");
  auto* time = command.option(kSimulation, "--time", options->time, "simulated time of each scene", "S");
  command.option(kSimulation, "--steps", options->steps, "time steps of each scene (default 300)", "N")
      ->excludes(time);
  command.option(kSimulation, "--repeat", options->repeat,
                 "how often each scene is run; times are medians over the steps of all (default 1)", "N");
  command.option(kOutput, "--json", options->json,
                 "write the same as JSON, SI units and ms; -: to standard output in place of the table",
                 "JSON");
  command.force(options->force);
  command.flag(kOwn, "--solvers", options->solvers,
               "measure every scene with auto, descent and newton; a second table tells what auto costs "
               "against the cheaper of the two");
  command.simulation(options->common);
  add_device_option(command, options->device);
  command.carry_out(action, options, bench);
}

}  // namespace pabd::cli
