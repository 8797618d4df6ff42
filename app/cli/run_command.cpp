// SPDX-License-Identifier: MIT
// pabd run: simulate without drawing, and write what happened.
#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "app/cli/device_option.h"
#include "app/cli/help_text.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/cli/run_notes.h"
#include "app/cli/run_summary.h"
#include "app/cli/scene_lookup.h"
#include "app/cli/simulation_setup.h"
#include "app/cli/streams.h"
#include "app/session/step_at_time.h"
#include "sim/base/error.h"
#include "sim/scene/thickness.h"
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
  std::string device;
  bool profile = false;
  bool json = false;
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

void check_run(const RunOptions& options) {
  if (options.time) check_range("--time", *options.time, 0, 1e6, "s");
  if (options.steps) check_range("--steps", static_cast<double>(*options.steps), 0, 1e9);
  const std::string* paths[] = {&options.trace, &options.iterations, &options.joints, &options.state};
  for (int i = 0; i < 4; ++i) {
    if (options.profile && *paths[i] == "-") {
      throw Error(ErrorKind::bad_input,
                  "--profile: its table goes to standard output; name a file in place of -");
    }
    if (options.json && *paths[i] == "-") {
      throw Error(ErrorKind::bad_input,
                  "--json: the summary goes to standard output; name a file in place of -");
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

int run(const RunOptions& options) {
  check_run(options);
  InputFiles inputs;
  Session session = open_session(options.scene, options.common, options.from, inputs);
  const double time = options.time.value_or(session.scene().duration.value_or(5.0));
  const std::int64_t steps = options.steps.value_or(steps_until(time, session.params().h));
  RunFacts facts;
  facts.threads = options.common.thread_count();
  StepOptions wanted;
  wanted.record_iterations = !options.iterations.empty();
  wanted.report_joints = !options.joints.empty();
  facts.device = prepare_on_device(options.device, options.scene, session, wanted);
  RunOutputs outputs(options, inputs);
  RunNotes notes(session.model(), session.params());
  session.record_iterations(!options.iterations.empty());
  session.report_joints(!options.joints.empty());

  const InterruptGuard interrupt;
  session.stop_when([&] { return interrupt.requested(); });
  std::int64_t done = 0;
  bool diverged = false;
  const auto start = std::chrono::steady_clock::now();
  {
    Progress progress("step", steps, !options.common.quiet);
    while (done < steps && !diverged && !interrupt.requested()) {
      const StepReport& report = session.step();
      if (report.status == StepStatus::interrupted) break;
      outputs.add(session.model(), report);
      diverged = report.status == StepStatus::non_finite;
      facts.worst.add(report);
      facts.statistics.add(report);
      notes.add(report);
      progress.update(++done, report);
    }
  }
  facts.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  facts.steps = done - (diverged ? 1 : 0);
  facts.status = diverged ? "diverged" : done < steps ? "interrupted" : "done";
  session.complete_state();
  outputs.finish(session);
  const std::vector<std::string> told = notes.lines();
  if (const auto note = thickness_note(session.scene())) facts.notes.push_back(note->text);
  facts.notes.insert(facts.notes.end(), told.begin(), told.end());
  if (options.json) {
    write_stdout(json_text(summary_json(session, facts)));
  } else if (!options.common.quiet) {
    write_stderr(summary_text(session, facts));
  }
  if (!options.common.quiet) write_notes(told);
  if (options.profile)
    write_stdout(profile_text(facts.statistics, {facts.seconds, session.model().size(), facts.threads}));
  if (diverged) throw diverged_error(options.scene, session.report());
  return interrupt.exit_code();
}

}  // namespace

void add_run_command(CLI::App& app, Action& action) {
  auto options = std::make_shared<RunOptions>();
  const Command command(
      app, "run", "simulate a scene without drawing it",
      {"pabd run pyramid --time 5 --trace steps.csv --state end.json",
       "pabd run pyramid --from end.json --steps 60 --trace -",
       "pabd run two_boxes --steps 1 --iterations iterations.csv --set solver.method=sissm",
       "pabd run bridge --time 10 --joints joints.csv", "pabd run pile --steps 300 --profile",
       "pabd run pyramid --time 5 --quiet --json > summary.json",
       "pabd run large.json --steps 600 --device auto"},
      options->common);
  using namespace group;
  command.scene(options->scene);
  auto* time = command.option(kSimulation, "--time", options->time,
                              "simulated time (default: the duration of the scene, or 5 s)", "S");
  command.option(kSimulation, "--steps", options->steps, "number of time steps", "N")->excludes(time);
  command.option(kOutput, "--trace", options->trace, "a row a step; - is standard output", "CSV");
  command.option(kOutput, "--iterations", options->iterations, "a row an iteration of the solver", "CSV");
  command.option(kOutput, "--joints", options->joints, "a row a joint and step: its reaction, N and N m",
                 "CSV");
  command.option(kOutput, "--state", options->state, "the state at the end", "JSON");
  auto* profile =
      command.flag(kOutput, "--profile", options->profile,
                   "print where the time of the steps went, ms a step and %; rest: outputs, progress");
  command
      .flag(kOutput, "--json", options->json,
            "print the summary at the end as one JSON document to standard output, SI units")
      ->excludes(profile);
  command.force(options->force);
  command.from(options->from);
  command.simulation(options->common);
  add_device_option(command, options->device);
  command.carry_out(action, options, run);
}

}  // namespace pabd::cli
