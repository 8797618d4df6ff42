// SPDX-License-Identifier: MIT
// Time and comparison: see workbench.h. Parameters, undo and files are in files of their own.
#include "app/workbench/workbench.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "app/session/contact_advice.h"
#include "app/session/diverged.h"
#include "app/session/joint_settings.h"
#include "app/session/step_at_time.h"
#include "sim/base/error.h"
#include "sim/scene/tuning.h"

namespace pabd {
namespace {

constexpr std::size_t kMostMessages = 20, kMostHeld = 6;
constexpr int kMostSteps = 1'000'000;  // of one command

// Commands that do not ask where bodies are, which may be a device.
template <class C>
constexpr bool leaves_bodies(const C&) {
  return std::is_same_v<C, command::Play> || std::is_same_v<C, command::Speed> ||
         std::is_same_v<C, command::Set> || std::is_same_v<C, command::Tell> ||
         std::is_same_v<C, command::Observe>;
}

// `value` at place i, in place of `replaced` elements.
void put(SharedList<RunDistance>& list, std::size_t i, std::size_t replaced, const RunDistance& value) {
  const std::vector<RunDistance> rest(list.begin() + i + replaced, list.end());
  list.truncate(i);
  list.push_back(value);
  for (const RunDistance& d : rest) list.push_back(d);
}

}  // namespace

Workbench::Workbench(const WorkbenchOptions& options, const command::Load& scene) : options_(options) {
  carry_out(scene);
}

void Workbench::apply(const Command& command) {
  struct Forget {
    std::string& text;
    ~Forget() { text.clear(); }
  } const forget{about_};
  std::visit(
      [this](const auto& c) {
        about_ = c.name;
        if (!leaves_bodies(c)) bring_bodies_back();
        carry_out(c);
      },
      command);
}

const Run& Workbench::run(Side side) const { return side == Side::b && b_ ? *b_ : *a_; }

Run& Workbench::run_of(Side side) {
  if (side == Side::a) return *a_;
  if (!b_) throw Error(ErrorKind::bad_input, "there is no second simulation; start one with 'compare'");
  return *b_;
}

void Workbench::tell(Severity severity, const std::string& text, const std::string& about, ErrorKind kind) {
  const std::uint64_t number = shown_.messages.empty() ? 1 : shown_.messages.back().number + 1;
  shown_.messages.push_back({number, severity, text, about.empty() ? about_ : about, kind});
  if (shown_.messages.size() > kMostMessages) shown_.messages.erase(shown_.messages.begin());
}

// What cannot be is refused when it is asked for; what comes about by an edit or another parameter is told.
void Workbench::check_device(const Run& run, const Params& after) const {
  if (run.params().solver.device == after.solver.device) return;
  if (const auto answer = run.answer(after); answer.refused)
    throw Error(answer.kind, "solver.device", answer.why);
}

void Workbench::tell_of_device(const Run& run, const char* name, DeviceStatus& told) {
  const DeviceStatus& now = run.device();
  if (run.pulls() || now == told) return;
  told = now;
  if (run.params().solver.device == SolverDevice::gpu && !now.why.empty())
    tell(Severity::warning, std::string(name) + "the processor makes the steps: " + now.why, "device");
}

// Where nobody asks for states; whether it is so.
bool Workbench::let_bodies_stay() {
  const bool may = shown_.playing && !observe_.states && !b_;
  a_->let_bodies_stay(may);
  return may;
}

void Workbench::bring_bodies_back() {
  if (a_->bodies_stayed()) a_->complete();
}

bool Workbench::advance() {
  for (auto* run : {&a_, &b_})
    if (*run) (*run)->stop_when(options_.stop);
  let_bodies_stay();
  shown_.diverged = !a_->advance() || (b_ && !follow(*a_, *b_));
  tell_of_device(*a_, b_ ? "A: " : "", told_a_);
  if (b_) tell_of_device(*b_, "B: ", told_b_);
  measure_distance();
  if (!shown_.diverged) return true;
  shown_.playing = false;
  if (options_.stop && options_.stop()) return shown_.diverged = false;
  const bool first = a_->report().status == StepStatus::non_finite;
  const Run& run = first ? *a_ : *b_;
  const StepReport& failed = run.report();
  const bool elsewhere =
      failed.step != run.state().step + 1;  // the step began on a device, from where it is lost
  tell(Severity::error,
       fmt::format("{}diverged at step {} (t = {:.4g} s): the state was no longer finite. {}, and try {}",
                   b_ ? (first ? "A: " : "B: ") : "", failed.step, failed.time,
                   elsewhere
                       ? fmt::format("This is t = {:.4g} s, the last state that was kept: go back if need be",
                                     run.state().time)
                       : "Go back",
                   divergence_remedies(run.params().solver.method)),
       {}, ErrorKind::diverged);
  return false;
}

void Workbench::carry_out(const command::Play&) { shown_.playing = true; }
void Workbench::carry_out(const command::Pause&) { shown_.playing = false; }

void Workbench::carry_out(const command::Step& c) {
  shown_.playing = false;
  if (std::abs(static_cast<double>(c.steps)) > kMostSteps) {
    throw Error(ErrorKind::bad_input,
                fmt::format("step: expected at most {} steps, got {}", kMostSteps, c.steps));
  }
  if (c.steps < 0) {
    const auto back = static_cast<std::size_t>(-c.steps);
    seek_to(a_->cursor() > back ? a_->cursor() - back : 0);
  }
  for (int i = 0; i < c.steps; ++i) {
    if (!advance()) return;
  }
}

void Workbench::carry_out(const command::Seek& c) {
  shown_.playing = false;
  if (!std::isfinite(c.time)) throw Error(ErrorKind::bad_input, "seek: expected a time in seconds");
  seek_to(a_->timeline().at_time(c.time));
}

void Workbench::seek_to(std::size_t i) {
  ++shown_.jumps;
  a_->seek(i);
  if (b_) b_->seek(moment_in_step(a_->timeline(), i, b_->timeline()));
  measure_distance();
  shown_.diverged = false;
}

void Workbench::carry_out(const command::Speed& c) {
  if (!(c.factor >= 0 && c.factor <= 1000)) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("speed: expected 0 (as fast as it goes) to 1000 times real time, got {}", c.factor));
  }
  shown_.speed = c.factor;
}

void Workbench::carry_out(const command::Restart&) {
  const Timeline& past = a_->timeline();
  if (past.edits() || past.pulled() > 0) {
    keep_exchange("restart", heads(true, b_.has_value()));
    tell(Severity::note, "everything is as in the scene again; undo brings back what was done to the bodies");
  }
  a_->restart();
  if (b_) b_->restart();
  shown_.diverged = false;
}

void Workbench::carry_out(const command::Compare& c) {
  std::vector<std::string> values = c.values;
  const std::vector<std::string> joints = take_joint_settings(values);
  const Params params = tuned(b_ ? b_->params() : a_->params(), values);
  if (b_) return change(Side::b, "parameters of B", params, joints);
  check_device(*a_, params);
  Run b = a_->fork();
  if (!joints.empty())
    b.continue_as(read_with_joints(source_, *shown_.scene, shown_.scene->joint_law, joints));
  b.set_params(params);
  b_.emplace(std::move(b));
  distances_ = {};
  measure_distance();
}

void Workbench::carry_out(const command::EndCompare&) {
  if (!b_) return;
  std::shared_ptr<GivenUp> given_up = heads(false, true);
  b_.reset();
  distances_ = {};
  keep_exchange("end of the comparison", std::move(given_up));
}

void Workbench::carry_out(const command::Hold& c) {
  SolverMethod method = a_->report().method;
  if (!c.method.empty()) {
    method = tuned(a_->params(), {"solver.method=" + c.method, "solver.projection=auto"}).solver.method;
  }
  const bool as_made = c.method.empty() && !a_->report().records.empty();
  const StepReport made = as_made ? a_->report() : a_->step_with(method);
  if (made.records.empty())
    throw Error(ErrorKind::bad_input, "no step with contacts or joints led here: there is nothing to hold");
  if (shown_.held.size() >= kMostHeld) {
    keep_held("oldest held curve");
    shown_.held.erase(shown_.held.begin());
  }
  const std::int64_t step = a_->state().step;
  shown_.held.push_back({fmt::format("{}, step {}", to_string(method), step), step,
                         std::make_shared<const std::vector<IterationRecord>>(made.records),
                         made.capped_bonds});
}

void Workbench::carry_out(const command::DropHeld&) {
  if (shown_.held.empty()) return;
  keep_held("held curves");
  shown_.held.clear();
}

void Workbench::keep_held(const std::string& what) {
  auto given_up = std::make_shared<GivenUp>();
  given_up->held = shown_.held;
  keep_exchange(what, std::move(given_up));
}

void Workbench::carry_out(const command::Observe& c) {
  const bool more = (c.iterations && !observe_.iterations) || (c.contacts && !observe_.contacts) ||
                    (c.bodies && !observe_.bodies);
  observe_ = c;
  if (c.states) bring_bodies_back();
  for (auto* run : {&a_, &b_}) {
    if (!*run) continue;
    (*run)->observe(c.iterations, c.contacts, c.bodies);
    if (more) (*run)->seek((*run)->cursor());
  }
}

void Workbench::carry_out(const command::Tell& c) {
  tell(c.error ? Severity::error : Severity::note, c.text, c.about, c.kind);
}

// At times that both have a state of. What lies behind the present when a run takes another course is gone.
void Workbench::measure_distance() {
  if (!b_ || !at_common_time(*a_, *b_)) return;
  const double time = a_->state().time;
  const double end = std::min(a_->timeline().back().report.time, b_->timeline().back().report.time);
  while (!distances_.empty() && distances_.back().time > std::max(time, end))
    distances_.truncate(distances_.size() - 1);
  const auto at = std::lower_bound(distances_.begin(), distances_.end(), time - 1e-12,
                                   [](const RunDistance& d, double t) { return d.time < t; });
  const RunDistance here{time, largest_distance(a_->state(), b_->state())};
  const auto i = static_cast<std::size_t>(at - distances_.begin());
  const bool known = at != distances_.end() && at->time <= time + 1e-12;
  if (!known || at->position != here.position) put(distances_, i, known ? 1 : 0, here);
}

Snapshot Workbench::snapshot() {
  if (!let_bodies_stay()) bring_bodies_back();
  ++shown_.serial;
  Snapshot s = shown_;
  s.scene_path = source_.path;
  s.scene_sets = source_.sets;
  s.a = view(*a_, changed_a_);
  if (b_) {
    s.b = view(*b_, changed_b_);
    s.distances = distances_.view();
  }
  s.unsaved = !made_since_saved().empty();
  s.at_stake = at_stake();
  s.reload_loses = reload_loses();
  s.can_undo = !undo_.empty();
  s.can_redo = !redo_.empty();
  if (s.can_undo) s.undo_text = undo_.back().what;
  if (s.can_redo) s.redo_text = redo_.back().what;
  s.timeline_bytes = a_->timeline().bytes() + (b_ ? b_->timeline().bytes() : 0);
  s.timeline_budget = options_.memory;
  s.forgotten = a_->timeline().forgotten();
  return s;
}

RunView Workbench::view(const Run& run, ChangedKeys& changed) const {
  if (changed.scene != shown_.scene_serial || changed.params != run.params())
    changed = {shown_.scene_serial, run.params(), differences(shown_.scene->params, run.params())};
  RunView v;
  static_cast<FrameView&>(v) = run.view();
  v.scene = run.shared_scene();
  v.history = run.timeline().reports();
  v.made_with = *run.timeline()[run.cursor()].params;
  v.alike = run.timeline().made_alike(run.cursor(), kStepsLookedAt);
  v.changed = changed.keys;
  for (const auto& one : joint_differences(shown_.scene->joint_law, run.scene().joint_law))
    v.changed.push_back(one);
  v.cursor = run.cursor();
  v.device = run.device();
  v.gone = run.timeline().gone();
  if (run.pulls()) v.pulls = *run.pulls();
  if (run.left()) v.left = run.left()->reports();
  v.parting = run.parting();
  return v;
}

}  // namespace pabd
