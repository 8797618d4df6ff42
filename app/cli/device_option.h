// SPDX-License-Identifier: MIT
// --device: who makes the time steps.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/cli/common.h"
#include "app/session/run.h"
#include "render/device/device_engine.h"

namespace pabd::cli {

// From so many bodies that move a GPU is several times as quick as a processor (tests/bench/README.md).
inline constexpr Index kFewestOnGpu = 10'000;

void add_device_option(CLI::App& command, std::string& device);

// One run: what is to be computed. Both outlive the call.
struct DeviceTask {
  const Model* model;
  const Params* params;
};

struct DeviceChoice {
  bool gpu = false;
  std::string name = "cpu";  // of the GPU, where it is one
  std::string why;           // --device auto: why the processor

  // For the end of a line: " · steps by NAME" or why not; empty where the processor was asked for.
  std::string words() const;
  // Of a run; null: the processor.
  std::shared_ptr<StepEngine> engine(Backend backend) const;
};

// Who does all of the tasks, which tell what is `wanted` of their reports. `source`: the scene, for messages. With
// "gpu" throws Error(bad_input) where it does not take one, and Error(no_context) where there is none.
DeviceChoice choose_device(const std::string& device, Backend backend, const std::string& source,
                           const std::vector<DeviceTask>& tasks, const StepOptions& wanted);

// Chooses for one run or two in step, which have their engines afterwards; `b` may be null.
DeviceChoice solve_on_device(const std::string& device, Backend backend, const std::string& source, Run& a,
                             Run* b, const StepOptions& wanted);

// Why --device auto leaves so many bodies that move to the processor; empty: it does not.
std::string why_processor(Index moving, const DeviceCapacity& capacity);

}  // namespace pabd::cli
