// SPDX-License-Identifier: MIT
// A camera that goes through key frames.
#pragma once

#include <span>

#include "render/visual/camera_control.h"

namespace pabd {

// Where the camera is at a time.
struct CameraKey {
  double time = 0;  // s
  CameraPose pose;
};

// The pose at `time`: through every key at its time, with a continuous speed. What moves evenly from key to
// key stays even, what stands between two equal keys stands still, and nothing swings beyond its keys. The
// eye goes around the target, never through it, and the shorter way round; the horizon is level. Before the
// first and after the last key: that key. `keys` in order of time; of keys at the same time the last counts.
// Without keys: the default pose.
CameraPose camera_at(std::span<const CameraKey> keys, double time);

}  // namespace pabd
