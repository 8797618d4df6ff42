// SPDX-License-Identifier: MIT
// Who makes the next step of a run: the parameters (solver.device) ask for a device, and the answer is renewed whenever
// they or the model change.
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
    std::string why;      // the processor makes them, in one line; empty where that was asked for
    bool refused =
        false;  // a device was demanded (not "auto") and cannot take the model; `kind` is the error then
    ErrorKind kind = ErrorKind::bad_input;
  };

  virtual ~StepDevices() = default;

  // Who would make steps of the model from that state on. Linear in the number of bodies.
  virtual Answer decide(const Model& model, const Params& params, const State& state) const = 0;
  // Throws Error(no_context).
  virtual std::shared_ptr<StepEngine> open() const = 0;
};

struct DeviceStatus {
  std::string name;  // of the device; empty: the processor
  std::string why;   // the processor makes the steps although a device was asked for; one line
  bool operator==(const DeviceStatus&) const = default;
};

// The device of one run, open as long as it is wanted.
class DeviceSwitch {
 public:
  void offer(std::shared_ptr<const StepDevices> devices) { devices_ = std::move(devices); }
  const std::shared_ptr<const StepDevices>& offered() const { return devices_; }

  // Updates status(). Steps with `hands` are the processor's; the device stays open for later ones.
  void ask(const std::shared_ptr<const Model>& model, const Params& params, const State& state, bool hands);
  // As ask(), and opens the device; null: the processor.
  std::shared_ptr<StepEngine> choose(const std::shared_ptr<const Model>& model, const Params& params,
                                     const State& state, bool hands);
  // The device failed: the processor makes the steps until the parameters ask for the processor.
  void fail(const std::string& why);
  // Closes the device.
  void release();

  const DeviceStatus& status() const { return status_; }
  // The open device, also while the processor makes a step; null: none.
  const std::shared_ptr<StepEngine>& engine() const { return engine_; }
  // The model that the device may know.
  const std::shared_ptr<const Model>& model() const { return model_; }

 private:
  std::shared_ptr<const StepDevices> devices_;
  std::shared_ptr<StepEngine> engine_;
  std::shared_ptr<const Model> model_;  // of the answer; alive as long as the engine knows it
  Params params_;                       // of the answer
  StepDevices::Answer answer_;
  std::string failure_;
  DeviceStatus status_;
};

}  // namespace pabd
