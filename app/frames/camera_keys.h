// SPDX-License-Identifier: MIT
// Key frames of a camera as a file, which the window writes and `pabd render --camera` takes:
//
//   {"format": "pabd-camera", "version": 1, "scene": "pyramid",
//    "keys": [{"time": 0, "eye": [6, 4, 8], "target": [0, 1, 0], "fov": 45}, …]}
//
// Times are those of the simulation in seconds, lengths are metres, angles degrees. "up" is there only where
// the camera looks straight down or up, "ortho": true where its rays are parallel, up to the next key.
#pragma once

#include <string>
#include <vector>

#include "render/visual/camera_path.h"

namespace pabd {

struct CameraKeys {
  std::string scene;            // name of the scene that they were made for
  std::vector<CameraKey> keys;  // in order of time, one a time
};

// With every digit of every number.
std::string camera_keys_json(const CameraKeys& keys);
// Throws Error(bad_input) with `source` and the place.
CameraKeys parse_camera_keys(const std::string& json, const std::string& source);
// The same from a file. Throws Error(file) if it cannot be read.
CameraKeys read_camera_keys(const std::string& path);

// Puts a key in its place; one of the same time (to a microsecond) is replaced.
void add_camera_key(std::vector<CameraKey>& keys, const CameraKey& key);

}  // namespace pabd
