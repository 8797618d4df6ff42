// SPDX-License-Identifier: MIT
// Who makes the steps of a run: this processor (time_step.h), or a device that a program brings.
#pragma once

#include <memory>
#include <string>

#include "sim/solver/time_step.h"

namespace pabd {

// Where bodies were after a step, in memory of the device that made it. A renderer that knows the device draws from it, in any
// thread.
class PoseCopy {
 public:
  virtual ~PoseCopy() = default;
};

// Its steps differ from those of step() by rounding and by no more than the tolerance of a solve. To be called by one thread at
// a time.
class StepEngine {
 public:
  virtual ~StepEngine() = default;

  virtual std::string name() const = 0;  // of the device, as its driver says it

  // Does what the first step would have to do, such as compiling for the model. Throws as step().
  virtual void prepare(const Model& model, const Params& params, const StepOptions& options,
                       const State& state) = 0;

  // As step() of time_step.h, with its preconditions, but the memory of contacts may stay with the device until complete(). With
  // options.bodies_stay so may poses and velocities: those in `state` are then of an earlier step. After a step that is not
  // finite they are lost.
  // Throws Error(bad_input), with the remedy, where it does not take the model, the parameters or what is asked of
  // the report, and Error(no_context) when the device is lost; the state is then as it was.
  virtual void step(const Model& model, const Params& params, const StepOptions& options, State& state,
                    StepReport& report) = 0;

  // Fills in what step() omitted. Precondition: `state` is that of the last step, or complete.
  virtual void complete(State& state) = 0;

  // Does it keep bodies of the model (options.bodies_stay), so that copy_poses() is not null?
  virtual bool keeps_bodies(const Model&) const { return false; }
  // Of bodies after the last step. Precondition: keeps_bodies(), and a step was made. Throws as step().
  virtual std::shared_ptr<const PoseCopy> copy_poses() { return nullptr; }

  // To be called before the model is destroyed or replaced in place.
  virtual void forget() = 0;
};

}  // namespace pabd
