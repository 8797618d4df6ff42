// SPDX-License-Identifier: MIT
// Who makes the next step of a run, where a program offers devices beside the processor: asked for by the parameters
// (solver.device), answered anew whenever they or the model have changed.
#pragma once

#include <memory>
#include <string>

#include "sim/base/error.h"
#include "sim/body/model.h"
#include "sim/body/state.h"
#include "sim/solver/params.h"
#include "sim/solver/step_engine.h"

namespace pabd {

// What a program offers. Any thread may call it.
class StepDevices {
 public:
  struct Answer {
    bool device = false;  // it makes the steps; else the processor
    std::string name;     // of the device
    std::string why;      // the processor, in one line; empty where it was asked for
    // A device was asked for, not left to choose: what a refusal is.
    bool refused = false;
    ErrorKind kind = ErrorKind::bad_input;
  };

  virtual ~StepDevices() = default;

  // For steps of the model with these parameters from that state on. Linear in the number of bodies.
  virtual Answer decide(const Model& model, const Params& params, const State& state) const = 0;
  // Throws Error(no_context).
  virtual std::shared_ptr<StepEngine> open() const = 0;
};

struct DeviceStatus {
  std::string name;  // of the device; empty: the processor
  std::string why;   // the processor, where a device was asked for or might have done it; one line
  bool operator==(const DeviceStatus&) const = default;
};

// Of one run: its answer, and its device as long as that is wanted.
class DeviceSwitch {
 public:
  void offer(std::shared_ptr<const StepDevices> devices) { devices_ = std::move(devices); }
  const std::shared_ptr<const StepDevices>& offered() const { return devices_; }

  // Who makes the next step: status(). `hands` are on bodies, which devices do not take: they keep what they have for
  // afterwards.
  void ask(const std::shared_ptr<const Model>& model, const Params& params, const State& state, bool hands);
  // The same, with the device open; null: the processor.
  std::shared_ptr<StepEngine> choose(const std::shared_ptr<const Model>& model, const Params& params,
                                     const State& state, bool hands);
  // The device failed: the processor goes on until another one than it is asked for.
  void fail(const std::string& why);
  // Nothing is held any more, until a device is chosen again.
  void release();

  // Of the last answer.
  const DeviceStatus& status() const { return status_; }
  // The device that is open, also while the processor makes a step; null: none.
  const std::shared_ptr<StepEngine>& engine() const { return engine_; }
  // That the device may know.
  const std::shared_ptr<const Model>& model() const { return model_; }

 private:
  std::shared_ptr<const StepDevices> devices_;
  std::shared_ptr<StepEngine> engine_;
  std::shared_ptr<const Model> model_;  // of the answer; what the engine knows stays where it is
  Params params_;                       // of the answer
  StepDevices::Answer answer_;
  std::string failure_;
  DeviceStatus status_;
};

}  // namespace pabd
