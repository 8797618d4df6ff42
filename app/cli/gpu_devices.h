// SPDX-License-Identifier: MIT
// The GPU as what a program offers to runs that change while they are made: the window's.
#pragma once

#include <memory>

#include "app/session/step_devices.h"
#include "render/context/context.h"
#include "render/device/shared_context.h"

namespace pabd::cli {

// Looks for the GPU when it is first asked for, once. `drawing`: what who draws the run lends to it (not null).
std::shared_ptr<const StepDevices> gpu_devices(Backend backend, std::shared_ptr<SharedContext> drawing);

}  // namespace pabd::cli
