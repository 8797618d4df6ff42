// SPDX-License-Identifier: MIT
// Orientations of scene files as rotation matrices. Internal to sim/scene.
#pragma once

#include "sim/scene/body_entry.h"

namespace pabd {

// To world. Multiples of 90 degrees about x, y and z are exact. The axis of an AxisAngle has length 1.
Mat3 rotation_of(const spec::Orientation& orientation);

}  // namespace pabd
