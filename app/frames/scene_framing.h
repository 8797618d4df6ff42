// SPDX-License-Identifier: MIT
// What a picture of a scene has to show: its bodies, and where they go.
#pragma once

#include <memory>
#include <vector>

#include "app/session/frame_view.h"
#include "render/visual/framing.h"
#include "sim/scene/scene.h"

namespace pabd {

// Time that is looked ahead where nobody says how long a run is to be; s.
inline constexpr double kLookAhead = 5;

// From which side the scene wants to be seen, and with which field of view; how far away is for framing to say.
Camera side_of(const Scene& scene);

// What is to be seen of `start` and of `seconds` after it. A run ahead finds it, with steps that are long enough
// for that to be quick; it ends early where there are many bodies: then what is still falling is told by the floor
// below it. Bodies that leave for good count only where they start.
std::vector<Spot> spots_ahead(const std::shared_ptr<const Scene>& scene, const FrameView& start,
                              double seconds);

// The camera of a scene at its start, for pictures without a run.
Camera scene_camera(const Scene& scene, double aspect);

}  // namespace pabd
