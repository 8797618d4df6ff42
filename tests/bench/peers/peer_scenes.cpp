// SPDX-License-Identifier: MIT
#include "tests/bench/peers/peer_scenes.h"

#include "sim/base/error.h"

namespace pabd::peers {

namespace {

enum class Stage { ground, air, bridge };  // with the ground; without; with planks

struct Entry {
  const char* name;
  const char* generate = "";  // entries of the scene file's "generate"
  Stage stage = Stage::ground;
  bool has_top = false;
  SceneFor engines = SceneFor::all;
  const char* more = "";  // other members of the scene file
  int steps = kSteps;
  std::string (*members)() = nullptr;  // in place of `generate` and what belongs to the stage
};

// A new scene is one line here; bodies that the generators do not make can be written out in the same way.
// "touching" has no gap between levels: peers rest at d = 0, this project inside d̂. "heavy": the last link
// of a chain weighs as much as 100 others; a link is 1 m long and weighs 10 kg.
constexpr Entry kEntries[] = {
    {"pyramid_210", R"({"type": "pyramid", "base": 20, "size": [1, 0.5, 0.5]})", Stage::ground, true},
    {"pyramid_210_touching", R"({"type": "pyramid", "base": 20, "size": [1, 0.5, 0.5], "gap": 0})",
     Stage::ground, true},
    {"wall_400", R"({"type": "wall", "columns": 20, "rows": 20, "size": [1, 0.5, 0.5]})", Stage::ground,
     true},
    {"wall_400_touching", R"({"type": "wall", "columns": 20, "rows": 20, "size": [1, 0.5, 0.5], "gap": 0})",
     Stage::ground, true},
    {"pile_1000", R"({"type": "pile", "count": 1000, "size": [0.6, 0.5, 0.5], "vary": 0.15, "seed": 7})"},
    {"pile_8000", R"({"type": "pile", "count": 8000, "size": [0.6, 0.5, 0.5], "vary": 0.15, "seed": 7})"},
    {.name = "pile_1000_walls", .members = [] { return walled_pile_members(10); }},
    {.name = "pile_8000_walls", .members = [] { return walled_pile_members(20); }},
    {.name = "pile_64000_walls", .members = [] { return walled_pile_members(40); }},
    {"chain_100", R"({"type": "chain", "links": 100})", Stage::air, false, SceneFor::dense},
    {"chain_100_heavy", R"({"type": "chain", "links": 100, "end_mass": 1000})", Stage::air, false,
     SceneFor::dense},
    {"chain_1000", R"({"type": "chain", "links": 1000})", Stage::air, false, SceneFor::dense},
    {"chain_1000_heavy", R"({"type": "chain", "links": 1000, "end_mass": 1000})", Stage::air},
    {"chain_10000", R"({"type": "chain", "links": 10000})", Stage::air},
    {"chain_10000_heavy", R"({"type": "chain", "links": 10000, "end_mass": 1000})", Stage::air},
    {.name = "bridge_50", .stage = Stage::bridge, .engines = SceneFor::dense, .members = bridge_members},
    // 123 × 123 plates of 0.8 m, a joint in the middle of each gap between two: 30,012 joints.
    {.name = "net_30012",
     .generate = R"({"type": "net", "rows": 123, "columns": 123, "size": [0.8, 0.1, 0.8], "gap": 0.2})",
     .stage = Stage::air,
     .steps = 60},
    {.name = "net_100_hubs",
     .stage = Stage::air,
     .steps = 60,
     .members = [] { return hub_net_members(100); }},
    // Their middle is at the origin, since no scene reaches beyond 1000 km.
    {"chain_1076748", R"({"type": "chain", "links": 1076748, "position": [-538374, 0, 0]})", Stage::air,
     false, SceneFor::us_alone, R"("time_step": 0.01, "solver": {"method": "newton", "iterations": 1}, )",
     20},
    {"chain_1076748_two", R"({"type": "chain", "links": 1076748, "position": [-538374, 0, 0]})", Stage::air,
     false, SceneFor::us_alone, R"("time_step": 0.01, "solver": {"method": "newton", "iterations": 2}, )",
     20},
};

constexpr const char* kGround = R"("bodies": [{"name": "ground", "shape": {"type": "plane"}}])";

const Entry& find(const std::string& name) {
  for (const Entry& entry : kEntries) {
    if (name == entry.name) return entry;
  }
  throw Error(ErrorKind::bad_input, "scene '" + name + "': expected one of those that --list prints");
}

SceneKind kind(const Entry& entry) {
  return entry.stage == Stage::ground ? SceneKind::contacts : SceneKind::joints;
}

std::string members(const Entry& entry) {
  if (entry.members) return entry.members();
  const std::string generate = R"("generate": [)" + std::string(entry.generate) + "]";
  return entry.stage == Stage::ground ? kGround + (", " + generate) : generate;
}

}  // namespace

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const Entry& entry : kEntries) names.emplace_back(entry.name);
  return names;
}

SceneKind scene_kind(const std::string& name) { return kind(find(name)); }

SceneFor scene_engines(const std::string& name) { return find(name).engines; }

PeerScene peer_scene(const std::string& name) {
  const Entry& entry = find(name);
  const std::string text = R"({"format": "pabd-scene", "version": 1, "contact": {"friction": 0.5}, )" +
                           std::string(entry.more) + members(entry) + "}";
  PeerScene found{parse_scene(text, name, "."), kind(entry), entry.engines, entry.steps, entry.has_top,
                  entry.stage == Stage::air};
  if (*entry.more == 0) found.scene.params.h = kTimeStep;
  return found;
}

}  // namespace pabd::peers
