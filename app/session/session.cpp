// Commands of a session.
#include "app/session/session.h"

#include <limits>
#include <utility>

#include "sim/error.h"
#include "sim/solver/step_summary.h"

namespace pabd {

Session::Session(Scene scene, int threads)
    : scene_(std::move(scene)), params_(scene_.params), state_(scene_.initial) {
  options_.threads = threads;
  describe_start();
}

double Session::kappa() const { return resolve_kappa(scene_.model, params_); }

const StepReport& Session::step() {
  pabd::step(scene_.model, params_, options_, state_, workspace_, report_);
  history_.add(report_);
  return report_;
}

void Session::reset() {
  params_ = scene_.params;
  state_ = scene_.initial;
  history_.clear();
  describe_start();
}

void Session::set_params(const Params& params) {
  if (const auto error = check_params(params)) {
    throw Error(ExitCode::bad_input, error->pointer + ": " + error->message);
  }
  params_ = params;
}

void Session::set_state(State state) {
  if (state.size() != scene_.model.size()) {
    throw Error(ExitCode::bad_input, "the state has " + std::to_string(state.size()) +
                                         " bodies, the scene has " + std::to_string(scene_.model.size()) +
                                         "; use a state of this scene");
  }
  state_ = std::move(state);
  history_.clear();
  describe_start();
}

// What is known before the first step: energies, but no contacts.
void Session::describe_start() {
  report_ = StepReport{};
  report_.step = state_.step;
  report_.time = state_.time;
  report_.method = params_.solver.method;
  report_.status = StepStatus::converged;
  report_.kappa = kappa();
  report_.min_gap = std::numeric_limits<double>::infinity();
  report_.kinetic = kinetic_energy(scene_.model, state_);
  report_.potential = potential_energy(scene_.model, params_, state_);
}

}  // namespace pabd
