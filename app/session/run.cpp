// SPDX-License-Identifier: MIT
// See run.h.
#include "app/session/run.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/session/step_at_time.h"
#include "sim/base/error.h"

namespace pabd {
namespace {

constexpr double kFarthest = 1e6;   // m
constexpr double kStiffest = 1e18;  // N/m

void check_pull(const Pull& pull, const Model& model) {
  if (pull.body < 0 || pull.body >= model.size()) {
    throw Error(ErrorKind::bad_input, fmt::format("pull: there is no body {}; expected a number below {}",
                                                  pull.body, model.size()));
  }
  const auto i = static_cast<std::size_t>(pull.body);
  if (model.fixed[i]) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("pull: {} is fixed and cannot be pulled; choose a body that moves", model.name[i]));
  }
  const bool fits =
      pull.r.allFinite() && pull.target.allFinite() && pull.r.cwiseAbs().maxCoeff() <= kFarthest &&
      pull.target.cwiseAbs().maxCoeff() <= kFarthest && pull.kappa > 0 && pull.kappa <= kStiffest;
  if (!fits) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("pull: expected places up to {:g} m from the origin and a stiffness from 0 to {:g} "
                    "N/m",
                    kFarthest, kStiffest));
  }
}

[[noreturn]] void throw_edited() {
  throw Error(
      ErrorKind::bad_input,
      "joints_default: bodies or joints were added or removed before; give B another law of its joints "
      "before that, or save the state as a scene and load that");
}

std::vector<Pull> listed(const Pulls& pulls) { return pulls ? *pulls : std::vector<Pull>{}; }

bool equal(const std::vector<Pull>& a, const std::vector<Pull>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Pull& x, const Pull& y) {
    return x.body == y.body && x.r == y.r && x.target == y.target && x.kappa == y.kappa;
  });
}

Error past_error() {
  return Error(ErrorKind::bad_input,
               "what can be wound back is computed on the processor: a run that has another device make its "
               "steps keeps no past; leave out the device");
}

}  // namespace

Run::Run(std::shared_ptr<const Scene> scene, int threads, std::size_t memory,
         const std::optional<State>& start)
    : head_{scene, Timeline(memory)}, session_(std::move(scene), threads), threads_(threads) {
  if (start) session_.set_state(*start);
  add_moment();
}

Run::Run(std::shared_ptr<const Scene> scene, int threads, Timeline past)
    : head_{scene, std::move(past)}, session_(std::move(scene), threads), threads_(threads) {
  session_.set_params(head_.timeline.back().params);
  head_.cursor = head_.timeline.size() - 1;
  seek(head_.cursor);
}

Head Run::head() const {
  needs_processor();
  Head out = head_;
  out.params = session_.shared_params();
  if (at_end()) out.newest = out.params;
  if (at_end() && !out.timeline.back().state) {
    out.timeline.put_state(std::make_shared<const State>(session_.whole_state()));
    out.cursor = out.timeline.size() - 1;  // the oldest may be forgotten for that state
  }
  return out;
}

void Run::go_to(Head head) {
  leave_device();
  const bool same_scene = head.scene == head_.scene;
  head_ = std::move(head);
  if (!same_scene) open_session();
  const Pulls pulls = head_.pulls;
  stand_at(head_.cursor);
  session_.set_params(head_.params);
  head_.pulls = pulls;
  ask_device();
}

Run Run::fork() const {
  Head here = head();
  Run out(here.scene, threads_, here.timeline.budget());
  out.offer(devices_.offered());
  out.observe(iterations_, contacts_, bodies_);
  out.stop_when(stop_);
  out.go_to(std::move(here));
  return out;
}

void Run::open_session() {
  session_ = Session(head_.scene, threads_);
  poses_.reset();
  observe(iterations_, contacts_, bodies_);
  stop_when(stop_);
}

void Run::observe(bool iterations, bool contacts, bool bodies) {
  iterations_ = iterations;
  contacts_ = contacts;
  bodies_ = bodies;
  session_.record_iterations(iterations);
  session_.report_contacts(contacts);
  session_.report_bodies(bodies);
}

void Run::solve_with(std::shared_ptr<StepEngine> engine) {
  if (engine && head_.timeline.budget() != kNoPast) throw past_error();
  session_.solve_with(std::move(engine));
}

void Run::needs_processor() const {
  if (session_.has_engine() && head_.timeline.budget() == kNoPast) throw past_error();
}

void Run::stop_when(const std::function<bool()>& stop) {
  stop_ = stop;
  session_.stop_when(stop);
}

bool Run::advance() {
  if (!at_end()) {
    seek(head_.timeline.next_kept(head_.cursor));
    return true;
  }
  const StepStatus status = make_step();
  if (status == StepStatus::non_finite || status == StepStatus::interrupted) return false;
  const bool past = head_.timeline.budget() != kNoPast;  // else the state need not be whole
  if (session_.has_engine() && past && keeps_state() && !bring_back()) return true;
  add_moment();
  compare();
  return true;
}

void Run::seek(std::size_t i) {
  needs_processor();
  const std::size_t before = head_.timeline.forgotten();
  complete();
  i = head_.timeline.kept(i - std::min(i, head_.timeline.forgotten() - before));
  if (at_end()) head_.newest = session_.shared_params();
  stand_at(i);
  ask_device();
}

// With the parameters and hands of the step that was made from there, or at the end of the next one.
void Run::stand_at(std::size_t i) {
  replay_to(i);
  // The parameters of a start are only those that were in force.
  head_.cursor = i;
  head_.pulls.reset();
  if (at_end()) {
    session_.set_params(head_.newest);  // also those that no step was made with yet
  } else {
    session_.set_params(head_.timeline[i + 1].params);
    head_.pulls = head_.timeline[i + 1].pulls;
  }
}

void Run::restart() {
  const std::shared_ptr<const Params> params = session_.shared_params();
  seek(0);
  session_.set_params(params);
  branch();
}

void Run::set_params(const Params& params) {
  if (session_.params() == params) return;
  session_.set_params(params);
  branch();
  ask_device();
}

void Run::set_pulls(std::vector<Pull> pulls) {
  for (const Pull& pull : pulls) check_pull(pull, model());
  if (equal(pulls, listed(head_.pulls))) return;
  if (!at_end()) branch();
  head_.pulls = pulls.empty() ? nullptr : std::make_shared<const std::vector<Pull>>(std::move(pulls));
  ask_device();
}

std::shared_ptr<const MadeEdit> Run::edit(const ModelEdit& edit) {
  auto made =
      std::make_shared<const MadeEdit>(MadeEdit{to_json(edit), std::holds_alternative<AddJoint>(edit)});
  complete();
  if (continued_after_now()) branch();  // the model to edit is that of the scene it goes on with
  session_.edit(edit);
  poses_.reset();
  if (!at_end()) branch();
  head_.pulls.reset();
  add_moment(made);
  ask_device();
  return made;
}

bool Run::undo_edit(const MadeEdit& edit) {
  for (std::size_t i = head_.timeline.size(); i-- > 1;) {
    if (head_.timeline[i].edit.get() != &edit) continue;
    seek(i - 1);
    head_.pulls.reset();
    branch();
    return true;
  }
  return false;
}

void Run::continue_as(std::shared_ptr<const Scene> scene) {
  if (head_.timeline[head_.cursor].edits) throw_edited();
  complete();
  head_.timeline.branch(head_.cursor);
  const std::shared_ptr<const Params> params = session_.shared_params();
  const State here = session_.state();
  head_.scene = std::move(scene);
  open_session();
  session_.set_params(params);
  session_.set_state(here);
  head_.left.reset();
  head_.parting.reset();
  take_model_of_scene();
}

StepReport Run::step_with(SolverMethod method) const {
  const Moment& m = head_.timeline[head_.cursor];
  if (m.start || head_.cursor == 0) return {};
  if (head_.timeline.kept(head_.cursor - 1) != head_.cursor - 1)
    throw Error(ErrorKind::bad_input,
                "the state before this step, which a device made, was not kept: go to the next one");
  Params params = *m.params;
  if (params.solver.method != method) {
    params.solver.method = method;
    params.solver.projection = Projection::automatic;  // each method has its own
  }
  State state = *head_.timeline.state(head_.cursor - 1, threads_);
  StepOptions options;
  options.threads = threads_;
  options.record_iterations = true;
  options.pulls = listed(m.pulls);
  StepWorkspace workspace;
  StepReport report;
  step(*m.model, params, options, state, workspace, report);
  return report;
}

void Run::branch() {
  if (at_end()) return;
  const bool again = continued_after_now();
  head_.left = head_.timeline.branch(head_.cursor);
  head_.parting = Parting{session_.state().time, {}, {}};
  if (again) take_model_of_scene();
}

// Whether a moment of continue_as is yet to come.
bool Run::continued_after_now() const {
  for (std::size_t i = head_.cursor + 1; i < head_.timeline.size(); ++i) {
    if (head_.timeline[i].start && !head_.timeline[i].edit) return true;
  }
  return false;
}

void Run::take_model_of_scene() {
  session_.restore({head_.scene, &head_.scene->model}, State(session_.state()));
  session_.set_pulls({});
  head_.pulls.reset();
  add_moment(nullptr, true);
}

void Run::add_moment(std::shared_ptr<const MadeEdit> edit, bool start) {
  start = start || head_.timeline.empty() || edit;
  Moment moment{
      session_.shared_model(),       session_.shared_params(), nullptr, session_.report().summary(), start,
      start ? nullptr : head_.pulls, std::move(edit)};
  moment.device = !start && session_.has_engine();
  if (!moment.device || keeps_state()) moment.state = std::make_shared<const State>(session_.state());
  head_.timeline.add(std::move(moment));
  head_.cursor = head_.timeline.size() - 1;
}

// Whether the state of a step that a device made is to be kept.
bool Run::keeps_state() const {
  return head_.timeline.budget() == kNoPast ||
         head_.timeline.wants(state().step, state_bytes(state()), !stayed_);
}

void Run::compare() {
  if (!head_.left || head_.left->empty() || head_.parting->parted) return;
  const Moment& other = (*head_.left)[head_.left->at_time(state().time)];
  if (!other.state || other.report.step != state().step || other.model != shared_model()) return;
  if (!head_.parting->differs && !same_bits(*other.state, state())) head_.parting->differs = state().time;
  if (largest_distance(*other.state, state()) > params().contact.d_hat) head_.parting->parted = state().time;
}

std::size_t moment_in_step(const Timeline& a, std::size_t i, const Timeline& b) {
  std::size_t j = b.at_time(a[i].report.time);
  // Edits that A has before it at this time are none of B yet.
  for (++i; i < a.size() && a[i].edit && j > 0 && b[j].edit; ++i) --j;
  return j;
}

void rejoin(const Run& a, Run& b) {
  const std::size_t known = moment_in_step(a.timeline(), a.cursor(), b.timeline());
  if (b.cursor() < known) b.seek(known);
}

bool follow(const Run& a, Run& b, const std::function<void()>& made) {
  rejoin(a, b);
  const double time = a.state().time;
  while (b.at_end() && is_reached(b.state().time + b.params().h, time, b.params().h)) {
    if (!b.advance()) return false;
    if (made) made();
  }
  return true;
}

bool at_common_time(const Run& a, const Run& b) {
  const double h = b.timeline()[b.cursor()].params->h;
  return a.state().size() == b.state().size() && is_common_time(a.state().time, b.state().time, h);
}

}  // namespace pabd
