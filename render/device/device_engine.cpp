// SPDX-License-Identifier: MIT
// See device_engine.h.
#include "render/device/device_engine.h"

#include <chrono>
#include <cstring>
#include <limits>
#include <thread>

#include "sim/base/error.h"
#include "sim/solver/step_numbers.h"

namespace pabd {
namespace {

class Stopwatch {
 public:
  // ms since it was made, or since the last call.
  double lap() {
    const auto now = Clock::now();
    return std::chrono::duration<double, std::milli>(now - std::exchange(start_, now)).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

std::unique_ptr<GlContext> open_context(Backend backend) {
  std::vector<ContextAttempt> attempts;
  return create_headless_context(backend, attempts);
}

// As far as it is known of a step that was not made.
StepReport not_made(StepStatus status, const Model& model, const Params& params, const State& state) {
  StepReport report;
  report.step = state.step + 1;
  report.time = state.time + params.h;
  report.method = SolverMethod::descent;
  report.status = status;
  report.kappa = resolve_kappa(model, params);
  return report;
}

StepReport failed(const StepSummary& summary) {
  StepReport report;
  static_cast<StepSummary&>(report) = summary;
  report.status = StepStatus::non_finite;
  report.residual = std::numeric_limits<double>::quiet_NaN();
  forget_end(report);
  return report;
}

// What the GPU's clock does not see: before its part of a step, and after it; ms.
void add_times(double before, double solving, double after, PhaseTimes& times) {
  const double on_gpu = times.detect + times.set_up + times.solve + times.velocities;
  times.set_up += before;
  times.velocities += after + std::max(0.0, solving - on_gpu);  // launches, and the wait for them
  times.total = times.detect + times.set_up + times.solve + times.velocities;
}

}  // namespace

void DeviceEngine::Left::set(const State& state) {
  step = state.step;
  time = state.time;
  c = state.c;
  R = state.R;
  v = state.v;
  omega = state.omega;
}

bool DeviceEngine::Left::is(const State& state) const {
  return step == state.step && time == state.time && same_bits(c, state.c) && same_bits(R, state.R) &&
         same_bits(v, state.v) && same_bits(omega, state.omega);
}

DeviceCapacity DeviceEngine::capacity(Backend backend) {
  const auto context = open_context(backend);
  const CurrentContext current(*context);
  return device_capacity(*context);
}

std::string DeviceEngine::why_not(const Model& model, const Params& params, const StepOptions& options) {
  const SolverMethod method = params.solver.method;
  if (method != SolverMethod::automatic && method != SolverMethod::descent)
    return std::string("the GPU solves by descent, not by ") + to_string(method) +
           ": --device cpu, or --set solver.method=auto";
  if (options.record_iterations)
    return "the GPU does not tell of its iterations (--iterations, convergence plot): --device cpu";
  if (options.report_bodies) return "the GPU does not tell of single bodies: --device cpu";
  if (options.report_joints) return "the GPU knows of no joints (--joints): --device cpu";
  if (!options.pulls.empty()) return "the GPU takes no hands on bodies: --device cpu";
  return DeviceSolver::why_not(model, params);
}

DeviceEngine::DeviceEngine(Backend backend, SharedContext* drawing) : context_(open_context(backend)) {
  {
    const CurrentContext current(*context_);
    const DeviceCapacity found = device_capacity(*context_);
    if (!found.why_not.empty()) throw Error(ErrorKind::no_context, found.why_not);
    name_ = found.renderer;
  }
  if (drawing) work_beside(drawing->take());
}

void DeviceEngine::work_beside(SharedContext::Lent lent) {
  if (!lent.context) return;
  const CurrentContext current(*lent.context);
  const DeviceCapacity found = device_capacity(*lent.context);
  if (!found.why_not.empty() || found.renderer != name_) return;
  gl_ = std::make_unique<ComputeFunctions>(*lent.context);
  context_ = std::move(lent.context);
  copies_ = std::move(lent.copies);
}

// In a thread of its own, so that the context of whoever draws in this one stays current.
DeviceEngine::~DeviceEngine() {
  std::thread([this] {
    try {
      const CurrentContext current(*context_);
      solver_.reset();
    } catch (const Error&) {  // the GPU is lost, and what was on it with it: nobody can be asked to free it
      static_cast<void>(solver_.release());
      static_cast<void>(new std::shared_ptr<GlContext>(context_));
    }
    context_.reset();
  }).join();
}

void DeviceEngine::check(const Model& model, const Params& params, const StepOptions& options) {
  const bool known = checked_ == &model && model_ == &model && checked_params_ == params;
  const bool plain =
      !options.record_iterations && !options.report_bodies && !options.report_joints && options.pulls.empty();
  if (known && plain) return;
  if (const std::string why = why_not(model, params, options); !why.empty())
    throw Error(ErrorKind::bad_input, why);
  checked_ = &model;
  checked_params_ = params;
}

void DeviceEngine::make_ready(const Model& model, const StepOptions& options, const State& state) {
  const bool stays = stayed_ && options.bodies_stay && left_.step == state.step && left_.time == state.time &&
                     left_.c.size() == state.c.size() && whole_.step == kNone;  // nobody asked for them
  const bool left = stays || left_.is(state), known = left || whole_.is(state);
  const bool contacts = options.report_contacts;
  if (solver_ != nullptr && model_ == &model && (contacts_ || !contacts)) {
    if (!known) solver_->set_state(state);
  } else {
    State whole = state;
    if (solver_ != nullptr && known && model_ == &model) solver_->read_state(whole);
    left_.step = whole_.step = kNone;
    solver_.reset();
    solver_ = std::make_unique<DeviceSolver>(*context_, model, whole,
                                             DeviceOptions{.precision = DevicePrecision::single,
                                                           .pairs = 0,
                                                           .contacts = 0,
                                                           .time_phases = true,
                                                           .report_contacts = contacts});
    model_ = &model;
    contacts_ = contacts;
  }
  if (!left || left_.step == kNone) left_.set(state);
}

void DeviceEngine::prepare(const Model& model, const Params& params, const StepOptions& options,
                           const State& state) {
  check(model, params, options);
  const CurrentContext current(*context_);
  make_ready(model, options, state);
}

void DeviceEngine::step(const Model& model, const Params& params, const StepOptions& options, State& state,
                        StepReport& report) {
  check(model, params, options);
  if (options.stop && options.stop()) {
    report = not_made(StepStatus::interrupted, model, params, state);
    return;
  }
  const CurrentContext current(*context_);
  Stopwatch watch;
  make_ready(model, options, state);
  const double before = watch.lap();
  left_.step = whole_.step = kNone;  // until the state is whole again
  const StepSummary& summary = solver_->step(params);
  const double solving = watch.lap();
  if (summary.status == StepStatus::non_finite) {
    report = failed(summary);
    return;
  }
  if (options.bodies_stay) {
    state.step = summary.step;
    state.time = summary.time;
    state.contacts.clear();
    state.joint_force.clear();
    left_.step = state.step;  // where bodies are it knows: as before
    left_.time = state.time;
  } else {
    solver_->read_state(state, false);
    left_.set(state);
  }
  stayed_ = options.bodies_stay;
  away_ = stayed_ ? state.step : kNone;
  report = {};
  static_cast<StepSummary&>(report) = summary;
  if (options.report_contacts) solver_->read_contacts(report.contact_reports);
  add_times(before, solving, watch.lap(), report.times);
}

std::shared_ptr<const PoseCopy> DeviceEngine::copy_poses() {
  const CurrentContext current(*context_);
  return copies_->copy(*gl_, solver_->pose_buffer(), solver_->pose_bytes());
}

void DeviceEngine::complete(State& state) {
  if (solver_ == nullptr || !knows(state)) {
    if (state.step != away_) return;
    throw Error(ErrorKind::no_context, "the bodies that were on the GPU are lost");
  }
  const CurrentContext current(*context_);
  solver_->read_state(state);
  if (stayed_) whole_.set(state);
}

}  // namespace pabd
