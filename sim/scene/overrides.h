// SPDX-License-Identifier: MIT
// `--set contact.kappa=50`: changes a scene document before it is read, so that an override passes the same
// checks as the file. Internal to sim/scene.
#pragma once

#include <string>
#include <vector>

#include "sim/scene/document.h"
#include "sim/scene/reader.h"
#include "sim/solver/parameter_table.h"

namespace pabd {

// Applies "path=value" strings in order. A path names keys and array indices, "contact.kappa",
// "bodies.1.density" or "/bodies/1/density"; a value is JSON, a number with a unit (typed_number.h),
// or a bare word taken as text. A section that the file leaves out
// ("contact", "camera", …) is made. Returns what was set, for messages; throws Error(bad_input) naming the
// part of the path that does not exist.
std::vector<AppliedOverride> apply_overrides(Json& scene, const std::vector<std::string>& overrides,
                                             const std::string& source,
                                             ParameterTable table = parameter_table());

}  // namespace pabd
