// SPDX-License-Identifier: MIT
// Figure 2 of the supplement: the three lower pairs slider, hinge and spherical joint.
#pragma once

#include "render/visual/visual_scene.h"

namespace pabd {

// A studio with the three side by side, each with its bond points as expand() gives them, arrows along its
// degrees of freedom, and its name. The camera suits a frame of aspect width / height.
VisualScene figure2(double aspect);

}  // namespace pabd
