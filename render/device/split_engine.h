// SPDX-License-Identifier: MIT
// The GPU beside the processor in one step: what hangs together by joints, with all that was near it when the run began,
// is the processor's (sim/solver/model_parts.h), the rest the GPU's. Nothing couples the two; where something would, the
// step is refused.
#pragma once

#include <memory>
#include <string>

#include "render/device/device_engine.h"
#include "sim/solver/model_parts.h"

namespace pabd {

class SplitEngine : public StepEngine {
 public:
  // As DeviceEngine::why_not; `state`: where the run begins.
  static std::string why_not(const Model& model, const Params& params, const StepOptions& options,
                             const State& state);
  // Bodies that move and that the GPU would have.
  static Index on_gpu(const Model& model, const Params& params, const State& state);

  // As DeviceEngine.
  explicit SplitEngine(Backend backend, SharedContext* drawing = nullptr) : device_(backend, drawing) {}

  std::string name() const override { return device_.name(); }
  void prepare(const Model& model, const Params& params, const StepOptions& options,
               const State& state) override;
  // Throws Error(bad_input), with the remedy, where bodies of the two parts come near each other; the state is then as
  // it was, and complete() can still be asked for.
  void step(const Model& model, const Params& params, const StepOptions& options, State& state,
            StepReport& report) override;
  void complete(State& state) override;
  bool keeps_bodies(const Model& model) const override {
    return model.joints.empty() && device_.keeps_bodies(model);
  }
  std::shared_ptr<const PoseCopy> copy_poses() override { return device_.copy_poses(); }
  void forget() override;

 private:
  void split(const Model& model, const Params& params, const State& state);

  DeviceEngine device_;
  const Model* model_ = nullptr;  // that parts_ are of
  std::unique_ptr<ModelParts> parts_;
  double left_ = 0;  // time of the state that the last step left
  State jointed_, free_;
  StepWorkspace workspace_;
  StepReport report_;
};

}  // namespace pabd
