// SPDX-License-Identifier: MIT
// See step_devices.h.
#include "app/session/step_devices.h"

#include <utility>

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

void DeviceSwitch::swap_engines(DeviceSwitch& other) {
  std::swap(engine_, other.engine_);
  std::swap(model_, other.model_);
  std::swap(params_, other.params_);
  std::swap(answer_, other.answer_);
  std::swap(failure_, other.failure_);
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

}  // namespace pabd
