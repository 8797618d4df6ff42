// SPDX-License-Identifier: MIT
// Whatever GPU there is, software too, makes the steps of runs that ask for one (solver.device), beside who draws them.
#pragma once

#include <memory>
#include <utility>

#include "app/session/step_devices.h"
#include "render/device/split_engine.h"

namespace pabd::test {

class GpuSteps : public StepDevices {
 public:
  explicit GpuSteps(std::shared_ptr<SharedContext> drawing) : drawing_(std::move(drawing)) {}
  Answer decide(const Model&, const Params&, const State&) const override {
    Answer answer;
    answer.device = true;
    answer.name = "the GPU";
    return answer;
  }
  std::shared_ptr<StepEngine> open() const override {
    return std::make_shared<SplitEngine>(Backend::automatic, drawing_.get());
  }

 private:
  std::shared_ptr<SharedContext> drawing_;
};

}  // namespace pabd::test
