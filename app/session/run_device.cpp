// SPDX-License-Identifier: MIT
// Who makes the steps of a run, and how it goes back to what others made: see run.h and step_devices.h.
#include "app/session/run.h"

#include <fmt/format.h>

namespace pabd {

namespace {

constexpr const char* kHands = "hands on bodies are the processor's";

}  // namespace

void DeviceSwitch::ask(const std::shared_ptr<const Model>& model, const Params& params, const State& state,
                       bool hands) {
  status_ = {};
  if (!devices_ || params.solver.device == SolverDevice::cpu) {
    failure_.clear();
    release();
    return;
  }
  if (model != model_ || params != params_) {
    answer_ = devices_->decide(*model, params, state);
    if (engine_ && model != model_) engine_->forget();
    model_ = model;
    params_ = params;
  }
  if (!failure_.empty()) {
    status_.why = failure_;
  } else if (!answer_.device) {
    status_.why = answer_.why;
    engine_.reset();
  } else if (hands) {
    status_.why = kHands;
  } else {
    status_.name = answer_.name;
  }
}

std::shared_ptr<StepEngine> DeviceSwitch::choose(const std::shared_ptr<const Model>& model,
                                                 const Params& params, const State& state, bool hands) {
  ask(model, params, state, hands);
  if (status_.name.empty()) return nullptr;
  try {
    if (!engine_) engine_ = devices_->open();
  } catch (const Error& error) {
    fail(error.what());
  }
  return engine_;
}

void DeviceSwitch::fail(const std::string& why) {
  failure_ = why;
  status_ = {"", why};
  engine_.reset();
}

void DeviceSwitch::release() {
  engine_.reset();
  model_.reset();
}

void Run::offer(std::shared_ptr<const StepDevices> devices) {
  devices_.offer(std::move(devices));
  ask_device();
}

StepDevices::Answer Run::answer(const Params& params) const {
  if (!devices_.offered() || params.solver.device == SolverDevice::cpu) return {};
  return devices_.offered()->decide(model(), params, state());
}

void Run::ask_device() {
  if (devices_.offered()) devices_.ask(shared_model(), params(), state(), head_.pulls != nullptr);
}

// What a device made lies nowhere else as long as the timeline does not want it.
void Run::complete() {
  if (head_.timeline.budget() == kNoPast || !session_.has_engine()) return;
  if (at_end() && head_.timeline.back().state) return;  // it came back for that
  if (!bring_back() || !at_end()) return;
  head_.timeline.put_state(std::make_shared<const State>(session_.state()));
  head_.cursor = head_.timeline.size() - 1;  // the oldest may be forgotten for it
}

// False when bodies are lost, and the run is where they were kept.
bool Run::bring_back() {
  try {
    session_.complete_state();
  } catch (const Error& error) {
    const bool lost = bodies_stayed();  // else friction begins anew
    poses_.reset();
    work_with(nullptr);
    if (lost) {
      StepReport kept;
      static_cast<StepSummary&>(kept) = head_.timeline[head_.timeline.kept(head_.cursor)].report;
      go_back_to_kept(std::move(kept));
    }
    devices_.fail(lost ? fmt::format("{}; back at t = {:.4g} s, which was kept", error.what(), state().time)
                       : error.what());
    if (lost) return false;
  }
  stayed_ = false;
  return true;
}

// Bodies that stayed on a device are lost: the run goes on where they were read back last.
void Run::go_back_to_kept(StepReport report) {
  head_.cursor = head_.timeline.kept(head_.cursor);
  head_.timeline.branch(head_.cursor);
  session_.restore(head_.timeline[head_.cursor].model, *head_.timeline.state(head_.cursor, threads_),
                   std::move(report));
  stayed_ = false;
  poses_.reset();
}

// null: the processor. Devices do not tell of iterations and single bodies.
void Run::work_with(const std::shared_ptr<StepEngine>& engine) {
  try {
    session_.solve_with(engine);
  } catch (const Error& error) {  // of the one before
    devices_.fail(error.what());
  }
  session_.record_iterations(iterations_ && !engine);
  session_.report_bodies(bodies_ && !engine);
}

void Run::leave_device() {
  poses_.reset();
  if (head_.timeline.budget() == kNoPast || !session_.has_engine()) return;
  complete();
  work_with(nullptr);
}

StepStatus Run::make_step() {
  session_.set_pulls(head_.pulls ? *head_.pulls : std::vector<Pull>{});
  if (!devices_.offered()) return session_.step().status;
  const auto engine = devices_.choose(shared_model(), params(), state(), head_.pulls != nullptr);
  if (!engine) {
    leave_device();
    return session_.step().status;
  }
  work_with(engine);
  const bool stay =
      may_stay_ && !head_.left && head_.timeline.budget() != kNoPast && session_.can_let_bodies_stay();
  session_.let_bodies_stay(stay);
  try {
    const StepStatus status = session_.step().status;
    if (status == StepStatus::non_finite) {
      if (bodies_stayed()) go_back_to_kept(StepReport(session_.report()));
    } else if (status != StepStatus::interrupted) {
      stayed_ = stay;
      poses_ = stay ? session_.copy_poses() : nullptr;
    }
    return status;
  } catch (const Error& error) {
    devices_.fail(error.what());
    leave_device();
    return session_.step().status;
  }
}

// Whether the device that made the step to moment i can make it again for its report.
bool Run::tells_again(std::size_t i) const {
  return contacts_ && head_.timeline[i - 1].state && devices_.engine() != nullptr &&
         devices_.model() == head_.timeline[i].model;
}

// A moment is reached by the step that led to it, so that its report is whole. To the next moment no state is
// looked up: this one is where the session is. What a device made is what it was; where it can make the step again, that
// tells of the contacts, to the tolerance of a solve.
void Run::replay_to(std::size_t i) {
  const Moment& m = head_.timeline[i];
  const bool first = i == 0 || m.start;
  const bool again = !first && !m.device && head_.timeline.kept(i - 1) == i - 1;
  leave_device();
  session_.set_pulls({});
  if (again) {
    if (i != head_.cursor + 1) session_.restore(m.model, *head_.timeline.state(i - 1, threads_));
    session_.set_params(m.params);
    session_.set_pulls(m.pulls ? *m.pulls : std::vector<Pull>{});
    session_.step();
    return;
  }
  if (first) {
    session_.set_params(m.params);
    return session_.restore(m.model, *head_.timeline.state(i, threads_));
  }
  StepReport made;
  if (m.device && tells_again(i)) {
    session_.restore(m.model, *head_.timeline[i - 1].state);
    session_.set_params(m.params);
    work_with(devices_.engine());
    try {
      made = session_.step();
    } catch (const Error& error) {
      devices_.fail(error.what());
    }
    work_with(nullptr);
  }
  static_cast<StepSummary&>(made) = m.report;
  session_.set_params(m.params);
  session_.restore(m.model, *head_.timeline.state(i, threads_), std::move(made));
}

}  // namespace pabd
