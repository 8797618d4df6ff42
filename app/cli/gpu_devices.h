// SPDX-License-Identifier: MIT
// The GPU as what a program offers to runs that change while they are made: the window's.
#pragma once

#include <memory>

#include "app/session/step_devices.h"
#include "render/context/context.h"

namespace pabd::cli {

// Looks for the GPU when it is first asked for, once.
std::shared_ptr<const StepDevices> gpu_devices(Backend backend);

}  // namespace pabd::cli
