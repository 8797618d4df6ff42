// SPDX-License-Identifier: MIT
// A device with a fallback: when it fails, the processor makes that step and all later ones.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "sim/base/error.h"
#include "sim/solver/step_engine.h"

namespace pabd {

class YieldingEngine : public StepEngine {
 public:
  // `engine` is not null; `tell` is called once, with the reason of the failure.
  YieldingEngine(std::shared_ptr<StepEngine> engine, std::function<void(const std::string& why)> tell)
      : engine_(std::move(engine)), tell_(std::move(tell)), name_(engine_->name()) {}

  std::string name() const override { return name_; }
  void prepare(const Model& model, const Params& params, const StepOptions& options,
               const State& state) override {
    if (engine_) engine_->prepare(model, params, options, state);
  }
  void step(const Model& model, const Params& params, const StepOptions& options, State& state,
            StepReport& report) override {
    if (engine_) {
      try {
        return engine_->step(model, params, options, state, report);
      } catch (const Error& error) {
        tell_(error.what());
      }
      give_way(state);
    }
    pabd::step(model, params, options, state, workspace_, report);
  }
  void complete(State& state) override {
    if (engine_) engine_->complete(state);
  }
  void forget() override {
    if (engine_) engine_->forget();
  }

 private:
  void give_way(State& state) {
    try {
      engine_->complete(state);
    } catch (const Error&) {  // the memory of contacts is lost: friction starts from zero
    }
    engine_.reset();
  }

  std::shared_ptr<StepEngine> engine_;  // null after a failure
  std::function<void(const std::string&)> tell_;
  std::string name_;
  StepWorkspace workspace_;
};

}  // namespace pabd
