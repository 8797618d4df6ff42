// SPDX-License-Identifier: MIT
// --device: who makes the time steps.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/common.h"
#include "app/session/run.h"
#include "app/session/step_devices.h"
#include "render/device/shared_context.h"
#include "render/device/split_engine.h"

namespace pabd::cli {

// From so many bodies that move a GPU is several times as quick as a processor (tests/bench/README.md).
inline constexpr Index kFewestOnGpu = 10'000;

// `device` stays empty where it is not given: what the scene says ("solver.device") holds.
CLI::Option* add_device_option(const Command& command, std::string& device);

// One run: what is to be computed. All outlive the call.
struct DeviceTask {
  const Model* model;
  const Params* params;
  const State* state;  // where it begins
};

struct DeviceChoice {
  bool gpu = false;
  std::string name = "cpu";  // of the GPU, where it is one
  std::string why;           // --device auto: why the processor
  bool left_to = false;      // auto: the processor takes over where the GPU cannot go on
  double preparing = 0;      // of prepare_on_device(): what the engine compiled before the first step took; s

  // For the end of a line: " · steps by NAME" or why not; empty where the processor was asked for.
  std::string words() const;
  // Of a run; null: the processor.
  std::shared_ptr<StepEngine> engine(Backend backend) const;
};

// What a GPU would take here: opens a context. Throws Error(no_context).
using FindCapacity = std::function<DeviceCapacity()>;

// Who does all of the tasks, which tell what is `wanted` of their reports: by `option`, or where it is empty by their
// parameters, which then ask for the same. `source`: the scene, for messages, or empty. With "gpu" throws Error(bad_input) where
// it does not take one, and Error(no_context) where there is none.
DeviceChoice choose_device(const std::string& option, const FindCapacity& find, const std::string& source,
                           const std::vector<DeviceTask>& tasks, const StepOptions& wanted);
DeviceChoice choose_device(const std::string& option, Backend backend, const std::string& source,
                           const std::vector<DeviceTask>& tasks, const StepOptions& wanted);

// The same for a session, which gets its engine and is ready to make the first step.
DeviceChoice prepare_on_device(const std::string& option, const std::string& source, Session& session,
                               const StepOptions& wanted);

// Of runs in step: of all, or of each where their parameters ask for different ones.
struct DeviceChoices {
  std::vector<DeviceChoice> of;  // one, or one a run

  const DeviceChoice& run(std::size_t k) const { return of[k < of.size() ? k : 0]; }
  std::string words() const;  // of all, as above
};

DeviceChoices choose_devices(const std::string& option, Backend backend, const std::string& source,
                             const std::vector<Run>& runs, const StepOptions& wanted);
// The runs have the engines that were chosen.
void solve_by(const DeviceChoices& choices, Backend backend, std::vector<Run>& runs);

// The GPU as what a program offers to runs that change while they are made: the window's. Looks for it when it is first
// asked for, once. `drawing`: what who draws the run lends to it (not null).
std::shared_ptr<const StepDevices> gpu_devices(Backend backend, std::shared_ptr<SharedContext> drawing);

// Why "auto" leaves so many bodies that move to the processor; empty: it does not.
std::string why_processor(Index moving, const DeviceCapacity& capacity);

}  // namespace pabd::cli
