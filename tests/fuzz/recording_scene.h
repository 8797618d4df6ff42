// SPDX-License-Identifier: MIT
// The scene that the recordings of the fuzzer and its seeds belong to.
#pragma once

#include <memory>

#include "sim/scene/scene.h"

namespace pabd::fuzz {

inline std::shared_ptr<const Scene> recording_scene() {
  return std::make_shared<const Scene>(parse_scene(
      R"({"format": "pabd-scene", "version": 1, "name": "fuzz", "solver": {"iterations": 3}, "bodies": [
           {"name": "ground", "shape": {"type": "plane", "normal": [0, 1, 0], "offset": 0}, "fixed": true},
           {"name": "crate", "shape": {"type": "box", "size": [1, 1, 1]}, "position": [0, 0.5, 0]}]})",
      "scene.json", "/nowhere"));
}

}  // namespace pabd::fuzz
