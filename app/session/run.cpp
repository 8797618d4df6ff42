// SPDX-License-Identifier: MIT
// See run.h.
#include "app/session/run.h"

#include <fmt/format.h>

#include <algorithm>

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
    : scene_(scene), session_(std::move(scene), threads), threads_(threads), timeline_(memory) {
  if (start) session_.set_state(*start);
  add_moment();
}

Run::Run(std::shared_ptr<const Scene> scene, int threads, Timeline past)
    : scene_(scene),
      session_(std::move(scene), threads),
      threads_(threads),
      timeline_(std::move(past)),
      cursor_(timeline_.size() - 1) {
  session_.set_params(timeline_.back().params);
  seek(cursor_);
}

Run Run::fork() const {
  needs_processor();
  Run out(scene_, threads_, timeline_.budget());
  out.offer(devices_.offered());
  out.observe(iterations_, contacts_, bodies_);
  out.stop_when(stop_);
  out.timeline_ = timeline_;
  if (!timeline_.back().state && at_end())
    out.timeline_.put_state(std::make_shared<const State>(session_.whole_state()));
  out.cursor_ = at_end() ? out.timeline_.size() - 1 : cursor_;  // the oldest may be forgotten for that state
  out.seek(out.cursor_);
  out.session_.set_params(session_.shared_params());
  out.newest_ = newest_;
  out.pulls_ = pulls_;
  out.left_ = left_;
  out.parting_ = parting_;
  return out;
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
  if (engine && timeline_.budget() != kNoPast) throw past_error();
  session_.solve_with(std::move(engine));
}

void Run::needs_processor() const {
  if (session_.has_engine() && timeline_.budget() == kNoPast) throw past_error();
}

void Run::stop_when(const std::function<bool()>& stop) {
  stop_ = stop;
  session_.stop_when(stop);
}

bool Run::advance() {
  if (!at_end()) {
    seek(timeline_.next_kept(cursor_));
    return true;
  }
  const StepStatus status = make_step();
  if (status == StepStatus::non_finite || status == StepStatus::interrupted) return false;
  const bool past = timeline_.budget() != kNoPast;  // else the state need not be whole
  if (session_.has_engine() && past && keeps_state() && !bring_back()) return true;
  add_moment();
  compare();
  return true;
}

void Run::seek(std::size_t i) {
  needs_processor();
  const std::size_t before = timeline_.forgotten();
  complete();
  i = timeline_.kept(i - std::min(i, timeline_.forgotten() - before));
  if (at_end()) newest_ = session_.shared_params();
  go_to(i);
  // The parameters of a start are only those that were in force.
  cursor_ = i;
  pulls_.reset();
  if (at_end()) {
    session_.set_params(newest_);  // also those that no step was made with yet
  } else {
    session_.set_params(timeline_[i + 1].params);
    pulls_ = timeline_[i + 1].pulls;
  }
  ask_device();
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
  if (equal(pulls, listed(pulls_))) return;
  if (!at_end()) branch();
  pulls_ = pulls.empty() ? nullptr : std::make_shared<const std::vector<Pull>>(std::move(pulls));
  ask_device();
}

std::shared_ptr<const MadeEdit> Run::edit(const ModelEdit& edit) {
  auto made =
      std::make_shared<const MadeEdit>(MadeEdit{to_json(edit), std::holds_alternative<AddJoint>(edit)});
  complete();
  if (continued_after_now()) branch();  // the model to edit is that of the scene it goes on with
  session_.edit(edit_from_json(made->text, "edit"));
  poses_.reset();
  if (!at_end()) branch();
  pulls_.reset();
  add_moment(made);
  ask_device();
  return made;
}

bool Run::undo_edit(const MadeEdit& edit) {
  for (std::size_t i = timeline_.size(); i-- > 1;) {
    if (timeline_[i].edit.get() != &edit) continue;
    seek(i - 1);
    pulls_.reset();
    branch();
    return true;
  }
  return false;
}

void Run::continue_as(std::shared_ptr<const Scene> scene) {
  for (std::size_t i = 1; i <= cursor_; ++i) {
    if (timeline_[i].edit) throw_edited();
  }
  if (!timeline_.forgotten_edits().empty()) throw_edited();
  complete();
  timeline_.branch(cursor_);
  const std::shared_ptr<const Params> params = session_.shared_params();
  const State here = session_.state();
  scene_ = std::move(scene);
  session_ = Session(scene_, threads_);
  poses_.reset();
  observe(iterations_, contacts_, bodies_);
  stop_when(stop_);
  session_.set_params(params);
  session_.set_state(here);
  left_.reset();
  parting_.reset();
  take_model_of_scene();
}

std::string Run::edits() const {
  std::string out;
  for (const auto& edit : timeline_.edits()) out += edit->text + "\n";
  return out;
}

StepReport Run::step_with(SolverMethod method) const {
  const Moment& m = timeline_[cursor_];
  if (m.start || cursor_ == 0) return {};
  if (timeline_.kept(cursor_ - 1) != cursor_ - 1)
    throw Error(ErrorKind::bad_input,
                "the state before this step, which a device made, was not kept: go to the next one");
  Params params = *m.params;
  if (params.solver.method != method) {
    params.solver.method = method;
    params.solver.projection = Projection::automatic;  // each method has its own
  }
  State state = *timeline_.state(cursor_ - 1, threads_);
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
  left_ = timeline_.branch(cursor_);
  parting_ = Parting{session_.state().time, {}, {}};
  if (again) take_model_of_scene();
}

// Whether a moment of continue_as is yet to come.
bool Run::continued_after_now() const {
  for (std::size_t i = cursor_ + 1; i < timeline_.size(); ++i) {
    if (timeline_[i].start && !timeline_[i].edit) return true;
  }
  return false;
}

void Run::take_model_of_scene() {
  session_.restore({scene_, &scene_->model}, State(session_.state()));
  session_.set_pulls({});
  pulls_.reset();
  add_moment(nullptr, true);
}

void Run::add_moment(std::shared_ptr<const MadeEdit> edit, bool start) {
  start = start || timeline_.empty() || edit;
  Moment moment{
      session_.shared_model(),  session_.shared_params(), nullptr, session_.report().summary(), start,
      start ? nullptr : pulls_, std::move(edit)};
  moment.device = !start && session_.has_engine();
  if (!moment.device || keeps_state()) moment.state = std::make_shared<const State>(session_.state());
  timeline_.add(std::move(moment));
  cursor_ = timeline_.size() - 1;
}

// Whether the state of a step that a device made is to be kept.
bool Run::keeps_state() const {
  return timeline_.budget() == kNoPast || timeline_.wants(state().step, state_bytes(state()), !stayed_);
}

void Run::compare() {
  if (!left_ || left_->empty() || parting_->parted) return;
  const Moment& other = (*left_)[left_->at_time(state().time)];
  if (!other.state || other.report.step != state().step || other.model != shared_model()) return;
  if (!parting_->differs && !same_bits(*other.state, state())) parting_->differs = state().time;
  if (largest_distance(*other.state, state()) > params().contact.d_hat) parting_->parted = state().time;
}

}  // namespace pabd
