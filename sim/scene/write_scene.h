// SPDX-License-Identifier: MIT
// A simulation that is under way as a scene file that loads again.
#pragma once

#include <optional>
#include <string>

#include "sim/scene/scene.h"

namespace pabd {

// The text of a scene file whose start is `state`: every body and joint is listed, with what sticking
// contacts remember; time begins at 0, so drives are shifted. A run from it agrees with one that goes on from
// `state` up to rounding. `joint_law` is that of Scene.
//
// Throws Error(bad_input) in one line when no scene file says the same: shapes from mesh files (which are not
// known here), numbers out of the ranges of scene files. The text is read back before it is returned, so it
// does load.
std::string scene_to_json(const Model& model, const State& state, const Params& params,
                          const BondLaw& joint_law, const std::string& name,
                          const std::optional<CameraDesc>& camera, std::optional<double> duration,
                          ParameterTable table = parameter_table(), const BodyLooks& looks = {});

}  // namespace pabd
