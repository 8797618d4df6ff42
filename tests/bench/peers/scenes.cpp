#include "tests/bench/peers/scenes.h"

#include "sim/error.h"

namespace pabd::peers {

namespace {

struct Entry {
  const char* name;
  const char* generate;  // one entry of the scene file's "generate"
  bool has_top;
};

// A new scene is one line here; bodies that the generators do not make can be written out in the same way.
// "touching" has no gap between levels: peers rest at d = 0, this project inside d̂.
constexpr Entry kEntries[] = {
    {"pyramid_210", R"({"type": "pyramid", "base": 20, "size": [1, 0.5, 0.5]})", true},
    {"pyramid_210_touching", R"({"type": "pyramid", "base": 20, "size": [1, 0.5, 0.5], "gap": 0})", true},
    {"wall_400", R"({"type": "wall", "columns": 20, "rows": 20, "size": [1, 0.5, 0.5]})", true},
    {"wall_400_touching", R"({"type": "wall", "columns": 20, "rows": 20, "size": [1, 0.5, 0.5], "gap": 0})",
     true},
    {"pile_1000", R"({"type": "pile", "count": 1000, "size": [0.6, 0.5, 0.5], "vary": 0.15, "seed": 7})",
     false},
    {"pile_8000", R"({"type": "pile", "count": 8000, "size": [0.6, 0.5, 0.5], "vary": 0.15, "seed": 7})",
     false},
};

}  // namespace

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const Entry& entry : kEntries) names.emplace_back(entry.name);
  return names;
}

PeerScene peer_scene(const std::string& name) {
  for (const Entry& entry : kEntries) {
    if (name != entry.name) continue;
    const std::string text =
        R"({"format": "pabd-scene", "version": 1, "bodies": [{"name": "ground", "shape": {"type": "plane"}}],)"
        R"("contact": {"friction": 0.5}, "generate": [)" +
        std::string(entry.generate) + "]}";
    PeerScene found{parse_scene(text, name, "."), entry.has_top};
    found.scene.params.h = kTimeStep;
    return found;
  }
  throw Error(ExitCode::bad_input, "scene '" + name + "': expected one of those that --list prints");
}

}  // namespace pabd::peers
