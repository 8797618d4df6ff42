// The tunable part of a scene: gravity, time step, solver and contact. Internal to sim/scene.
#pragma once

#include "sim/scene/reader.h"
#include "sim/solver/params.h"

namespace pabd {

// Reads and checks (check_params) the parameters of a scene object.
Params read_params(const ObjectReader& scene);

}  // namespace pabd
