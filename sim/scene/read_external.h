// SPDX-License-Identifier: MIT
// "force" and "torque" of a body. Internal to sim/scene.
#pragma once

#include "sim/body/external_force.h"
#include "sim/scene/reader.h"

namespace pabd {

// Empty where the body has neither. A fixed one may have none.
std::optional<ExternalForce> read_external(const ObjectReader& in, bool fixed);

}  // namespace pabd
