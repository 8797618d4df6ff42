// SPDX-License-Identifier: MIT
// Commands of a session.
#include "app/session/session.h"

#include <limits>
#include <utility>

#include "sim/base/error.h"
#include "sim/solver/step_summary.h"

namespace pabd {

Session::Session(Scene scene, int threads)
    : Session(std::make_shared<const Scene>(std::move(scene)), threads) {}

Session::Session(std::shared_ptr<const Scene> scene, int threads)
    : scene_(std::move(scene)),
      model_(scene_, &scene_->model),
      params_(scene_, &scene_->params),
      state_(scene_->initial) {
  options_.threads = threads;
  describe_start();
}

double Session::kappa() const { return resolve_kappa(*model_, *params_); }

FrameView Session::view(std::shared_ptr<const State> state) const {
  if (!state) state = std::make_shared<const State>(state_);
  return {model_, *params_, kappa(), std::move(state), {}, report_, {}, {}, {}};
}

void Session::solve_with(std::shared_ptr<StepEngine> engine) {
  const auto before = std::exchange(engine_, std::move(engine));
  if (before && before != engine_) before->complete(state_);
}

void Session::prepare() {
  if (engine_) engine_->prepare(*model_, *params_, options_, state_);
}

void Session::complete_state() {
  if (engine_) engine_->complete(state_);
}

FrameView Session::view_on_device(std::shared_ptr<const PoseCopy> poses) const {
  auto now = std::make_shared<State>();
  now->step = state_.step;
  now->time = state_.time;
  FrameView out = view(std::move(now));
  out.poses = std::move(poses);
  return out;
}

State Session::whole_state() const {
  State out = state_;
  if (engine_) engine_->complete(out);
  return out;
}

const StepReport& Session::step() {
  if (engine_) {
    engine_->step(*model_, *params_, options_, state_, report_);
  } else {
    pabd::step(*model_, *params_, options_, state_, workspace_, report_);
  }
  return report_;
}

void Session::take(std::shared_ptr<const Model> model) {
  if (engine_ && (model != model_ || options_.bodies_stay)) engine_->forget();
  model_ = std::move(model);
}

void Session::reset() {
  take({scene_, &scene_->model});
  params_ = {scene_, &scene_->params};
  state_ = scene_->initial;
  describe_start();
}

void Session::set_params(const Params& params) { set_params(std::make_shared<const Params>(params)); }

void Session::set_params(std::shared_ptr<const Params> params) {
  if (const auto error = check_params(*params)) {
    throw Error(ErrorKind::bad_input, error->pointer + ": " + error->message);
  }
  params_ = std::move(params);
}

void Session::set_state(State state) { restore(model_, std::move(state)); }

void Session::restore(std::shared_ptr<const Model> model, State state) {
  if (state.size() != model->size()) {
    throw Error(ErrorKind::bad_input, "the state has " + std::to_string(state.size()) +
                                          " bodies, the scene has " + std::to_string(model->size()) +
                                          "; use a state of this scene");
  }
  take(std::move(model));
  // Copied, as in reset(): where the number of bodies is the same, its arrays stay where they are.
  state_ = state;
  describe_start();
}

void Session::restore(std::shared_ptr<const Model> model, State state, StepReport made) {
  restore(std::move(model), std::move(state));
  report_ = std::move(made);
}

void Session::edit(const ModelEdit& edit) {
  complete_state();
  auto model = std::make_shared<Model>(*model_);
  apply_edit(edit_from_json(to_json(edit), "edit"), scene_->joint_law, *model, state_);
  take(std::move(model));
  options_.pulls.clear();  // their numbers may have moved
  describe_start();
}

// What is known before the first step: energies, but no contacts.
void Session::describe_start() {
  report_ = StepReport{};
  report_.step = state_.step;
  report_.time = state_.time;
  report_.method = params_->solver.method;
  report_.status = StepStatus::converged;
  report_.kappa = kappa();
  report_.min_gap = std::numeric_limits<double>::infinity();
  report_.kinetic = kinetic_energy(*model_, state_);
  report_.potential = potential_energy(*model_, *params_, state_);
  report_.elastic = spring_energy(*model_, state_);
}

}  // namespace pabd
