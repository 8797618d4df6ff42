// Commands of a session.
//
//   ½ m v² + ½ ω·(R I Rᵀ) ω   kinetic energy of a body     J
//   −m g·c                    its potential energy         J
#include "app/session/session.h"

#include <limits>
#include <utility>

#include "sim/body/mass_properties.h"
#include "sim/error.h"

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
  const Model& model = scene_.model;
  for (Index i = 0; i < model.size(); ++i) {
    if (model.fixed[i]) continue;
    const Mat3 inertia = inertia_tensor(model.J[i]);
    const Vec3 omega_body = state_.R[i].transpose() * state_.omega[i];
    report_.kinetic +=
        0.5 * model.mass[i] * state_.v[i].squaredNorm() + 0.5 * omega_body.dot(inertia * omega_body);
    report_.potential -= model.mass[i] * params_.gravity.dot(state_.c[i]);
  }
}

}  // namespace pabd
