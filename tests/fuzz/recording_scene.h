// SPDX-License-Identifier: MIT
// The scene that the recordings of the fuzzer and its seeds belong to, and the head and checksum around them.
#pragma once

#include <memory>
#include <string>

#include "app/session/record_parts.h"
#include "sim/base/hash.h"
#include "sim/scene/scene.h"

namespace pabd::fuzz {

inline std::shared_ptr<const Scene> recording_scene() {
  return std::make_shared<const Scene>(parse_scene(
      R"({"format": "pabd-scene", "version": 1, "name": "fuzz", "solver": {"iterations": 3}, "bodies": [
           {"name": "ground", "shape": {"type": "plane", "normal": [0, 1, 0], "offset": 0}, "fixed": true},
           {"name": "crate", "shape": {"type": "box", "size": [1, 1, 1]}, "position": [0, 0.5, 0]}]})",
      "scene.json", "/nowhere"));
}

// A recording of this version with that between its head and its checksum.
inline std::string sealed(std::string_view payload) {
  std::string bytes;
  ByteWriter file([&](std::string_view part) { bytes += part; });
  file.raw(kRecordMagic);
  file.u32(kRecordVersion);
  file.u64(payload.size());
  file.raw(payload);
  file.flush();
  Hash64 hash;
  hash.add_text(bytes);
  return bytes + hash.hex();
}

}  // namespace pabd::fuzz
