// SPDX-License-Identifier: MIT
// Who makes the steps of a run: this processor (time_step.h), or a device that a program brings.
#pragma once

#include <memory>
#include <string>

#include "sim/solver/time_step.h"

namespace pabd {

// Where bodies were after a step, kept by the device that made it: who knows that device draws from it, as long as it
// likes, in any thread.
class PoseCopy {
 public:
  virtual ~PoseCopy() = default;
};

// What it makes differs from what step() makes by its rounding, and by no more than the tolerance of a solve. One
// thread at a time may call it, not always the same.
class StepEngine {
 public:
  virtual ~StepEngine() = default;

  virtual std::string name() const = 0;  // of the device, as its driver says it

  // What the first step would begin with, such as compiling for the model. Throws as step().
  virtual void prepare(const Model& model, const Params& params, const StepOptions& options,
                       const State& state) = 0;

  // As step() of time_step.h, with its preconditions. It may leave the memory of contacts out of `state`, as long as
  // it has it itself for the next step: complete(). Of options.bodies_stay it may leave out where bodies are and how they
  // move as well, which are then those of a step before; after one that is not finite they are lost.
  // Throws Error(bad_input), with the remedy, where it does not take the model, the parameters or what is asked of
  // the report, and Error(no_context) when the device is lost; the state is then as it was.
  virtual void step(const Model& model, const Params& params, const StepOptions& options, State& state,
                    StepReport& report) = 0;

  // Puts in what step() omitted. Precondition: `state` is that of the last step, or another that is complete.
  virtual void complete(State& state) = 0;

  // Whether it lets bodies of the model stay, and copy_poses() gives something then.
  virtual bool keeps_bodies(const Model&) const { return false; }
  // Of bodies after the last step. Precondition: keeps_bodies(), and a step was made. Throws as step().
  virtual std::shared_ptr<const PoseCopy> copy_poses() { return nullptr; }

  // The model comes to an end, or another one will be where it is: to be called before.
  virtual void forget() = 0;
};

}  // namespace pabd
