// SPDX-License-Identifier: MIT
// A state file, for a scene of two bodies: what is taken is written and read again to the same bits.
#include "sim/scene/scene.h"
#include "sim/trace/trace.h"
#include "tests/fuzz/fuzz.h"

using namespace pabd;

PABD_FUZZ_TARGET(state, bytes) {
  static const Scene scene = parse_scene(
      R"({"format": "pabd-scene", "version": 1, "bodies": [
           {"name": "ground", "shape": {"type": "plane", "normal": [0, 1, 0], "offset": 0}, "fixed": true},
           {"name": "crate", "shape": {"type": "box", "size": [1, 1, 1]}, "position": [0, 2, 0]}]})",
      "scene.json", "/nowhere");
  fuzz::accepts([&] {
    const State state = state_from_json(scene.model, std::string(bytes), "state.json");
    const std::string text = state_to_json(scene.model, state);
    fuzz::require(state_hash(state_from_json(scene.model, text, "state.json")) == state_hash(state),
                  "a state that is written is read back to the same bits");
  });
}
