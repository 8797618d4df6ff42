// SPDX-License-Identifier: MIT
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
// is the barrier's at that distance. Of several that are equally deep the one nearest to `from` is taken.
std::optional<ContactReport> deepest_contact(const Model& model, const Params& params, const State& state,
                                             const Vec3& from = Vec3::Zero());

struct Figure6 {
  VisualScene
      scene;  // bodies i and j as glass, what boxes have in common shaded, the chosen pair as two points, its
              // normal as an arrow, a scale of 0.1 m along it, labels; camera set
  std::string caption;  // rich text: names of the bodies, d
};
// `camera` of the scene, or null for one that frames the bodies at `aspect` = width / height.
Figure6 figure6(const Model& model, const Params& params, const State& state, double aspect,
                const Camera* camera = nullptr);

}  // namespace pabd
