// SPDX-License-Identifier: MIT
// The part of a run that asks who makes its steps, and goes back to what others made: see run.h.
#include "app/session/run.h"

#include <fmt/format.h>

namespace pabd {

void Run::offer(std::shared_ptr<const StepDevices> devices) {
  devices_.offer(std::move(devices));
  ask_device();
}

StepDevices::Answer Run::answer(const Params& params) const {
  if (!devices_.offered() || params.solver.device == SolverDevice::cpu) return {};
  return devices_.offered()->decide(model(), params, state());
}

void Run::ask_device() {
  if (devices_.offered()) devices_.ask(shared_model(), params(), state(), pulls_ != nullptr);
}

void Run::give_device_to(Run* other) {
  leave_device();
  if (other) {
    other->leave_device();
    devices_.swap_engines(other->devices_);
  } else {
    devices_.release();
  }
}

// What a device made lies nowhere else as long as the timeline does not want it.
void Run::complete() {
  if (timeline_.budget() == kNoPast || !session_.has_engine()) return;
  if (at_end() && timeline_.back().state) return;  // it came back for that
  if (!bring_back() || !at_end()) return;
  timeline_.put_state(std::make_shared<const State>(session_.state()));
  cursor_ = timeline_.size() - 1;  // the oldest may be forgotten for it
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
      static_cast<StepSummary&>(kept) = timeline_[timeline_.kept(cursor_)].report;
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
  cursor_ = timeline_.kept(cursor_);
  timeline_.branch(cursor_);
  session_.restore(timeline_[cursor_].model, *timeline_.state(cursor_, threads_), std::move(report));
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
  if (timeline_.budget() == kNoPast || !session_.has_engine()) return;
  complete();
  work_with(nullptr);
}

StepStatus Run::make_step() {
  session_.set_pulls(pulls_ ? *pulls_ : std::vector<Pull>{});
  if (!devices_.offered()) return session_.step().status;
  const auto engine = devices_.choose(shared_model(), params(), state(), pulls_ != nullptr);
  if (!engine) {
    leave_device();
    return session_.step().status;
  }
  work_with(engine);
  const bool stay = may_stay_ && !left_ && timeline_.budget() != kNoPast && session_.can_let_bodies_stay();
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
  return contacts_ && timeline_[i - 1].state && devices_.engine() != nullptr &&
         devices_.model() == timeline_[i].model;
}

// A moment is reached by the step that led to it, so that its report is whole. To the next moment no state is
// looked up: this one is where the session is. What a device made is what it was; where it can make the step again, that
// tells of the contacts, to the tolerance of a solve.
void Run::go_to(std::size_t i) {
  const Moment& m = timeline_[i];
  const bool first = i == 0 || m.start;
  const bool again = !first && !m.device && timeline_.kept(i - 1) == i - 1;
  leave_device();
  session_.set_pulls({});
  if (again) {
    if (i != cursor_ + 1) session_.restore(m.model, *timeline_.state(i - 1, threads_));
    session_.set_params(m.params);
    session_.set_pulls(m.pulls ? *m.pulls : std::vector<Pull>{});
    session_.step();
    return;
  }
  if (first) {
    session_.set_params(m.params);
    return session_.restore(m.model, *timeline_.state(i, threads_));
  }
  StepReport made;
  if (m.device && tells_again(i)) {
    session_.restore(m.model, *timeline_[i - 1].state);
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
  session_.restore(m.model, *timeline_.state(i, threads_), std::move(made));
}

}  // namespace pabd
