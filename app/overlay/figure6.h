// Figure 6 of the supplement: the two boxes and the contact pair whose penetration figure 7 follows.
#pragma once

#include <optional>
#include <string>

#include "render/visual/visual_scene.h"
#include "sim/body/model.h"
#include "sim/body/state.h"
#include "sim/solver/params.h"
#include "sim/solver/report.h"

namespace pabd {

// The deepest contact between two bodies at the poses of `state`; nothing when no pair is within d̂. Its force
// is the barrier's at that distance.
std::optional<ContactReport> deepest_contact(const Model& model, const Params& params, const State& state);

struct Figure6 {
  VisualScene scene;  // bodies, the chosen pair as bond points and normal arrow, labels "y_i", "y_j", "n_i";
                      // camera set
  std::string caption;  // rich text: names of the bodies, d
};
// `aspect`: width / height of the picture.
Figure6 figure6(const Model& model, const Params& params, const State& state, double aspect);

}  // namespace pabd
