// SPDX-License-Identifier: MIT
// See task_run.h.
#include "app/sweep/task_run.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "app/session/session.h"
#include "app/session/step_at_time.h"
#include "app/session/timeline.h"
#include "app/sweep/acceptance.h"
#include "sim/base/atomic_file.h"
#include "sim/base/error.h"
#include "sim/base/input_file.h"
#include "sim/base/ordered_json.h"
#include "sim/trace/trace.h"

namespace fs = std::filesystem;

namespace pabd {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kDuration = 5;  // s, of a scene without a duration
constexpr const char* kFormat = "pabd-sweep-checkpoint " PABD_VERSION;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double energy_of(const StepSummary& s) { return s.kinetic + s.potential + s.elastic; }

// Progress of a run, beside its state.
struct SoFar {
  std::int64_t steps = 0;
  double seconds = 0, work = 0;  // wall clock; J, of drives
  Taken times;                   // ms
  std::vector<Taken> taken;      // one per metric
  double since = -1;             // when the stop condition began to hold, s; negative: it does not
  double last = 0, jumps = 0;    // ms; ms², sum over (time of a step − time of the one before)²
  NLOHMANN_DEFINE_TYPE_INTRUSIVE(SoFar, steps, seconds, work, times, taken, since, last, jumps)

  // Twice the standard error of the mean time, in which what changes slowly has no part (J. von Neumann, The mean square
  // successive difference, 1941); ms.
  double noise() const {
    const auto n = static_cast<double>(steps);
    return 2 * std::sqrt(jumps / (2 * (n - 1) * n));
  }
};

// A run that can be interrupted and resumed.
class TaskRun {
 public:
  TaskRun(const SweepPlan& plan, const SweepTask& task, std::shared_ptr<const Scene> scene,
          const TaskOptions& options)
      : plan_(plan), task_(task), session_(std::move(scene), options.threads), acceptance_(session_.model()) {
    so_far_.taken.resize(plan.metrics.size());
    session_.stop_when(options.stop);
    const Scene& own = session_.scene();
    const double time = plan.stop.time.value_or(own.duration.value_or(kDuration));
    last_ = plan.stop.steps.value_or(steps_until(time, own.params.h));
    energy_start_ = energy_of(session_.report());
    if (!plan.reference) return;
    reference_.emplace(std::make_shared<const Scene>(reference_scene(plan)), options.threads);
    reference_->stop_when(options.stop);
    if (reference_->model().size() != session_.model().size())
      throw Error(ErrorKind::bad_input, "reference",
                  fmt::format("it has {} bodies, this task {}: there is no distance between them",
                              reference_->model().size(), session_.model().size()));
  }

  bool is_over() const { return diverged_ || held_ || so_far_.steps >= last_; }

  // False: it was interrupted and is unchanged.
  bool step() {
    if (!advance_reference()) return false;
    const auto start = Clock::now();
    const StepReport& report = session_.step();
    const double ms = 1e3 * seconds_since(start);
    if (report.status == StepStatus::interrupted) return false;
    if (report.status == StepStatus::non_finite) {
      diverged_ = true;
      return true;
    }
    ++so_far_.steps;
    so_far_.seconds += 1e-3 * ms;
    so_far_.times.add(ms);
    if (so_far_.steps > 1) so_far_.jumps += (ms - so_far_.last) * (ms - so_far_.last);
    so_far_.last = ms;
    measure(report, ms);
    watch(report);
    return true;
  }

  TaskResult result() {
    session_.complete_state();
    TaskResult out;
    out.status = diverged_ ? "diverged" : "done";
    if (!diverged_)
      out.faults = acceptance_.faults(plan_.accept);
    else
      out.why = fmt::format("the state left all bounds at step {} (t = {:.6g} s)", so_far_.steps + 1,
                            session_.state().time + session_.params().h);
    for (std::size_t i = 0; i < so_far_.taken.size(); ++i) {
      const SweepMetric& metric = plan_.metrics[i];
      const auto value = so_far_.taken[i].value(metric.take);
      auto& place = metric.kind == MetricKind::step_time ? out.times : out.metrics;
      place[metric.name] = value ? OrderedJson(*value) : OrderedJson();
    }
    if (!out.times.contains("step_time"))
      out.times["step_time"] = so_far_.times.value(Take::mean).value_or(0);
    if (so_far_.steps > 1) out.times["step_time_noise"] = so_far_.noise();
    out.step = so_far_.steps;
    out.time = session_.state().time;
    out.seconds = so_far_.seconds;
    out.scene = session_.shared_scene();
    out.end = session_.state();
    return out;
  }

  std::string checkpoint() {
    session_.complete_state();
    Json json = so_far_;
    json["format"] = kFormat;
    json["hash"] = task_.hash;
    json["acceptance"] = acceptance_;
    json["state"] = state_to_json(session_.model(), session_.state());
    if (reference_) {
      reference_->complete_state();
      json["reference"] = state_to_json(reference_->model(), reference_->state());
    }
    return json.dump();
  }

  // False, or an exception of Error or JSON: not a checkpoint of this task; the run must not be used.
  bool take_up(const std::string& text) {
    const Json json = Json::parse(text);
    if (json.at("format") != kFormat || json.at("hash") != task_.hash) return false;
    if (json.at("taken").size() != so_far_.taken.size()) return false;
    json.get_to(so_far_);
    json.at("acceptance").get_to(acceptance_);
    restore(session_, json.at("state"));
    if (reference_) restore(*reference_, json.at("reference"));
    return session_.state().step == so_far_.steps;
  }

  std::size_t most_bytes() const { return 4 * most_state_bytes(session_.model()) + (std::size_t{1} << 20); }

 private:
  static void restore(Session& session, const Json& text) {
    session.set_state(state_from_json(session.model(), text.get<std::string>(), "checkpoint"));
  }

  // To the last step that is not after the next one of this run.
  bool advance_reference() {
    if (!reference_) return true;
    const double t = session_.state().time + session_.params().h, h = reference_->params().h;
    while (is_reached(reference_->state().time + h, t, h)) {
      const StepReport& report = reference_->step();
      if (report.status == StepStatus::interrupted) return false;
      if (report.status == StepStatus::non_finite)
        throw Error(
            ErrorKind::diverged, plan_.source,
            fmt::format("its \"reference\" diverges at step {}; give it a smaller time_step", report.step));
    }
    return true;
  }

  void measure(const StepReport& report, double ms) {
    so_far_.work += report.drive_work;
    StepMeasures step;
    step.report = &report;
    step.joints = !session_.model().joints.empty();
    const double gained = energy_of(report) - energy_start_ - so_far_.work;
    acceptance_.add(report, gained, session_.params().solver.tolerance > 0);
    step.energy_error = std::abs(gained);
    step.step_time = ms;
    if (reference_) step.distance = largest_distance(session_.state(), reference_->state());
    for (std::size_t i = 0; i < so_far_.taken.size(); ++i)
      so_far_.taken[i].add(measured(plan_.metrics[i], step));
  }

  void watch(const StepSummary& report) {
    if (!plan_.stop.when) return;
    const StopWhen& when = *plan_.stop.when;
    const double x = when.number->value(report);
    if (!(when.below ? x < when.bound : x > when.bound)) {
      so_far_.since = -1;
      return;
    }
    if (so_far_.since < 0) so_far_.since = report.time;
    held_ = report.time - so_far_.since >= when.hold - forgiven(report.time, session_.params().h);
  }

  const SweepPlan& plan_;
  const SweepTask& task_;
  Session session_;
  std::optional<Session> reference_;
  std::int64_t last_ = 0;
  double energy_start_ = 0;
  SoFar so_far_;
  Acceptance acceptance_;
  bool held_ = false, diverged_ = false;
};

// From its checkpoint, or its start.
std::unique_ptr<TaskRun> begin(const SweepPlan& plan, const SweepTask& task,
                               const std::shared_ptr<const Scene>& scene, const fs::path& checkpoint,
                               const TaskOptions& options) {
  auto run = std::make_unique<TaskRun>(plan, task, scene, options);
  const std::string text = read_if_possible(checkpoint, run->most_bytes());
  if (text.empty()) return run;
  try {
    if (run->take_up(text)) return run;
  } catch (const Error&) {
  } catch (const Json::exception&) {
  }
  return std::make_unique<TaskRun>(plan, task, scene, options);
}

}  // namespace

std::optional<TaskResult> run_task(const SweepPlan& plan, const SweepTask& task, const fs::path& checkpoint,
                                   const TaskOptions& options) {
  std::unique_ptr<TaskRun> run;
  try {
    run = begin(plan, task, std::make_shared<const Scene>(scene_of(plan, task)), checkpoint, options);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_input) throw;
    TaskResult refused;
    refused.status = "refused";
    refused.why = error.what();
    return refused;
  }
  auto kept = Clock::now();
  while (!run->is_over()) {
    if ((options.stop && options.stop()) || !run->step()) {
      write_file(checkpoint, run->checkpoint());
      return std::nullopt;
    }
    if (run->is_over() || seconds_since(kept) < options.checkpoint_every) continue;
    write_file(checkpoint, run->checkpoint());
    kept = Clock::now();
  }
  return run->result();
}

void write_result(TaskFolder& folder, const SweepTask& task, const TaskResult& result, int threads) {
  OrderedJson json = {{"index", task.index}, {"hash", task.hash}, {"status", result.status}};
  if (!result.why.empty()) json["why"] = result.why;
  if (!result.faults.empty()) json["faults"] = result.faults;
  json["metrics"] = result.metrics;
  json["step"] = result.step;
  json["time"] = result.time;
  OrderedJson timing = {{"seconds", result.seconds}, {"threads", threads}};
  timing.update(result.times);
  if (result.scene) folder.write("end.json", state_to_json(result.scene->model, result.end));
  const auto text = [](const OrderedJson& j) {
    return j.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
  };
  folder.write("task.json", text(task.to_json()));
  folder.write("timing.json", text(timing));
  folder.write("result.json", text(json));
}

}  // namespace pabd
