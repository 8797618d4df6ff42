// SPDX-License-Identifier: MIT
// pabd run: simulate without any GL, and write what happened.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

#include "app/cli/common.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/cli/scene_lookup.h"
#include "app/cli/simulation_setup.h"
#include "app/cli/step_statistics.h"
#include "app/cli/streams.h"
#include "app/frames/frame_schedule.h"
#include "sim/base/error.h"
#include "sim/solver/step_summary.h"
#include "sim/trace/trace.h"

namespace pabd::cli {
namespace {

struct RunOptions {
  CommonOptions common;
  std::string scene;
  std::optional<double> time;
  std::optional<std::int64_t> steps;
  std::string from;
  std::string trace;
  std::string iterations;
  std::string joints;
  std::string state;
  bool profile = false;
  bool force = false;
};

// The files a run can write; each appears when it is whole.
class RunOutputs {
 public:
  RunOutputs(const RunOptions& options, const InputFiles& inputs) {
    const auto open = [&](const char* option, const std::string& path, std::optional<TextOutput>& output) {
      if (!path.empty()) output.emplace(option, path, options.force, inputs);
    };
    open("--trace", options.trace, trace_);
    open("--iterations", options.iterations, iterations_);
    open("--joints", options.joints, joints_);
    open("--state", options.state, state_);
    emit(trace_, [](std::ostream& out) { write_steps_header(out); });
    emit(iterations_, [](std::ostream& out) { write_iterations_header(out); });
    emit(joints_, [](std::ostream& out) { write_joints_header(out); });
  }

  void add(const Model& model, const StepReport& report) {
    emit(trace_, [&](std::ostream& out) { write_steps_row(out, report); });
    emit(iterations_, [&](std::ostream& out) { write_iterations_rows(out, report); });
    emit(joints_, [&](std::ostream& out) { write_joints_rows(out, model, report); });
  }

  void finish(const Session& session) {
    if (state_) state_->write(state_to_json(session.model(), session.state()));
    for (auto* output : {&trace_, &iterations_, &joints_, &state_}) {
      if (*output) (*output)->finish();
    }
  }

 private:
  template <typename Writer>
  void emit(std::optional<TextOutput>& output, const Writer& writer) {
    if (!output) return;
    text_.str({});
    writer(text_);
    output->write(text_.view());
  }

  std::optional<TextOutput> trace_, iterations_, joints_, state_;
  std::ostringstream text_;
};

void check_options(const RunOptions& options) {
  if (options.time) check_range("--time", *options.time, 0, 1e6, "s");
  if (options.steps) check_range("--steps", static_cast<double>(*options.steps), 0, 1e9);
  const std::string* paths[] = {&options.trace, &options.iterations, &options.joints, &options.state};
  for (int i = 0; i < 4; ++i) {
    if (options.profile && *paths[i] == "-") {
      throw Error(ErrorKind::bad_input,
                  "--profile: its table goes to standard output; name a file in place of -");
    }
    for (int j = 0; j < i; ++j) {
      if (!paths[i]->empty() && *paths[i] == *paths[j]) {
        throw Error(
            ErrorKind::bad_input,
            fmt::format(
                "{}: named for two outputs; give each of --trace, --iterations, --joints, --state its own",
                *paths[i]));
      }
    }
  }
}

constexpr double kFrictionSaid = 0.01;  // of μ f_n; what is below is no news

// The worst of a run.
struct Extremes {
  double gap = std::numeric_limits<double>::infinity();  // m
  double joint_error = 0;                                // m
  std::int64_t unsolved = 0;                             // steps that ended at the iteration limit
  Index left_pairs = 0, too_dense = 0;                   // most of a step
  int capped = 0;                                        // bonds, in one step
  std::int64_t held = 0;                                 // steps that were shortened
  double friction = 0;                                   // largest excess above μ f_n, as a part of it
  std::int64_t lawless = 0;                              // steps in which it was above kFrictionSaid

  void add(const StepReport& report) {
    if (report.status == StepStatus::non_finite) return;  // it ended nowhere
    gap = std::min(gap, report.min_gap);
    joint_error = std::max(joint_error, report.max_joint_error);
    friction = std::max(friction, report.friction_excess);
    if (report.status == StepStatus::iteration_limit) ++unsolved;
    left_pairs = std::max(left_pairs, report.left_pairs);
    too_dense = std::max(too_dense, report.too_dense);
    capped = std::max(capped, report.capped_bonds);
    if (report.held_bodies > 0) ++held;
    if (report.friction_excess > kFrictionSaid) ++lawless;
  }
};

std::string summary(const Session& session, std::int64_t steps, double seconds, const Extremes& worst) {
  const std::string gap = std::isfinite(worst.gap) ? fmt::format("{:.4g} m", worst.gap) : "none";
  const std::string joints =
      session.model().joints.empty() ? "" : fmt::format(" · largest joint error {:.2g} m", worst.joint_error);
  const std::string unsolved =
      worst.unsolved > 0 ? fmt::format(", {} at the iteration limit", worst.unsolved) : "";
  std::string left;
  if (worst.lawless > 0)
    left += fmt::format(" · friction up to {:.2g} % above μ f_n in {} step{}", 100 * worst.friction,
                        worst.lawless, worst.lawless == 1 ? "" : "s");
  if (worst.left_pairs > 0)
    left += fmt::format(" · {} pairs of bodies deep in each other left out", worst.left_pairs);
  if (worst.too_dense > 0) left += fmt::format(" · {} bodies too dense for newton", worst.too_dense);
  if (worst.capped > 0) left += fmt::format(" · up to {} bonds softened for sissm", worst.capped);
  if (worst.held > 0) left += fmt::format(" · {} steps shortened, they would have made energy", worst.held);
  return fmt::format(
      "{} steps to t = {:.6g} s{}, {:.3f} ms a step · smallest gap {}{} · kinetic energy {:.4g} J{} · state "
      "{}\n",
      steps, session.state().time, unsolved, steps > 0 ? 1e3 * seconds / static_cast<double>(steps) : 0.0,
      gap, joints, kinetic_energy(session.model(), session.state()), left, state_hash(session.state()));
}

int run(const RunOptions& options) {
  check_options(options);
  InputFiles inputs;
  Session session = open_session(options.scene, options.common, options.from, inputs);
  const std::int64_t steps =
      options.steps.value_or(steps_until(options.time.value_or(5.0), session.params().h));
  RunOutputs outputs(options, inputs);
  session.record_iterations(!options.iterations.empty());
  session.report_joints(!options.joints.empty());

  const InterruptGuard interrupt;
  session.stop_when([&] { return interrupt.requested(); });
  std::int64_t done = 0;
  bool diverged = false;
  Extremes worst;
  StepStatistics statistics;
  const auto start = std::chrono::steady_clock::now();
  {
    Progress progress("step", steps, !options.common.quiet);
    while (done < steps && !diverged && !interrupt.requested()) {
      const StepReport& report = session.step();
      if (report.status == StepStatus::interrupted) break;
      outputs.add(session.model(), report);
      diverged = report.status == StepStatus::non_finite;
      worst.add(report);
      statistics.add(report);
      progress.update(++done, report);
    }
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  outputs.finish(session);
  if (!options.common.quiet) write_stderr(summary(session, done - (diverged ? 1 : 0), seconds, worst));
  if (options.profile) {
    write_stdout(profile_text(statistics, {seconds, session.model().size(), options.common.thread_count()}));
  }
  if (diverged) throw diverged_error(options.scene, session.report());
  return interrupt.exit_code();
}

}  // namespace

void add_run_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command =
      add_command(app, "run", "simulate a scene without drawing it",
                  {"pabd run pyramid --time 5 --trace steps.csv --state end.json",
                   "pabd run pyramid --from end.json --steps 60 --trace -",
                   "pabd run two_boxes --steps 1 --iterations iterations.csv --set solver.method=sissm",
                   "pabd run bridge --time 10 --joints joints.csv", "pabd run pile --steps 300 --profile"},
                  options->common);
  command->add_option("SCENE", options->scene, "scene file, or the name of a shipped scene")->required();
  auto* time = command->add_option("--time", options->time, "simulated time (default 5 s)")->type_name("S");
  command->add_option("--steps", options->steps, "number of time steps")->type_name("N")->excludes(time);
  command->add_option("--from", options->from, "continue from a state file of this scene")
      ->type_name("STATE.json");
  command->add_option("--trace", options->trace, "a row a step; - is standard output")->type_name("CSV");
  command->add_option("--iterations", options->iterations, "a row an iteration of the solver")
      ->type_name("CSV");
  command->add_option("--joints", options->joints, "a row a joint and step: its reaction, N and N m")
      ->type_name("CSV");
  command->add_option("--state", options->state, "the state at the end")->type_name("JSON");
  command->add_flag("--profile", options->profile,
                    "print where the time of the steps went, ms a step and %; rest: outputs, progress");
  command->add_flag("--force", options->force, "overwrite what exists");
  add_scene_options(*command, options->common);
  command->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace pabd::cli
