// SPDX-License-Identifier: MIT
// The tunable part of a scene: gravity, time step, solver and contact. Internal to sim/scene.
#pragma once

#include "sim/scene/reader.h"
#include "sim/solver/parameter_table.h"

namespace pabd {

// Reads and checks (check_params) the parameters of a scene object, in the order of the table. What it leaves out has
// the value of `defaults`.
Params read_params(const ObjectReader& scene, ParameterTable table = parameter_table(),
                   const Params& defaults = {});

}  // namespace pabd
